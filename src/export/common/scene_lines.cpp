// A line is `COMMENT scene TEXT`; `COMMENT scene+ TEXT` continues the line before it.
#include "export/common/scene_lines.h"

#include <algorithm>
#include <cstddef>

#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

constexpr std::string_view kBeginning = "scene ";
constexpr std::string_view kContinued = "scene+ ";
/// Bytes of text in a line: rply, which many programs read PLY with, has room for 1024 in all.
constexpr std::size_t kLineBytes = 200;

/// The next line, without its end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// At most kLineBytes, not inside of a UTF-8 sequence.
std::size_t piece_of(std::string_view line) {
  std::size_t end = std::min(line.size(), kLineBytes);
  while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0u) == 0x80) --end;
  return end;
}

}  // namespace

std::string scene_lines(const Scene& scene, std::string_view comment) {
  const std::string text = write_scene(scene);
  std::string result;
  for (std::string_view rest = text; !rest.empty();) {
    std::string_view line = take_line(rest);
    std::string_view mark = kBeginning;
    do {
      const std::size_t length = piece_of(line);
      result += std::string(comment) + std::string(mark) + std::string(line.substr(0, length));
      result += '\n';
      line.remove_prefix(length);
      mark = kContinued;
    } while (!line.empty());
  }
  return result;
}

std::optional<std::string> scene_in_lines(std::string_view text, std::string_view comment,
                                          int skipped) {
  for (int i = 0; i < skipped; ++i) take_line(text);
  std::optional<std::string> result;
  while (text.starts_with(comment)) {
    std::string_view line = take_line(text);
    line.remove_prefix(comment.size());
    if (line.starts_with(kBeginning)) {
      if (result) {
        *result += '\n';
      } else {
        result.emplace();
      }
      *result += line.substr(kBeginning.size());
    } else if (result && line.starts_with(kContinued)) {
      *result += line.substr(kContinued.size());
    }
  }
  if (result) *result += '\n';
  return result;
}

}  // namespace saddle
