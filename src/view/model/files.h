// Files to open, found while their path is typed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

}  // namespace saddle
