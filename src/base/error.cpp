#include "base/error.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/printable.h"
#include "base/run_limits.h"

namespace saddle {
namespace {

/// Columns of a line of source that are shown: what fits most terminals.
constexpr std::size_t kLineColumns = 100;
/// However long the name before it is, this much of a text is shown.
constexpr std::size_t kLeastTextColumns = 40;
constexpr std::string_view kIndent = "  ";
constexpr std::string_view kCut = "...";

/// The line of a text in which a span begins, and the part of the span that is in it.
struct Line {
  std::string_view text;
  Span span;
};

Line line_of(std::string_view text, Span span) {
  const std::size_t begin = std::min(span.begin, text.size());
  const std::size_t before = text.substr(0, begin).rfind('\n');
  const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
  std::string_view line = text.substr(first, text.find('\n', begin) - first);
  if (line.ends_with('\r')) line.remove_suffix(1);
  const std::size_t in_line = std::min(begin - first, line.size());
  const std::size_t end = std::clamp(span.end, first + in_line, first + line.size());
  return {line, {in_line, end - first}};
}

/// Half-open range of columns.
struct Columns {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Where the carets stand: at least one column, past the end of the line if the span is there.
Columns marked_columns(const Glyphs& glyphs, Span span) {
  const auto first = std::find_if(glyphs.begin(), glyphs.end(),
                                  [&](const Glyph& g) { return g.end > span.begin; });
  if (first == glyphs.end()) return {columns(glyphs), columns(glyphs) + 1};
  const auto last =
      std::find_if(first, glyphs.end(), [&](const Glyph& g) { return g.begin >= span.end; });
  const std::size_t end = last == glyphs.end() ? columns(glyphs) : last->column;
  return {first->column, std::max(end, first->column + 1)};
}

/// Which columns of a line of `total` are shown so that `marked` is among them, in the middle
/// where possible, and no more than `room` with the cuts.
Columns shown_columns(std::size_t total, Columns marked, std::size_t room) {
  if (total <= room) return {0, total};
  const std::size_t inner = room - 2 * kCut.size();
  const std::size_t context = inner - std::min(marked.end - marked.begin, inner);
  const std::size_t wanted = marked.begin - std::min(marked.begin, context / 2);
  const std::size_t begin = std::min(wanted, total - inner);
  return {begin, begin + inner};
}

/// The two lines `  PREFIXtext` and `  ^~~` below it.
std::string marked_line(const std::string& prefix, const Line& line) {
  const Glyphs prefix_glyphs = split_glyphs(prefix);
  const std::size_t indent = kIndent.size() + columns(prefix_glyphs);
  const Glyphs glyphs = split_glyphs(line.text);
  const std::size_t total = columns(glyphs);
  const Columns marked = marked_columns(glyphs, line.span);
  const std::size_t room =
      std::max(kLineColumns - std::min(indent, kLineColumns), kLeastTextColumns);
  const Columns window = shown_columns(total, marked, room);

  std::string shown(window.begin > 0 ? kCut : "");
  std::size_t shown_width = shown.size();
  std::size_t caret = shown_width;  // columns before the carets
  for (const Glyph& glyph : glyphs) {
    if (glyph.column < window.begin || glyph.column + glyph.width > window.end) continue;
    shown += glyph.shown;
    shown_width += glyph.width;
    if (glyph.column + glyph.width <= marked.begin) caret = shown_width;
  }
  if (window.end < total) shown += kCut;
  const std::size_t carets = std::max<std::size_t>(
      std::min(marked.end, std::max(window.end, marked.begin + 1)) - marked.begin, 1);

  std::string result(kIndent);
  result += joined(prefix_glyphs) + shown + '\n';
  result += std::string(indent + caret, ' ') + '^' + std::string(carets - 1, '~') + '\n';
  return result;
}

std::string marked_place(const Place& place) {
  const Line line = line_of(place.text, place.span);
  if (line.text.empty()) return {};
  std::string prefix = place.where.empty() ? place.name : "";
  if (!prefix.empty()) prefix += prefix.starts_with("--") ? " " : " = ";
  return marked_line(prefix, line);
}

}  // namespace

Hint::Hint(std::string line) {
  if (!line.empty()) lines_.push_back(std::move(line));
}

Error::Error(Status status, std::string message, Place place, Hint hint)
    : status_(status),
      message_(std::move(message)),
      place_(std::move(place)),
      hint_(std::move(hint)) {}

std::string Error::hint() const {
  std::string text;
  for (const std::string& line : hint_) text += (text.empty() ? "" : "\n") + line;
  return text;
}

Error caught_error() {
  try {
    throw;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return {Status::Machine,
            memory_refusal(),
            {},
            "less takes less: --max-triangles, --samples, --grid, --size, --antialias"};
  } catch (const std::length_error&) {
    return {Status::Machine, "out of memory: more is asked for than any machine has"};
  } catch (const Overtime&) {
    return {Status::Machine,
            time_refusal(),
            {},
            "a larger --max-time allows more; a larger --tolerance or a smaller --size takes less"};
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) {
      return {Status::Machine, error.what()};
    }
    return {Status::Machine,
            "the system starts no more threads",
            {},
            "ulimit -u and ulimit -v show what it allows"};
  } catch (const std::exception& error) {
    return {Status::Machine, error.what()};
  }
}

Error with_hint_line(const Error& error, std::string_view line) {
  Hint hint = error.hint_lines();
  hint.add(line);
  return {error.status(), error.what(), error.place(), std::move(hint)};
}

std::string format_error(const Error& error) {
  std::string text = "saddle: ";
  if (!error.place().where.empty()) text += printable(error.place().where) + ": ";
  if (!error.place().name.empty()) text += printable(error.place().name) + ": ";
  text += printable(error.what());
  text += '\n';
  text += marked_place(error.place());
  for (const std::string& line : error.hint_lines()) text += printable(line) + '\n';
  return text;
}

}  // namespace saddle
