// The files that a run writes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/cli.h"
#include "base/image.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

namespace saddle {

enum class Format { Png, Ply, Toml };

struct Output {
  std::string path;  ///< "-": standard output
  Format format = Format::Png;
};

/// Nothing is to be written: the command line asks for the viewer.
bool wants_viewer(const CommandLine& line);

/// The outputs of the command line, checked before anything is computed. Throws Error: Input for
/// an unknown extension, a terminal, two things for standard output; Machine for a path that
/// cannot be written, the report's included.
std::vector<Output> checked_outputs(const CommandLine& line);

/// Writes one output. `image` is empty unless it is needed; the scene goes into the PNG.
void write_output(const Output& output, const Image& image, const Scene& scene,
                  std::span<const Mesh> meshes);

}  // namespace saddle
