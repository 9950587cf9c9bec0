#include "view/model/files.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ostream>
#include <tuple>

#include "base/file.h"
#include "export/formats/load_scene.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 300;

bool begins_with(const std::string& name, const std::string& typed) {
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  return name.size() >= typed.size() && std::equal(typed.begin(), typed.end(), name.begin(), same);
}

}  // namespace

fs::path typed_path(const std::string& typed) {
  const char* const home = std::getenv("HOME");
  return typed.starts_with("~/") && home != nullptr ? fs::path(home) / typed.substr(2)
                                                    : fs::path(typed);
}

std::vector<FoundFile> find_files(const std::string& typed) {
  const std::size_t slash = typed.rfind('/');
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  const std::string folder = typed.substr(0, begin);
  const std::string rest = typed.substr(begin);
  std::vector<FoundFile> found;
  std::error_code error;
  const fs::path where = folder.empty() ? fs::path(".") : typed_path(folder);
  for (fs::directory_iterator entry(where, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (!begins_with(name, rest) || (name.starts_with('.') && rest.empty())) continue;
    std::error_code ignored;
    const bool is_folder = entry->is_directory(ignored);
    if (!is_folder && !has_scene_extension(entry->path())) continue;
    found.push_back({folder + name + (is_folder ? "/" : ""), is_folder});
  }
  std::ranges::sort(found, [](const FoundFile& a, const FoundFile& b) {
    return std::tuple(!a.is_folder, a.path) < std::tuple(!b.is_folder, b.path);
  });
  found.resize(std::min(found.size(), kMostFiles));
  return found;
}

std::filesystem::path free_file_name(const std::string& title, const std::string& extension) {
  std::string stem;
  for (const char c : title) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    stem += plain ? c : '-';
  }
  if (stem.empty()) stem = "saddle";
  std::filesystem::path path = stem + extension;
  for (int i = 2; std::filesystem::exists(path); ++i) {
    path = stem + "-" + std::to_string(i) + extension;
  }
  return path;
}

std::filesystem::path save_scene(const Scene& scene) {
  auto path = free_file_name(scene.title, ".toml");
  const std::string text = write_scene(scene);
  write_file_whole(path, [&](std::ostream& out) { out << text; });
  return path;
}

}  // namespace saddle
