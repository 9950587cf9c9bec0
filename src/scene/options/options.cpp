#include "scene/options/options.h"

#include <algorithm>
#include <type_traits>

#include "scene/model/colormap.h"
#include "scene/model/prepare.h"
#include "scene/model/theme.h"
#include "scene/options/slots.h"
#include "scene/toml/toml_writer.h"

namespace saddle {
namespace {

/// One of each thing that has values, as it begins.
struct Owners {
  Scene scene;
  SurfaceSpec surface;
  CurveSpec curve;
  PointSpec point;
  RunSettings run;
};

kinds::Slot slot_of(const Option& option, Owners& owners) {
  if (option.scene) return option.scene(owners.scene);
  if (option.surface) return option.surface(owners.surface);
  if (option.stroke) return option.stroke(owners.curve);
  if (option.curve) return option.curve(owners.curve);
  return option.point ? option.point(owners.point) : option.run(owners.run);
}

/// Calls `visit` with each row of a table of scene files.
template <typename Visit>
void each_row(Table table, const Visit& visit) {
  for (const Option& option : options()) {
    if (option.table == table) visit(option);
  }
}

std::string key_of(const Option& option) {
  return std::string(option.name);
}

/// The key in the table of a surface: ranges have the names of its parameters; empty for a
/// coordinate that is a parameter.
std::string key_of(const Option& option, const SurfaceSpec& surface) {
  if (option.name == "u") return surface.parameters[0];
  if (option.name == "v") return surface.parameters[1];
  return is_parameter(surface, key_of(option)) ? "" : key_of(option);
}

/// `key = value`, or nothing for the default.
std::string line(const std::string& key, const kinds::Slot& slot, const kinds::Slot& standard) {
  const std::string text = write_beside(slot, standard);
  if (key.empty() || text.empty()) return "";
  return toml_key(key) + " = " + text + "\n";
}

/// Calls `visit` with each key of a curve or point, and its value.
template <typename Stroke, typename Visit>
void each_stroke_slot(Stroke& stroke, const Visit& visit) {
  each_row(Table::Stroke, [&](const Option& row) { visit(row, row.stroke(stroke)); });
  constexpr bool kIsCurve = std::is_same_v<Stroke, CurveSpec>;
  each_row(kIsCurve ? Table::Curve : Table::Point, [&](const Option& row) {
    if constexpr (kIsCurve) {
      visit(row, row.curve(stroke));
    } else {
      visit(row, row.point(stroke));
    }
  });
}

template <typename Stroke>
std::string stroke_lines(const Stroke& stroke) {
  Stroke written = stroke;
  Stroke standard;
  std::vector<kinds::Slot> defaults;
  each_stroke_slot(standard,
                   [&](const Option&, const kinds::Slot& slot) { defaults.push_back(slot); });
  std::string text;
  std::size_t k = 0;
  each_stroke_slot(written, [&](const Option& option, const kinds::Slot& slot) {
    text += line(key_of(option), slot, defaults[k++]);
  });
  return text;
}

/// A scene that says nothing, not even its theme.
Scene standard_scene(Theme theme) {
  Scene scene;
  change_theme(scene, theme);
  scene.theme = Scene{}.theme;
  return scene;
}

/// The name of a key in messages.
std::string subject(const Option& option) {
  return option.subject.empty() ? key_of(option) : std::string(option.subject);
}

std::string limits_of(const kinds::Real& kind) {
  return describe(kind.limits);
}

std::string limits_of(const kinds::Plain& kind) {
  return describe(kind.limits);
}

std::string limits_of(const kinds::Whole& kind) {
  return std::to_string(kind.low) + " to " + std::to_string(kind.high);
}

template <typename Kind, typename Value>
std::string limits_of(const kinds::Maybe<Kind, Value>& maybe) {
  if constexpr (requires { limits_of(maybe.kind); }) return limits_of(maybe.kind);
  return "";
}

}  // namespace

const Option* find_option(std::string_view name) {
  const auto found = std::ranges::find_if(
      options(), [&](const Option& option) { return option.is_option() && option.name == name; });
  return found == options().end() ? nullptr : &*found;
}

const Option* find_option(char letter) {
  const auto found = std::ranges::find(options(), letter, &Option::letter);
  return letter == 0 || found == options().end() ? nullptr : &*found;
}

std::string dashed(const Option& option) {
  return "--" + std::string(option.name);
}

std::string default_text(const Option& option) {
  if (!option.usual.empty()) return std::string(option.usual);
  if (option.is_flag()) return option.run ? "" : "off";
  Owners owners;
  return format_slot(slot_of(option, owners));
}

std::string default_toml(const Option& option) {
  Owners owners;
  return write_slot(slot_of(option, owners));
}

std::string limits_text(const Option& option) {
  Owners owners;
  return std::visit(
      [](const auto& kind) -> std::string {
        if constexpr (requires { limits_of(kind); }) return limits_of(kind);
        return "";
      },
      slot_of(option, owners));
}

std::vector<std::string> choices(const Option& option) {
  Owners owners;
  const kinds::Slot slot = slot_of(option, owners);
  if (std::holds_alternative<kinds::ColormapName>(slot)) return colormap_names();
  const auto* const choice = std::get_if<kinds::Choice>(&slot);
  return choice == nullptr ? std::vector<std::string>{} : choice->words;
}

std::string expanded(std::string_view text, const Option& option) {
  std::string result(text);
  const auto replace = [&result](const std::string& mark, const std::string& names) {
    const std::size_t at = result.find(mark);
    if (at != std::string::npos) result.replace(at, mark.size(), names);
  };
  std::string words;
  for (const std::string& word : choices(option)) words += (words.empty() ? "" : " ") + word;
  replace("{choices}", words);
  replace("{limits}", limits_text(option));
  return result;
}

std::string help_of(const Option& option) {
  return expanded(option.help, option);
}

std::vector<std::string> keys_of(Table table) {
  std::vector<std::string> keys;
  each_row(table, [&](const Option& option) { keys.push_back(key_of(option)); });
  return keys;
}

std::vector<std::string> keys_of(const SurfaceSpec& surface) {
  std::vector<std::string> keys;
  each_row(Table::Surface, [&](const Option& option) {
    const std::string key = key_of(option, surface);
    if (!key.empty()) keys.push_back(key);
  });
  return keys;
}

void check_value(const Option& option, const std::string& text) {
  Owners owners;
  const kinds::Slot slot = slot_of(option, owners);
  if (std::holds_alternative<kinds::Moment>(slot)) return;  // it may use the scene's parameters
  if (std::holds_alternative<kinds::TexturePictureOf>(slot)) return;  // a file is read once
  parse_slot(slot, {nullptr, dashed(option), text});
}

bool is_of_strokes(const Option& option, bool beside_surfaces) {
  return option.stroke != nullptr && !(beside_surfaces && option.name == "color");
}

namespace {

/// The row of a surface's own value, in place of the scene's; nullptr if it has none.
const Option* own_row(const Option& option) {
  const auto is_own = [&](const Option& row) { return row.surface && row.name == option.name; };
  const auto row = std::ranges::find_if(options(), is_own);
  return row == options().end() ? nullptr : &*row;
}

/// An option for the whole scene is for the surfaces that have their own value, too.
void replace_own(const Option& option, const std::string& text, Scene& scene) {
  const Option* const row = own_row(option);
  if (row == nullptr) return;
  for (SurfaceSpec& surface : scene.surfaces) {
    const bool has_own = !write_slot(row->surface(surface)).empty();
    if (has_own) apply_option(option, text, scene, surface);
  }
}

}  // namespace

void apply_option(const Option& option, const std::string& text, Scene& scene) {
  if (option.scene) {
    parse_slot(option.scene(scene), {&scene, dashed(option), text});
    replace_own(option, text, scene);
  }
  if (option.surface) {
    for (SurfaceSpec& surface : scene.surfaces) apply_option(option, text, scene, surface);
  }
  if (!is_of_strokes(option, !scene.surfaces.empty())) return;
  for (CurveSpec& curve : scene.curves) apply_option(option, text, scene, curve);
  for (PointSpec& point : scene.points) apply_option(option, text, scene, point);
}

void apply_option(const Option& option, const std::string& text, const Scene& scene,
                  SurfaceSpec& surface) {
  const Option* const row = own_row(option);
  if (row == nullptr) return;  // of curves and points alone
  parse_slot(row->surface(surface), {&scene, dashed(option), text, &surface});
}

void apply_option(const Option& option, const std::string& text, const Scene& scene,
                  StrokeSpec& stroke) {
  parse_slot(option.stroke(stroke), {&scene, dashed(option), text});
}

void set_place(const std::string& text, PointSpec& point) {
  const std::vector<Span> parts =
      parse_list("point", text, 3, "a place in space has three numbers", "1,2,3");
  const auto number = [&](const Span& part) {
    const std::string word = text.substr(part.begin, part.end - part.begin);
    return is_toml_number(word) ? Number(parse_number("point", word)) : Number(word);
  };
  point.at = {number(parts[0]), number(parts[1]), number(parts[2])};
}

void apply_option(const Option& option, const std::string& text, RunSettings& run) {
  if (option.run) parse_slot(option.run(run), {nullptr, dashed(option), text});
}

void read_keys(Table table, TomlReader& reader, const std::string& prefix, const TomlValue& value,
               Scene& scene) {
  each_row(table, [&](const Option& option) {
    with(value, key_of(option), [&](const TomlValue& v) {
      if (!option.excludes.empty() && value.find(std::string(option.excludes)) != nullptr) {
        throw reader.source().error(prefix + subject(option),
                                    "says again what '" + std::string(option.excludes) + "' says",
                                    v.span, "leave one of the two out");
      }
      read_slot(option.scene(scene), {reader, prefix + subject(option), v});
    });
  });
}

void read_keys(TomlReader& reader, const std::string& prefix, const TomlValue& value,
               SurfaceSpec& surface) {
  each_row(Table::Surface, [&](const Option& option) {
    const std::string key = key_of(option, surface);  // by the parameters, which stand first
    with(value, key, [&](const TomlValue& v) {
      read_slot(option.surface(surface), {reader, prefix + key, v});
    });
  });
}

void read_keys(TomlReader& reader, const std::string& prefix, const TomlValue& value,
               CurveSpec& curve) {
  each_stroke_slot(curve, [&](const Option& option, const kinds::Slot& slot) {
    with(value, key_of(option), [&](const TomlValue& v) {
      read_slot(slot, {reader, prefix + key_of(option), v});
    });
  });
}

void read_keys(TomlReader& reader, const std::string& prefix, const TomlValue& value,
               PointSpec& point) {
  each_stroke_slot(point, [&](const Option& option, const kinds::Slot& slot) {
    with(value, key_of(option), [&](const TomlValue& v) {
      read_slot(slot, {reader, prefix + key_of(option), v});
    });
  });
}

std::string write_keys(Table table, const Scene& scene) {
  Scene written = scene;
  Scene standard = standard_scene(scene.theme);
  std::string text;
  each_row(table, [&](const Option& option) {
    text += line(key_of(option), option.scene(written), option.scene(standard));
  });
  return text;
}

std::string write_keys(const SurfaceSpec& surface, Theme theme) {
  SurfaceSpec written = surface;
  SurfaceSpec standard = themed_surface(theme);
  std::string text;
  each_row(Table::Surface, [&](const Option& option) {
    text += line(key_of(option, surface), option.surface(written), option.surface(standard));
  });
  return text;
}

std::string write_keys(const CurveSpec& curve) {
  return stroke_lines(curve);
}

std::string write_keys(const PointSpec& point) {
  return stroke_lines(point);
}

void resolve_keys(Resolver& resolver, Table table, Scene& scene) {
  each_row(table, [&](const Option& option) {
    resolve_slot(option.scene(scene), resolver, subject(option));
  });
}

void resolve_keys(Resolver& resolver, const std::string& prefix, SurfaceSpec& surface) {
  each_row(Table::Surface, [&](const Option& option) {
    resolve_slot(option.surface(surface), resolver, prefix + key_of(option));
  });
}

void resolve_keys(Resolver& resolver, const std::string& prefix, CurveSpec& curve) {
  each_stroke_slot(curve, [&](const Option& option, const kinds::Slot& slot) {
    resolve_slot(slot, resolver, prefix + key_of(option));
  });
}

void resolve_keys(Resolver& resolver, const std::string& prefix, PointSpec& point) {
  each_stroke_slot(point, [&](const Option& option, const kinds::Slot& slot) {
    resolve_slot(slot, resolver, prefix + key_of(option));
  });
}

std::vector<Setting> settings_of(const Scene& scene) {
  Scene said = scene;
  Scene standard = standard_scene(scene.theme);
  standard.surfaces = {themed_surface(scene.theme)};
  if (said.animation) {
    standard.animation.emplace();
    standard.animation->from = said.animation->from;
  }
  std::vector<Setting> settings;
  for (const Option& option : options()) {
    if (!option.is_option() || !(option.scene || option.surface)) continue;
    if (option.table == Table::Animation && !said.animation) continue;
    const auto texts = [&](Scene& of) {
      return texts_of(option.scene ? option.scene(of) : option.surface(of.surfaces[0]));
    };
    std::vector<std::string> is = texts(said);
    if (is == texts(standard)) continue;
    for (std::string& text : is) settings.push_back({&option, std::move(text)});
  }
  return settings;
}

}  // namespace saddle
