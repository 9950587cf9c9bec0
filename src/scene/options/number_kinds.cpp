#include "scene/options/number_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "base/nearest.h"
#include "scene/model/assignments.h"
#include "scene/model/prepare.h"
#include "scene/model/values.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {

Number parse_expression(const Given& given, Span part) {
  try {
    return number_in(given.option, given.text, part);
  } catch (const Error&) {
    if (given.scene) {
      Graph graph;
      Scope scope(graph, constant_names(*given.scene, given.surface),
                  constant_view(*given.scene, given.surface));
      const double now = scope.constant(given.option, given.text, part, given.scene->t);
      if (!std::isfinite(now) && !scope.has_used_time()) {
        throw Error(Status::Input, "not a finite number", {given.option, given.text, part});
      }
    }
    return Number(given.text.substr(part.begin, part.end - part.begin));
  }
}

void Real::parse(const Given& given) const {
  const Number number = parse_expression(given, {0, given.text.size()});
  *value = number.text.empty() ? Number(parse_number(given.option, given.text, limits)) : number;
}

std::string Real::format() const {
  return expression_of(*value);
}

void Real::read(const InFile& in) const {
  *value = in.reader.number(in.subject, in.value);
}

std::string Real::write() const {
  return toml_number(*value);
}

void Real::resolve(Resolver& resolver, const std::string& name) const {
  resolver.number(name, *value, limits);
}

void Plain::parse(const Given& given) const {
  *value = parse_number(given.option, given.text, limits);
}

std::string Plain::format() const {
  return format_number(*value);
}

void Plain::read(const InFile& in) const {
  *value = read_option(in, "a number", [this](const std::string& option, const std::string& text) {
    return parse_number(option, text, limits);
  });
}

std::string Plain::write() const {
  return toml_number(*value);
}

void Whole::parse(const Given& given) const {
  *value = parse_whole(given.option, given.text, low, high);
}

std::string Whole::format() const {
  return std::to_string(*value);
}

void Whole::read(const InFile& in) const {
  *value = in.reader.whole(in.subject, in.value, low, high);
}

std::string Whole::write() const {
  return std::to_string(*value);
}

void Point::parse(const Given& given) const {
  const std::vector<Span> parts =
      parse_list(given.option, given.text, 3, "a vector has three numbers", "2,-3,1.5");
  *value = {parse_expression(given, parts[0]), parse_expression(given, parts[1]),
            parse_expression(given, parts[2])};
  const auto is_zero = [](const Number& number) { return number.text.empty() && number == 0; };
  if (direction && is_zero(value->x) && is_zero(value->y) && is_zero(value->z)) {
    throw Error(Status::Input, "a direction needs a length",
                {given.option, given.text, {0, given.text.size()}},
                "one of its three numbers must not be 0");
  }
}

std::string Point::format() const {
  return expression_of(value->x) + "," + expression_of(value->y) + "," + expression_of(value->z);
}

void Point::read(const InFile& in) const {
  *value = in.reader.vector(in.subject, in.value);
}

std::string Point::write() const {
  return toml_vector(*value);
}

void Point::resolve(Resolver& resolver, const std::string& name) const {
  direction ? resolver.direction(name, *value) : resolver.vector(name, *value);
}

namespace {

struct NamedView {
  std::string_view name;
  dvec3 view;
};

/// Height fields have their front at the least y; `iso` shows three sides of a cube alike.
constexpr std::array kNamedViews = {NamedView{"front", {0, -1, 0}}, NamedView{"back", {0, 1, 0}},
                                    NamedView{"left", {-1, 0, 0}},  NamedView{"right", {1, 0, 0}},
                                    NamedView{"top", {0, 0, 1}},    NamedView{"bottom", {0, 0, -1}},
                                    NamedView{"iso", {1, -1, 1}}};

/// Null if no view has the name. Throws Error (Input) for another word.
const NamedView* find_view(const std::string& option, const std::string& text) {
  const auto found = std::ranges::find(kNamedViews, text, &NamedView::name);
  if (found != kNamedViews.end()) return &*found;
  if (text.empty() || text.find(',') != std::string::npos) return nullptr;
  std::vector<std::string> names;
  std::string hint = "X,Y,Z, or";
  for (const NamedView& view : kNamedViews) {
    names.emplace_back(view.name);
    hint += " " + names.back();
  }
  if (const auto nearest = nearest_name(text, names)) hint += "; did you mean '" + *nearest + "'?";
  throw Error(Status::Input, "no view has this name", {option, text, {0, text.size()}}, hint);
}

/// cos(elevation) cos(azimuth), cos(elevation) sin(azimuth), sin(elevation).
Vector view_along(const Number& azimuth, const Number& elevation) {
  if (azimuth.text.empty() && elevation.text.empty()) {
    const double a = glm::radians(azimuth.value);
    const double e = glm::radians(elevation.value);
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  }
  const std::string a = "((" + expression_of(azimuth) + ")*pi/180)";
  const std::string e = "((" + expression_of(elevation) + ")*pi/180)";
  return {Number("cos" + e + "*cos" + a), Number("cos" + e + "*sin" + a), Number("sin" + e)};
}

}  // namespace

void ViewDirection::parse(const Given& given) const {
  const NamedView* const named = find_view(given.option, given.text);
  named ? void(*value = named->view) : Point::parse(given);
}

void ViewDirection::read(const InFile& in) const {
  if (in.value.kind != TomlValue::Kind::String) return Point::read(in);
  const std::string name = in.reader.text(in.subject, in.value, "");
  const NamedView* const named = in.reader.in_place([&] { return find_view(in.subject, name); });
  if (!named) return Point::read(in);
  *value = named->view;
}

void ViewAngles::parse(const Given& given) const {
  const std::vector<Span> parts =
      parse_list(given.option, given.text, 2, "two angles are wanted", "-60,25");
  *value = view_along(parse_expression(given, parts[0]), parse_expression(given, parts[1]));
}

void ViewAngles::read(const InFile& in) const {
  const auto angles =
      in.reader.numbers(in.subject, in.value, 2, "two angles in degrees, such as [-60, 25]");
  *value = view_along(angles[0], angles[1]);
}

namespace {

/// The scale that one of two words is; nothing for factors. Throws Error (Input) for another word.
std::optional<AxisScale> scale_of_word(const std::string& option, const std::string& text) {
  if (text.empty() || text.find(',') != std::string::npos) return std::nullopt;
  const std::size_t word = parse_choice(option, text, {"auto", "equal", "X,Y,Z"});
  if (word == 2) return std::nullopt;
  return AxisScale{.automatic = word == 0};
}

bool is_equal(const Vector& factors) {
  return factors == Vector(dvec3(1));
}

}  // namespace

void Stretch::parse(const Given& given) const {
  if (const auto scale = scale_of_word(given.option, given.text)) {
    *value = *scale;
    return;
  }
  const std::vector<Span> parts =
      parse_list(given.option, given.text, 3, "a scale has a factor for each axis", "1,1,0.1");
  const auto factor = [&](std::size_t k) {
    Number number = parse_expression(given, parts[k]);
    if (!number.text.empty() || kPositive.contain(number.value)) return number;
    throw Error(Status::Input, "a factor must be " + describe(kPositive),
                {given.option, given.text, parts[k]});
  };
  *value = {.automatic = false, .factors = {factor(0), factor(1), factor(2)}};
}

std::string Stretch::format() const {
  if (value->automatic) return "";
  const Vector& f = value->factors;
  if (is_equal(f)) return "equal";
  return expression_of(f.x) + "," + expression_of(f.y) + "," + expression_of(f.z);
}

void Stretch::read(const InFile& in) const {
  if (in.value.kind == TomlValue::Kind::String) {
    const std::string word = in.reader.text(in.subject, in.value, "");
    const auto scale = in.reader.in_place([&] { return scale_of_word(in.subject, word); });
    if (scale) {
      *value = *scale;
      return;
    }
  }
  *value = {.automatic = false, .factors = in.reader.vector(in.subject, in.value)};
}

std::string Stretch::write() const {
  if (value->automatic) return "";
  return is_equal(value->factors) ? toml_string("equal") : toml_vector(value->factors);
}

void Stretch::resolve(Resolver& resolver, const std::string& name) const {
  if (value->automatic) return;
  for (Number* factor : {&value->factors.x, &value->factors.y, &value->factors.z}) {
    resolver.number(name, *factor, kPositive);
  }
}

void Ends::read(const InFile& in) const {
  const auto& [reader, subject, array] = in;
  if (array.kind != TomlValue::Kind::Array || array.items.size() != 2) {
    throw reader.source().wrong_type(subject, array, "two ends, such as [\"0\", \"2*pi\"]");
  }
  *value = {reader.formula(subject, array.items[0]), reader.formula(subject, array.items[1])};
  reader.note(subject, value->min + ":" + value->max, array.span);
}

std::string Ends::write() const {
  return "[" + toml_string(value->min) + ", " + toml_string(value->max) + "]";
}

void Times::read(const InFile& in) const {
  const auto ends = in.reader.numbers(in.subject, in.value, 2, "two moments, such as [0, 12]");
  set_time_range(*scene, ends[0], ends[1]);
}

std::string Times::write() const {
  if (!scene->animation) return "";
  return toml_numbers({scene->animation->from, scene->animation->to});
}

void Times::resolve(Resolver& resolver, const std::string& name) const {
  Animation& animation = *scene->animation;
  resolver.number(name, animation.from, kAny);
  resolver.number(name, animation.to, kAny);
  if (animation.from < animation.to && std::isfinite(animation.to - animation.from)) return;
  const std::string from = format_number(animation.from);
  const std::string to = format_number(animation.to);
  const std::string text = expression_of(animation.to);
  throw Error(Status::Input,
              animation.from == double(animation.to) ? "the range of t is empty"
              : animation.from < animation.to        ? "the range of t is too wide"
                                                     : "the range of t runs backwards",
              {name, text, {0, text.size()}},
              "it is " + from + ":" + to +
                  "; t runs from the lower to the upper end, for example "
                  "t=0:2*pi; one moment is t=VALUE");
}

void Moment::parse(const Given& given) const {
  if (const auto colon = range_colon(given.text)) {
    throw Error(Status::Input, "this is one moment",
                {given.option, given.text, {*colon, *colon + 1}},
                "a range of time is t=" + given.text);
  }
  scene->t = finite_constant(*given.scene, given.option, given.text);
}

std::string Moment::format() const {
  const double start = scene->animation ? double(scene->animation->from) : 0;
  return double(scene->t) == start ? "" : format_number(scene->t);
}

void Moment::read(const InFile& in) const {
  scene->t = in.reader.number(in.subject, in.value);
}

std::string Moment::write() const {
  const std::string text = toml_number(scene->t);
  return text == toml_number(scene->animation ? scene->animation->from : Number{}) ? "" : text;
}

void Frames::parse(const Given& given) const {
  *value = parse_frame_range(given.option, given.text);
}

}  // namespace saddle::kinds
