// The parts of a scene that a file does not have, and files that their readers may not like: from
// the table of formats and the meshes.
#pragma once

#include <string>
#include <vector>

#include "export/common/content.h"
#include "export/formats/formats.h"

namespace saddle {

/// Something that a file lacks, or that its readers may not like.
struct Loss {
  enum class Kind { LeftOut, Lines, Open, Rounded, Flattened, Units, Heavy };
  Kind kind;
  std::string text;  ///< "the colours of --color are left out; .ply has them"
};

/// The losses of writing these meshes in this format. Throws Error (Nothing) if it has room for
/// nothing of the scene.
std::vector<Loss> losses_of(const Format& format, const MeshContent& content);

/// The same of a page or a figure.
std::vector<Loss> losses_of(const Format& format, const PageContent& content);

/// The factor from the scene's units to the file's, by the scene's print size.
double factor_of(const Format& format, const MeshContent& content);

}  // namespace saddle
