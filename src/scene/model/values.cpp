// Option values: whole numbers are digits, real ones constant expressions of the formula language.
#include "scene/model/values.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/nearest.h"
#include "formula/graph.h"
#include "formula/scope.h"
#include "scene/model/color.h"

namespace saddle {
namespace {

/// Corners of a mesh have 32-bit numbers and about 300 bytes each while it is made: more cells
/// than this fit no machine's memory.
constexpr std::int64_t kMaxSamples = std::int64_t{1} << 26;

/// A value that would do, as an option or as a key of a scene file.
std::string example(const std::string& option, const std::string& value) {
  // The word after `point` is a value, too.
  if (option.starts_with("--") || option == "point") return "for example " + option + " " + value;
  const std::size_t colon = option.rfind(' ');  // of "surface 1: grid"
  return "for example " + option.substr(colon == std::string::npos ? 0 : colon + 1) + " = \"" +
         value + "\"";
}

Span whole(const std::string& text) {
  return {0, text.size()};
}

}  // namespace

double number_in(const std::string& option, const std::string& text, Span part) {
  double value = 0;
  const char* const begin = text.data() + part.begin;
  const char* const end = text.data() + part.end;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || rest != end) {  // no plain number: ask the formula language
    Graph graph;
    value = Scope(graph, {}).constant(option, text, part);
  }
  if (!std::isfinite(value))
    throw Error(Status::Input, "not a finite number", {option, text, part});
  return value;
}

namespace {

int whole_in(const std::string& option, const std::string& text, Span part, int low, int high) {
  int value = 0;
  const char* const begin = text.data() + part.begin;
  const char* const end = text.data() + part.end;
  const auto [rest, error] = std::from_chars(begin, end, value);
  const bool too_large = error == std::errc::result_out_of_range;
  if ((error != std::errc{} && !too_large) || rest != end) {
    throw Error(Status::Input, "not a whole number", {option, text, part}, "write digits alone");
  }
  if (too_large || value < low || value > high) {
    throw Error(Status::Input,
                "must be from " + std::to_string(low) + " to " + std::to_string(high),
                {option, text, part});
  }
  return value;
}

/// `X0:X1,Y0:Y1,Z0:Z1`
Bounds parse_box(const std::string& option, const std::string& text) {
  const std::string hint = example(option, "-1:1,-1:1,0:5");
  Bounds box;
  std::size_t begin = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(',', begin) : text.size();
    const std::size_t colon = text.find(':', begin);
    if (end == std::string::npos || colon == std::string::npos || colon > end) {
      throw Error(Status::Input, "a box has three ranges with commas between",
                  {option, text, whole(text)}, hint);
    }
    box.low[k] = number_in(option, text, {begin, colon});
    box.high[k] = number_in(option, text, {colon + 1, end});
    if (!(box.low[k] < box.high[k])) {
      throw Error(Status::Input, "this range is empty", {option, text, {begin, end}}, hint);
    }
    begin = end + 1;
  }
  return box;
}

}  // namespace

std::string format_number(double value) {
  if (std::isnan(value)) return "nan";  // whose sign means nothing
  std::array<char, 32> text{};          // the longest is 24 characters
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string expression_of(const Number& number) {
  return number.text.empty() ? format_number(number.value) : number.text;
}

std::string describe(const Limits& limits) {
  const std::string low = format_number(limits.low);
  if (std::isinf(limits.high)) return limits.open ? "more than " + low : "at least " + low;
  const std::string high = format_number(limits.high);
  return limits.open ? "more than " + low + " and less than " + high
                     : "from " + low + " to " + high;
}

double parse_number(const std::string& option, const std::string& text, const Limits& limits) {
  const double value = number_in(option, text, whole(text));
  if (limits.contain(value)) return value;
  throw Error(Status::Input, "must be " + describe(limits), {option, text, whole(text)});
}

int parse_whole(const std::string& option, const std::string& text, int low, int high) {
  return whole_in(option, text, whole(text), low, high);
}

std::vector<Span> parse_list(const std::string& option, const std::string& text, std::size_t count,
                             const std::string& what, const std::string& sample) {
  std::vector<Span> parts(1);
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (text[i] == ',' && depth <= 0) parts.push_back({i + 1, i + 1});
    if (text[i] != ',' || depth > 0) parts.back().end = i + 1;
  }
  if (parts.size() == count) return parts;
  throw Error(Status::Input, what + ", this one has " + std::to_string(parts.size()),
              {option, text, whole(text)}, example(option, sample));
}

ToleranceValue parse_tolerance(const std::string& option, const std::string& text) {
  const bool pixels = text.ends_with("px");
  const Span number = {0, text.size() - (pixels ? 2 : 0)};
  const double value = number_in(option, text, number);
  if (!(value > 0)) {
    throw Error(Status::Input, "must be more than 0", {option, text, number},
                example(option, "0.5px") + ", or 1e-3 of the diagonal of the bounding box");
  }
  return {value, pixels};
}

Clip parse_clip(const std::string& option, const std::string& text) {
  std::string word = text;
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  Clip clip{word == "auto", {}};
  const bool none = word == "off" || word == "none";
  if (!clip.automatic && !none) clip.box = parse_box(option, text);
  return clip;
}

GridSize parse_pair(const std::string& option, const std::string& text, int low, int high) {
  const std::size_t x = text.find_first_of("xX,");
  if (x == std::string::npos) {
    throw Error(Status::Input, "this is two whole numbers with an x between",
                {option, text, whole(text)}, example(option, "80x60"));
  }
  return {whole_in(option, text, {0, x}, low, high),
          whole_in(option, text, {x + 1, text.size()}, low, high)};
}

namespace {

/// `MxN`, or one number for both.
GridSize parse_one_or_two(const std::string& option, const std::string& text, int low, int high) {
  if (text.find_first_of("xX,") != std::string::npos) return parse_pair(option, text, low, high);
  const int both = whole_in(option, text, whole(text), low, high);
  return {both, both};
}

}  // namespace

std::size_t parse_choice(const std::string& option, const std::string& text,
                         const std::vector<std::string>& words) {
  const auto found = std::ranges::find(words, text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string hint = "one of:";
  for (const std::string& word : words) hint += " " + word;
  if (const auto nearest = nearest_name(text, words)) hint += "; did you mean '" + *nearest + "'?";
  throw Error(Status::Input, "unknown value '" + text + "'", {option, text, whole(text)}, hint);
}

GridSize parse_samples(const std::string& option, const std::string& text) {
  const GridSize cells = parse_one_or_two(option, text, 1, std::numeric_limits<int>::max());
  if (std::int64_t{cells.u} * cells.v > kMaxSamples) {
    throw Error(Status::Input, "more than " + std::to_string(kMaxSamples) + " cells",
                {option, text, whole(text)});
  }
  return cells;
}

double parse_memory(const std::string& option, const std::string& text) {
  constexpr std::array<std::pair<std::string_view, double>, 7> kUnits = {{{"GiB", 0x1p30},
                                                                          {"MiB", 0x1p20},
                                                                          {"GB", 1e9},
                                                                          {"MB", 1e6},
                                                                          {"G", 0x1p30},
                                                                          {"M", 0x1p20},
                                                                          {"B", 1}}};
  for (const auto& [unit, bytes] : kUnits) {
    if (!text.ends_with(unit)) continue;
    const Span digits{0, text.size() - unit.size()};
    const double size = bytes * number_in(option, text, digits);
    if (size >= kLeastMemory && size <= kMostMemory) return size;
    throw Error(Status::Input, "must be from 64MB to 1000000GB", {option, text, whole(text)});
  }
  throw Error(Status::Input, "a size of memory has a unit", {option, text, whole(text)},
              example(option, "2GB") + ", 500MB or 1.5GiB");
}

FrameRange parse_frame_range(const std::string& option, const std::string& text) {
  const std::string hint = example(option, "20:40") + ", both ends included";
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    throw Error(Status::Input, "a range of frames is FIRST:LAST", {option, text, whole(text)},
                example(option, "20:40") + ", or 20:20 for one frame");
  }
  const FrameRange range = {whole_in(option, text, {0, colon}, 0, kMaxFrames - 1),
                            whole_in(option, text, {colon + 1, text.size()}, 0, kMaxFrames - 1)};
  if (range.first <= range.last) return range;
  throw Error(Status::Input, "this range is empty", {option, text, whole(text)}, hint);
}

GridSize parse_grid_lines(const std::string& option, const std::string& text) {
  if (text == "off" || text == "none") return {0, 0};
  const GridSize lines = parse_one_or_two(option, text, 0, kMaxGridLines);
  if (std::int64_t{lines.u} * lines.v > kMostGridCrossings) {
    throw Error(Status::Input, "so many lines cover the surface", {option, text, whole(text)},
                "lines of u times lines of v are at most " + std::to_string(kMostGridCrossings) +
                    ", such as 1024x1024");
  }
  if (lines.u == 1 || lines.v == 1) {
    throw Error(Status::Input,
                "the first and the last line are the ends of the range: one is not "
                "enough",
                {option, text, whole(text)}, "0 is none, or at least 2");
  }
  return lines;
}

Color opaque_color(const std::string& option, const std::string& text) {
  Color color = parse_color(option, text);
  if (color.a < 1) {
    throw Error(Status::Input, "this colour cannot be see-through",
                {option, text, {0, text.size()}},
                "write #rrggbb, or a CSS colour name; --opacity makes a surface see-through");
  }
  return color;
}

}  // namespace saddle
