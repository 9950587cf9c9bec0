#include "scene/options/option_kinds.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "scene/model/color.h"
#include "scene/model/colormap.h"
#include "scene/model/prepare.h"
#include "scene/options/materials.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {
namespace {

using Kind = TomlValue::Kind;

std::string pair_text(int a, int b) {
  return std::to_string(a) + "x" + std::to_string(b);
}

/// A TOML value that says what the option's text would.
template <typename Parse>
auto read_option(const InFile& in, const char* wanted, Parse parse) {
  const std::string text = in.reader.option(in.subject, in.value, wanted);
  return in.reader.in_place([&] { return parse(in.subject, text); });
}

}  // namespace

// --- words --------------------------------------------------------------------------------------

void Flag::parse(const Given& /*given*/) const {
  *value = toggles ? !*value : true;
}

std::string Flag::format() const {
  return *value ? "true" : "";
}

void Flag::read(const InFile& in) const {
  *value = in.reader.boolean(in.subject, in.value);
}

std::string Flag::write() const {
  return *value ? "true" : "false";
}

void Text::parse(const Given& given) const {
  *value = given.text;
}

void Text::read(const InFile& in) const {
  *value = in.reader.text(in.subject, in.value, wanted);
}

std::string Text::write() const {
  return toml_string(*value);
}

void Texts::parse(const Given& given) const {
  value->push_back(given.text);
}

void Formula::parse(const Given& given) const {
  *value = given.text == "off" ? std::string() : given.text;
}

void Formula::read(const InFile& in) const {
  *value = in.reader.formula(in.subject, in.value);
}

std::string Formula::write() const {
  return toml_string(*value);
}

void Names::read(const InFile& in) const {
  constexpr const char* kWanted = "a name, or an array of names";
  value->clear();
  if (in.value.kind != Kind::Array) {
    value->push_back(in.reader.text(in.subject, in.value, kWanted));
    return;
  }
  if (in.value.items.empty()) {
    throw in.reader.source().error(in.subject, "there is no node in it", in.value.span,
                                   "leave it out, and the surface is in the world");
  }
  for (const TomlValue& item : in.value.items) {
    value->push_back(in.reader.text(in.subject, item, kWanted));
  }
}

std::string Names::write() const {
  return value->empty() ? "" : toml_names(*value);
}

void ColormapName::parse(const Given& given) const {
  surface->colormap = parse_colormap(given.option, given.text);
}

std::string ColormapName::format() const {
  const bool says_something =
      !surface->color.empty() && surface->colormap != SurfaceSpec{}.colormap;
  return says_something ? surface->colormap : "";
}

void ColormapName::read(const InFile& in) const {
  const std::string text = in.reader.text(in.subject, in.value, "the name of a colormap");
  if (surface->color.empty()) {
    throw in.reader.source().error(in.subject, "there is nothing to colour", in.value.span,
                                   "color = \"z\" colours by height");
  }
  surface->colormap = in.reader.in_place([&] { return parse_colormap(in.subject, text); });
}

std::string ColormapName::write() const {
  const std::string name = format();
  return name.empty() ? "" : toml_string(name);
}

void Choice::parse(const Given& given) const {
  set(parse_choice(given.option, given.text, words));
}

void Choice::read(const InFile& in) const {
  std::string wanted;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) wanted += i + 1 < words.size() ? ", " : " or ";
    wanted += toml_string(words[i]);
  }
  const std::string text = in.reader.text(in.subject, in.value, wanted.c_str());
  in.reader.in_place([&] { set(parse_choice(in.subject, text, words)); });
}

std::string Choice::format() const {
  const std::optional<std::size_t> place = get();
  return place ? words[*place] : "";
}

std::string Choice::write() const {
  const std::string word = format();
  return word.empty() ? "" : toml_string(word);
}

// --- numbers ------------------------------------------------------------------------------------

void Ends::read(const InFile& in) const {
  const auto& [reader, subject, array] = in;
  if (array.kind != Kind::Array || array.items.size() != 2) {
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

void Frames::parse(const Given& given) const {
  *value = parse_frame_range(given.option, given.text);
}

// --- colours ------------------------------------------------------------------------------------

void Paint::parse(const Given& given) const {
  *value = parse_color(given.option, given.text);
}

std::string Paint::format() const {
  return format_color(*value);
}

void Paint::read(const InFile& in) const {
  *value = in.reader.color(in.subject, in.value, true);
}

std::string Paint::write() const {
  return toml_color(*value);
}

void Paint::resolve(Resolver& resolver, const std::string& name) const {
  resolver.color(name, *value, kShare);
}

void Side::parse(const Given& given) const {
  value->diffuse = opaque_color(given.option, given.text);
}

std::string Side::format() const {
  return format_color(value->diffuse);
}

void Side::read(const InFile& in) const {
  read_material(in.reader, in.subject, in.value, *value);
}

std::string Side::write() const {
  return write_material(*value, *standard);
}

void Side::resolve(Resolver& resolver, const std::string& name) const {
  resolve_material(resolver, name, *value);
}

// --- sizes --------------------------------------------------------------------------------------

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
  const GridSize lines = parse_grid_lines(given.option, given.text);
  surface->grid_u = lines.u;
  surface->grid_v = lines.v;
}

std::string GridLines::format() const {
  const bool off = surface->grid_u == 0 && surface->grid_v == 0;
  return off ? "off" : pair_text(surface->grid_u, surface->grid_v);
}

void GridLines::read(const InFile& in) const {
  const GridSize lines =
      read_option(in, "two whole numbers, [16, 16], or \"off\"", parse_grid_lines);
  surface->grid_u = lines.u;
  surface->grid_v = lines.v;
}

std::string GridLines::write() const {
  return "[" + std::to_string(surface->grid_u) + ", " + std::to_string(surface->grid_v) + "]";
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

}  // namespace saddle::kinds
