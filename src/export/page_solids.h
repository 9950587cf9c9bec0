// Solids on pages.
#pragma once

#include <vector>

#include "export/page_code.h"

namespace saddle {

/// Makes surfaces of their own of the parts of solids, each with one material on both sides. Their
/// meshes have Mesh::solid still; the first one has the lines and the label. `meshes`: empty; keeps
/// what page.meshes is afterwards.
void split_solids(PageScene& page, std::vector<Mesh>& meshes);

/// The scene whose formulas no slider moves: a page has no way to make solids.
Scene without_sliders(Scene scene);

}  // namespace saddle
