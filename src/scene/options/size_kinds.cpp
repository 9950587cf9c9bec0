#include "scene/options/size_kinds.h"

#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "base/error.h"
#include "scene/model/values.h"
#include "scene/options/number_kinds.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {
namespace {

std::string pair_text(int a, int b) {
  return std::to_string(a) + "x" + std::to_string(b);
}

struct OtherUnit {
  std::string_view name;
  double millimetres;
};

/// Units that people give lengths in, beside millimetres.
constexpr std::array kOtherUnits = {OtherUnit{"cm", 10}, OtherUnit{"in", 25.4},
                                    OtherUnit{"um", 1e-3}, OtherUnit{"m", 1000}};

/// Throws Error (Input) for a number with a unit other than mm.
void refuse_other_units(const std::string& option, const std::string& text, Span part) {
  const std::string word = text.substr(part.begin, part.end - part.begin);
  std::size_t end = word.size();
  while (end > 0 && std::isalpha(static_cast<unsigned char>(word[end - 1])) != 0) --end;
  if (end == 0 || !is_toml_number(word.substr(0, end))) return;
  for (const OtherUnit& unit : kOtherUnits) {
    if (word.substr(end) != unit.name) continue;
    const double value = number_in(option, word, {0, end});
    throw Error(Status::Input, "a thickness is in the surface's units, or in mm",
                {option, text, {part.begin + end, part.end}},
                "write " + format_number(value * unit.millimetres) + "mm");
  }
}

/// `2mm`, but not a name that ends so.
bool is_in_millimetres(std::string_view text) {
  if (!text.ends_with("mm") || text.size() < 3) return false;
  const char before = text[text.size() - 3];
  return std::isdigit(static_cast<unsigned char>(before)) != 0 || before == '.' || before == ')';
}

/// The last comma outside of brackets.
std::size_t last_comma(std::string_view text) {
  std::size_t found = std::string_view::npos;
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(') ++depth;
    if (text[k] == ')') --depth;
    if (text[k] == ',' && depth == 0) found = k;
  }
  return found;
}

Thickness parse_thickness(const Given& given) {
  const std::string& text = given.text;
  if (text == "off") return {0, false, Thickness::Where::Off};
  Thickness result;
  Span part = {0, text.size()};
  if (const std::size_t comma = last_comma(text); comma != std::string::npos) {
    const std::string side = text.substr(comma + 1);
    if (side != "front" && side != "back") {
      throw Error(Status::Input, "a thickness goes to the front or to the back",
                  {given.option, text, {comma + 1, text.size()}},
                  "0.1,front or 0.1,back; without a side, half of it goes to each");
    }
    result.where = side == "front" ? Thickness::Where::Front : Thickness::Where::Back;
    part.end = comma;
  }
  result.millimetres = is_in_millimetres(std::string_view(text).substr(0, part.end));
  if (result.millimetres) part.end -= 2;
  refuse_other_units(given.option, text, part);
  result.value = parse_expression(given, part);
  if (result.value.text.empty() && !kPositive.contain(result.value)) {
    throw Error(Status::Input, "a thickness must be " + describe(kPositive),
                {given.option, text, part}, "off is none; 0.1,back goes to the back");
  }
  return result;
}

}  // namespace

void PictureSize::parse(const Given& given) const {
  const GridSize size = parse_pair(given.option, given.text, 1, kMaxPixels);
  value->width = size.u;
  value->height = size.v;
}

std::string PictureSize::format() const {
  return pair_text(value->width, value->height);
}

void PictureSize::read(const InFile& in) const {
  const auto parse = [](const std::string& option, const std::string& text) {
    return parse_pair(option, text, 1, kMaxPixels);
  };
  const GridSize size = read_option(in, "two whole numbers, such as [800, 600]", parse);
  value->width = size.u;
  value->height = size.v;
}

std::string PictureSize::write() const {
  return toml_string(format());
}

void GridLines::parse(const Given& given) const {
  *value = parse_grid_lines(given.option, given.text);
}

std::string GridLines::format() const {
  if (!*value) return "";
  const auto [u, v] = **value;
  return u == 0 && v == 0 ? "off" : pair_text(u, v);
}

void GridLines::read(const InFile& in) const {
  *value = read_option(in, "two whole numbers, [16, 16], or \"off\"", parse_grid_lines);
}

std::string GridLines::write() const {
  if (!*value) return "";
  return "[" + std::to_string((*value)->u) + ", " + std::to_string((*value)->v) + "]";
}

void MemorySize::parse(const Given& given) const {
  *value = parse_memory(given.option, given.text);
}

std::string MemorySize::format() const {
  return format_number(*value) + "B";
}

void MemorySize::read(const InFile& in) const {
  *value = read_option(in, "bytes with a unit: \"2GB\"", parse_memory);
}

std::string MemorySize::write() const {
  return toml_string(format());
}

void Cells::parse(const Given& given) const {
  *value = parse_samples(given.option, given.text);
}

std::string Cells::format() const {
  return *value ? pair_text((*value)->u, (*value)->v) : "";
}

void Cells::read(const InFile& in) const {
  *value = read_option(in, "two whole numbers, such as [100, 50]", parse_samples);
}

std::string Cells::write() const {
  return *value ? toml_string(format()) : "";
}

void Length::parse(const Given& given) const {
  *value = parse_tolerance(given.option, given.text);
}

std::string Length::format() const {
  return *value ? format_number((*value)->value) + ((*value)->pixels ? "px" : "") : "";
}

void Length::read(const InFile& in) const {
  *value = read_option(in, "a length: \"0.5px\", or 1e-3", parse_tolerance);
}

std::string Length::write() const {
  return *value && (*value)->pixels ? toml_string(format()) : format();
}

void ClipBox::parse(const Given& given) const {
  *value = parse_clip(given.option, given.text);
}

std::string ClipBox::format() const {
  if (!value->box) return value->automatic ? "" : "off";
  std::string ranges;
  for (int k = 0; k < 3; ++k) {
    ranges += (k == 0 ? "" : ",") + format_number(value->box->low[k]) + ":" +
              format_number(value->box->high[k]);
  }
  return ranges;
}

void ClipBox::read(const InFile& in) const {
  const std::string text =
      in.reader.text(in.subject, in.value, "\"auto\", \"off\" or \"-1:1,-1:1,0:5\"");
  *value = in.reader.in_place([&] { return parse_clip(in.subject, text); });
}

std::string ClipBox::write() const {
  const std::string text = format();
  return text.empty() ? "" : toml_string(text);
}

void Thick::parse(const Given& given) const {
  *value = parse_thickness(given);
}

std::string Thick::format() const {
  if (!*value) return "";
  const Thickness& thickness = **value;
  if (thickness.where == Thickness::Where::Off) return "off";
  std::string text = expression_of(thickness.value);
  if (thickness.millimetres) {
    text = is_in_millimetres(text + "mm") ? text + "mm" : "(" + text + ")mm";
  }
  if (thickness.where == Thickness::Where::Front) text += ",front";
  if (thickness.where == Thickness::Where::Back) text += ",back";
  return text;
}

void Thick::read(const InFile& in) const {
  if (in.value.kind != TomlValue::Kind::String) {
    *value = {in.reader.number(in.subject, in.value, "a number, \"2mm\", or \"0.1,front\"")};
    return;
  }
  const std::string text = in.reader.text(in.subject, in.value, "");
  *value = in.reader.in_place([&] { return parse_thickness({nullptr, in.subject, text}); });
}

std::string Thick::write() const {
  const std::string text = format();
  if (text.empty()) return "";
  return is_toml_number(text) ? text : toml_string(text);
}

void Thick::resolve(Resolver& resolver, const std::string& name) const {
  if (!*value || (*value)->where == Thickness::Where::Off) return;
  resolver.number(name, (*value)->value, kPositive);
}

}  // namespace saddle::kinds
