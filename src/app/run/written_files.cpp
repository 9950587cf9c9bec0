#include "app/run/written_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <unordered_map>

#include "app/report/reference.h"
#include "base/error.h"
#include "base/file.h"

namespace saddle {
namespace {

/// Each file that a run writes, under the name that it has when all links are followed.
class WrittenFiles {
 public:
  /// False if something else has this name, too.
  bool add(const std::string& path, const void* what) {
    const auto [place, is_new] = files_.emplace(full_path(path), what);
    return is_new || place->second == what;
  }

 private:
  /// Links are followed: of a folder once, and of a file where there is one.
  std::string full_path(const std::string& path) {
    std::error_code ignored;  // a path that cannot be looked up is refused elsewhere
    const std::filesystem::path given(path);
    const std::string parent = given.parent_path().string();
    auto folder = folders_.find(parent);
    if (folder == folders_.end()) {
      const auto absolute = std::filesystem::absolute(parent.empty() ? "." : parent, ignored);
      folder = folders_.emplace(parent, std::filesystem::weakly_canonical(absolute, ignored)).first;
    }
    const std::filesystem::path file = folder->second / given.filename();
    if (!std::filesystem::is_symlink(file, ignored)) return file.string();
    // The link may lead to a file that is not there yet.
    const std::filesystem::path target = follow_links(file);
    return target == file ? file.string() : full_path(target.string());
  }

  std::map<std::string, std::filesystem::path> folders_;
  std::unordered_map<std::string, const void*> files_;
};

constexpr const char* kWayOut = "give each its own name";

/// `./a.png` is a.png.
std::string plain_path(const Output& output) {
  return std::filesystem::path(output.path).lexically_normal().string();
}

/// The first of the outputs with this one's content and name: the later ones add nothing.
const Output* first_alike(const std::vector<Output>& outputs, const Output& output) {
  return &*std::ranges::find_if(outputs, [&](const Output& other) {
    return plain_path(other) == plain_path(output) && other.format == output.format;
  });
}

void add_file(WrittenFiles& files, const std::string& path, const void* what) {
  if (files.add(path, what)) return;
  throw Error(Status::Input, "two outputs are called " + path, {}, kWayOut);
}

/// Calls `with` for each frame of a numbered output, else once.
template <typename With>
void for_each_frame(const Output& output, std::span<const int> frames, With with) {
  if (!output.number) return with(0);
  for (const int frame : frames) with(frame);
}

void add_files_beside(WrittenFiles& files, const CommandLine& line, const Output& output, int frame,
                      const Output* what) {
  const std::vector<std::string> all = output.files_of(frame);
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (!is_input(line, all[i]) && files.add(all[i], what)) continue;
    throw Error(Status::Input,
                all[0] + " also writes " + all[i] + ", which is another file of this run", {},
                kWayOut);
  }
}

}  // namespace

void check_names_differ(const CommandLine& line, const std::vector<Output>& outputs,
                        std::span<const int> frames) {
  WrittenFiles files;
  for (const Output& output : outputs) {
    if (output.path == "-") continue;
    for_each_frame(output, frames, [&](int frame) {
      add_file(files, output.path_of(frame), first_alike(outputs, output));
    });
  }
  const std::string difference = difference_path(line.run.reference);
  if (!difference.empty()) add_file(files, difference, &line.run.reference);
  const std::string& report = line.run.report;
  if (!report.empty() && report != "-") add_file(files, report, &report);
  for (const Output& output : outputs) {
    if (output.path == "-" || output.format->beside.empty()) continue;
    for_each_frame(output, frames, [&](int frame) {
      add_files_beside(files, line, output, frame, first_alike(outputs, output));
    });
  }
}

}  // namespace saddle
