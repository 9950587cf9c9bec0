#include "scene/options/number_kinds.h"

#include <cmath>

#include "base/error.h"
#include "scene/model/prepare.h"
#include "scene/model/values.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {

void Real::parse(const Given& given) const {
  *value = parse_number(given.option, given.text, limits);
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
  *value = direction ? parse_direction(given.option, given.text)
                     : parse_vector(given.option, given.text);
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
  scene->t = finite_constant(given.scene, given.option, given.text);
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
