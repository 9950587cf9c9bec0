// Formats by extension, standard output as `-`.
#include "app/run/outputs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "app/report/reference.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/standard_streams.h"

namespace saddle {
namespace {

/// Formats that saddle does not write, and the nearest that it does.
constexpr std::array<std::pair<const char*, const char*>, 6> kSubstitutes = {{{"gltf", "glb"},
                                                                              {"fbx", "glb"},
                                                                              {"jpg", "png"},
                                                                              {"jpeg", "png"},
                                                                              {"webp", "png"},
                                                                              {"eps", "pdf"}}};

std::string known_formats(const std::string& word) {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.emplace_back(format.extension);
  std::optional<std::string> nearest = nearest_name(word, names);
  for (const auto& [other, ours] : kSubstitutes) {
    if (word == other) nearest = ours;
  }
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

/// They are about pages alone. Throws Error (Input) without one.
void check_page_options(const CommandLine& line, const std::vector<Output>& outputs) {
  const auto is_page = [](const Output& output) { return output.format->takes_sliders; };
  if (std::ranges::any_of(outputs, is_page)) return;
  const bool has_sliders = line.run.sliders != RunSettings{}.sliders;
  if (!has_sliders && !line.run.fragment) return;
  throw Error(Status::Input, "no output is a page",
              {has_sliders ? "--sliders" : "--fragment", has_sliders ? line.run.sliders : "", {}},
              "for example -o page.html");
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

std::vector<std::string> Output::files_of(int frame) const {
  if (path == "-") return {};
  std::vector<std::string> files = {path_of(frame)};
  const std::string stem = format->beside.empty() ? "" : stem_of(frame);
  for (const FileBeside& file : format->beside) {
    if (!stem.empty()) files.push_back(stem + std::string(file.ending));
  }
  return files;
}

std::string Output::stem_of(int frame) const {
  const std::filesystem::path file = path_of(frame);
  std::error_code none;
  const bool is_other =
      std::filesystem::exists(file, none) && !std::filesystem::is_regular_file(file, none);
  if (path == "-" || is_other) return "";
  return (file.parent_path() / file.stem()).string();
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
  check_page_options(line, outputs);
  check_standard_output(line);
  check_report_replaces_no_input(line);
  for (const Output& output : outputs) {
    for (const std::string& path : output.files_of(0)) check_writable(path);
  }
  if (!line.run.report.empty() && line.run.report != "-") check_writable(line.run.report);
  return outputs;
}

void write_all(const std::vector<FileToWrite>& files) {
  if (files.size() == 1 && files[0].path == "-") {
    write_standard_output(files[0].write);
  } else {
    write_files_whole(files);
  }
}

std::vector<FileToWrite> mesh_files(const Output& output, int frame, MeshContent& content) {
  const Format& format = *output.format;
  const std::string stem = format.beside.empty() ? "" : output.stem_of(frame);
  content.stem = std::filesystem::path(stem).filename().string();
  std::vector<FileToWrite> files;
  const auto add = [&](const std::string& path, auto* write) {
    files.push_back({path, [&content, write](std::ostream& out) { write(out, content); }});
  };
  add(output.path_of(frame), format.write_mesh);
  for (const FileBeside& file : format.beside) {
    if (!stem.empty() && (file.is_needed == nullptr || file.is_needed(content))) {
      add(stem + std::string(file.ending), file.write);
    }
  }
  return files;
}

}  // namespace saddle
