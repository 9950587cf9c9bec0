// Files by their names: those to open, found while their path is typed, and new ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

struct FoundFile {
  std::string path;  ///< as it would be typed; of a folder with a '/' at its end
  bool is_folder = false;
};

/// The folders, then the files that may carry a scene, whose paths begin with what was typed,
/// whatever the case of the last letters; hidden ones only if they are asked for. `~/` is the home
/// directory. No more than some hundred.
std::vector<FoundFile> find_files(const std::string& typed);

/// The path with the home directory in place of `~/`.
std::filesystem::path typed_path(const std::string& typed);

/// "torus.png" of a title and ".png", or the first of "torus-2.png" ... that does not exist.
std::filesystem::path free_file_name(const std::string& title, const std::string& extension);

/// Writes a scene file into the current folder: TITLE.toml, or the first of TITLE-2.toml ... that
/// does not exist. Returns its name. Throws Error (Machine) if it cannot be written.
std::filesystem::path save_scene(const Scene& scene);

}  // namespace saddle
