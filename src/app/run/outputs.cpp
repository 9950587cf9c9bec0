// Formats by extension, standard output as `-`.
#include "app/run/outputs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <unordered_map>

#include "app/report/reference.h"
#include "base/error.h"
#include "base/file.h"
#include "base/nearest.h"
#include "base/standard_streams.h"

namespace saddle {
namespace {

std::string known_formats(const std::string& word) {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.emplace_back(format.extension);
  const auto nearest = nearest_name(word, names);
  return "known: " + extension_list() + (nearest ? "; did you mean '." + *nearest + "'?" : "");
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Most bytes of a frame's number in a path: `%09d`, digits enough for kMaxFrames.
constexpr std::size_t kLongestNumber = 4;

/// The first `%d`, `%4d` or `%04d` from `begin` on.
std::optional<Span> find_number(const std::string& path, std::size_t begin) {
  for (std::size_t at = path.find('%', begin); at != std::string::npos;
       at = path.find('%', at + 1)) {
    std::size_t end = at + 1;
    while (end < path.size() && is_digit(path[end])) ++end;
    if (end < path.size() && path[end] == 'd') return Span{at, end + 1};
    if (path.compare(at, 2, "%%") == 0) ++at;  // a percent sign
  }
  return std::nullopt;
}

/// Where a file's name begins in a path.
std::size_t name_in(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? 0 : slash + 1;
}

/// Where the file's name has the number of a frame. Throws Error (Input) for two of them.
std::optional<Span> checked_number(const std::string& path) {
  const auto number = find_number(path, name_in(path));
  if (!number) return std::nullopt;
  if (const auto second = find_number(path, number->end)) {
    throw Error(Status::Input, "two places for the frame's number", {"--output", path, *second},
                "one is enough, for example frame-%04d.png; %% is a percent sign");
  }
  if (number->end - number->begin > kLongestNumber) {
    throw Error(Status::Input, "the frame's number has too many digits",
                {"--output", path, *number}, "for example frame-%04d.png");
  }
  return number;
}

/// The file's name with a percent sign for each two of them.
void unescape(Output& output) {
  std::string& path = output.path;
  for (std::size_t at = name_in(path); (at = path.find("%%", at)) != std::string::npos; ++at) {
    path.erase(at, 1);
    if (output.number && at < output.number->begin) {
      --output.number->begin;
      --output.number->end;
    }
  }
}

/// The format that --format names; nullptr without it.
const Format* checked_format(const std::string& name) {
  if (name.empty()) return nullptr;
  const Format* const format = find_format(name);
  if (format == nullptr) {
    throw Error(Status::Input, "unknown format '" + name + "'",
                {"--format", name, {0, name.size()}}, known_formats(name));
  }
  return format;
}

/// `fallback`: the format of a path without an extension, or nullptr.
const Format* format_of(const std::string& path, const Format* fallback) {
  const std::string ending = path == "-" ? "" : extension_of(path);
  if (const Format* format = find_format(ending)) return format;
  if (fallback != nullptr && ending.empty()) return fallback;
  if (path == "-") {
    throw Error(Status::Input, "the format for standard output is missing",
                {"--output", path, {0, 1}}, "add --format " + format_list());
  }
  throw Error(
      Status::Input,
      ending.empty() ? "no extension says what to write" : "unknown extension '." + ending + "'",
      {"--output", path, {path.size() - std::min(path.size(), ending.size() + 1), path.size()}},
      known_formats(ending));
}

void check_format_is_used(const CommandLine& line) {
  const auto uses_format = [](const std::string& path) {
    return path == "-" || extension_of(path).empty();
  };
  if (line.run.format.empty() || std::ranges::any_of(line.run.outputs, uses_format)) return;
  throw Error(Status::Input, "no output needs a format", {"--format", line.run.format, {}},
              "--format is for -o - and for names without an extension");
}

void check_standard_output(const CommandLine& line) {
  const auto outputs = std::ranges::count(line.run.outputs, "-");
  if (outputs + (line.run.report == "-" ? 1 : 0) > 1) {
    throw Error(Status::Input, "only one thing can go to standard output", {},
                "give the others a file");
  }
  if (outputs == 1 && standard_output_is_terminal()) {
    throw Error(Status::Input, "pictures and meshes are not written to a terminal",
                {"--output", "-", {0, 1}}, "redirect standard output, or name a file");
  }
}

/// A report in place of something that the run reads would be lost work.
void check_report_replaces_no_input(const CommandLine& line) {
  if (!is_input(line, line.run.report)) return;
  throw Error(Status::Input, "the run reads this file",
              {"--report", line.run.report, {0, line.run.report.size()}},
              "give the report a name of its own");
}

}  // namespace

std::string Output::path_of(int frame) const {
  if (!number) return path;
  const std::string width = path.substr(number->begin + 1, number->end - number->begin - 2);
  std::string digits = std::to_string(frame);
  const std::size_t wanted = width.empty() ? 0 : std::stoul(width);
  if (digits.size() < wanted) digits.insert(0, wanted - digits.size(), '0');
  return path.substr(0, number->begin) + digits + path.substr(number->end);
}

namespace {

/// Each file that a run writes, under the name that it has when all links are followed.
class WrittenFiles {
 public:
  /// Throws Error (Input) if something else has this name, too.
  void add(const std::string& path, const void* what) {
    const auto [place, is_new] = files_.emplace(full_path(path), what);
    if (is_new || place->second == what) return;
    throw Error(Status::Input, "two outputs are called " + path, {}, "give each its own name");
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

/// The first of the outputs with this one's content and name: the later ones add nothing.
const Output* first_alike(const std::vector<Output>& outputs, const Output& output) {
  return &*std::ranges::find_if(outputs, [&](const Output& other) {
    return other.path == output.path && other.format == output.format;
  });
}

}  // namespace

void check_names_differ(const CommandLine& line, const std::vector<Output>& outputs,
                        std::span<const int> frames) {
  WrittenFiles files;
  for (const Output& output : outputs) {
    if (output.path == "-") continue;
    const Output* const what = first_alike(outputs, output);
    if (!output.number) files.add(output.path, what);
    for (std::size_t i = 0; output.number && i < frames.size(); ++i) {
      files.add(output.path_of(frames[i]), what);
    }
  }
  const std::string difference = difference_path(line.run.reference);
  if (!difference.empty()) files.add(difference, &line.run.reference);
  if (!line.run.report.empty() && line.run.report != "-") {
    files.add(line.run.report, &line.run.report);
  }
}

bool wants_viewer(const CommandLine& line) {
  return line.run.outputs.empty() && line.run.report.empty() && line.run.reference.empty();
}

std::vector<Output> checked_outputs(const CommandLine& line) {
  if (line.run.watch && !wants_viewer(line)) {
    throw Error(Status::Input, "only the viewer watches a file", {"--watch", "", {}},
                "leave out --output, --report and --reference");
  }
  const Format* const fallback = checked_format(line.run.format);
  check_format_is_used(line);
  std::vector<Output> outputs;
  for (const std::string& path : line.run.outputs) {
    outputs.push_back({path, format_of(path, fallback), checked_number(path)});
    unescape(outputs.back());
  }
  check_standard_output(line);
  check_report_replaces_no_input(line);
  for (const Output& output : outputs) {
    if (output.path != "-") check_writable(output.path_of(0));
  }
  if (!line.run.report.empty() && line.run.report != "-") check_writable(line.run.report);
  return outputs;
}

void write_to(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path == "-") {
    write_standard_output(write);
  } else {
    write_file_whole(path, write);
  }
}

}  // namespace saddle
