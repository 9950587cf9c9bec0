#include "scene/options/contour_kinds.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "scene/model/assignments.h"
#include "scene/model/values.h"
#include "scene/options/number_kinds.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {
namespace {

constexpr const char* kContourForm = "EXPR for round levels, or EXPR=A,B,...: z=0,0.5,1";
constexpr const char* kEndsForm = "A:B such as 0:1, or symmetric";

/// The `=` between expression and levels: the first one in no bracket that compares nothing.
std::optional<std::size_t> level_sign(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (text[i] != '=' || depth > 0) continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
      return i;
    }
  }
  return std::nullopt;
}

/// The places of A,B,... from `begin` on.
std::vector<Span> level_places(std::string_view text, std::size_t begin) {
  std::vector<Span> places = {{begin, begin}};
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (text[i] == ',' && depth <= 0) {
      places.push_back({i + 1, i + 1});
    } else {
      places.back().end = i + 1;
    }
  }
  return places;
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(' ') == std::string_view::npos;
}

ContourSpec parse_contour(const Given& given) {
  const std::string& text = given.text;
  const std::optional<std::size_t> sign = level_sign(text);
  ContourSpec contour{text.substr(0, sign.value_or(text.size())), {}};
  if (is_blank(contour.expression)) {
    throw Error(Status::Input, "the expression is missing",
                {given.option, text, {0, sign.value_or(text.size())}}, kContourForm);
  }
  if (!sign) return contour;
  for (const Span place : level_places(text, *sign + 1)) {
    if (is_blank(std::string_view(text).substr(place.begin, place.end - place.begin))) {
      throw Error(Status::Input, "a level is missing", {given.option, text, place}, kContourForm);
    }
    contour.levels.push_back(parse_expression(given, place));
  }
  return contour;
}

void add_contour(ContourSpec contour, std::vector<ContourSpec>& contours) {
  const auto known = std::ranges::find(contours, contour.expression, &ContourSpec::expression);
  if (known == contours.end()) return contours.push_back(std::move(contour));
  if (contour.levels.empty()) known->levels.clear();
  for (Number& level : contour.levels) {
    if (std::ranges::find(known->levels, expression_of(level), expression_of) ==
        known->levels.end()) {
      known->levels.push_back(std::move(level));
    }
  }
}

std::string contour_text(const ContourSpec& contour) {
  std::string text = contour.expression;
  for (std::size_t i = 0; i < contour.levels.size(); ++i) {
    text += (i == 0 ? "=" : ",") + expression_of(contour.levels[i]);
  }
  return text;
}

void check_order(const std::string& name, const ColorEnds& ends) {
  if (ends.low < double(ends.high) && ends.high - ends.low < 2 * std::numeric_limits<double>::max())
    return;
  const std::string text = expression_of(ends.low) + ":" + expression_of(ends.high);
  const bool swapped = ends.low > double(ends.high);
  throw Error(
      Status::Input, "the first end must be less than the second", {name, text, {0, text.size()}},
      swapped ? "write " + expression_of(ends.high) + ":" + expression_of(ends.low) : kEndsForm);
}

ColorEnds parse_ends(const Given& given) {
  const std::string& text = given.text;
  if (text == "symmetric") return {.symmetric = true};
  const std::optional<std::size_t> colon = range_colon(text);
  if (!colon || is_blank(std::string_view(text).substr(0, *colon)) ||
      is_blank(std::string_view(text).substr(*colon + 1))) {
    throw Error(Status::Input, "both ends are wanted", {given.option, text, {0, text.size()}},
                kEndsForm);
  }
  ColorEnds ends{false, parse_expression(given, {0, *colon}),
                 parse_expression(given, {*colon + 1, text.size()})};
  if (ends.low.text.empty() && ends.high.text.empty()) check_order(given.option, ends);
  return ends;
}

}  // namespace

void ColorEndsOf::parse(const Given& given) const {
  surface->color_ends.reset();
  if (given.text != "off") surface->color_ends = parse_ends(given);
}

std::string ColorEndsOf::format() const {
  const std::optional<ColorEnds>& ends = surface->color_ends;
  if (!ends || surface->color.empty()) return "";
  return ends->symmetric ? "symmetric" : expression_of(ends->low) + ":" + expression_of(ends->high);
}

void ColorEndsOf::read(const InFile& in) const {
  if (surface->color.empty()) {
    throw in.reader.source().error(in.subject, "there is nothing to colour", in.value.span,
                                   "color = \"z\" colours by height");
  }
  if (in.value.kind == TomlValue::Kind::Array) {
    const auto n = in.reader.numbers(in.subject, in.value, 2, "two ends, [0, 1], or \"symmetric\"");
    surface->color_ends = ColorEnds{false, n[0], n[1]};
    return;
  }
  const std::string text = in.reader.text(in.subject, in.value, "[0, 1] or \"symmetric\"");
  in.reader.in_place([&] { parse({nullptr, in.subject, text}); });
}

std::string ColorEndsOf::write() const {
  if (format().empty()) return "";
  const ColorEnds& ends = *surface->color_ends;
  return ends.symmetric ? toml_string("symmetric") : toml_numbers({ends.low, ends.high});
}

void ColorEndsOf::resolve(Resolver& resolver, const std::string& name) const {
  if (!surface->color_ends || surface->color_ends->symmetric) return;
  ColorEnds& ends = *surface->color_ends;
  resolver.number(name, ends.low, kAny);
  resolver.number(name, ends.high, kAny);
  check_order(name, ends);
}

void Contours::parse(const Given& given) const {
  if (given.text == "off") return value->clear();
  add_contour(parse_contour(given), *value);
}

std::vector<std::string> Contours::texts() const {
  std::vector<std::string> all;
  for (const ContourSpec& contour : *value) all.push_back(contour_text(contour));
  return all;
}

void Contours::read(const InFile& in) const {
  constexpr const char* kWanted = "\"z\", \"gauss=0\", or an array of such texts";
  const auto read_one = [&](const TomlValue& item) {
    const std::string text = in.reader.text(in.subject, item, kWanted);
    ContourSpec contour = in.reader.in_place([&] {
      return parse_contour({nullptr, in.subject, text});
    });
    in.reader.note(in.subject, contour.expression, item.span);
    for (const Number& level : contour.levels) {
      in.reader.note(in.subject, expression_of(level), item.span);
    }
    add_contour(std::move(contour), *value);
  };
  if (in.value.kind != TomlValue::Kind::Array) return read_one(in.value);
  for (const TomlValue& item : in.value.items) read_one(item);
}

std::string Contours::write() const {
  return value->empty() ? "" : toml_names(texts());
}

void Contours::resolve(Resolver& resolver, const std::string& name) const {
  for (ContourSpec& contour : *value) {
    for (Number& level : contour.levels) resolver.number(name, level, kAny);
  }
}

}  // namespace saddle::kinds
