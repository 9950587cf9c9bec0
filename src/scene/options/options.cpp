#include "scene/options/options.h"

#include <algorithm>

#include "scene/model/colormap.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

// A kind without the function leaves the value alone: an option without a key, a key without an
// option.

void parse_slot(const kinds::Slot& slot, const kinds::Given& given) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.parse(given); }) kind.parse(given);
      },
      slot);
}

std::string format_slot(const kinds::Slot& slot) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.format(); }) return kind.format();
        return std::string();
      },
      slot);
}

void read_slot(const kinds::Slot& slot, const kinds::InFile& in) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.read(in); }) kind.read(in);
      },
      slot);
}

std::string write_slot(const kinds::Slot& slot) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.write(); }) return kind.write();
        return std::string();
      },
      slot);
}

/// The value of a row where it differs from another value of that row; empty: it does not.
std::string write_beside(const kinds::Slot& slot, const kinds::Slot& standard) {
  return std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (requires { kind.write_beside(kind); }) {
          return kind.write_beside(std::get<Kind>(standard));
        }
        std::string text = write_slot(slot);
        return text == write_slot(standard) ? std::string() : text;
      },
      slot);
}

void resolve_slot(const kinds::Slot& slot, Resolver& resolver, const std::string& name) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.resolve(resolver, name); }) kind.resolve(resolver, name);
      },
      slot);
}

kinds::Slot slot_of(const Option& option, Scene& scene, SurfaceSpec& surface, RunSettings& run) {
  if (option.scene) return option.scene(scene);
  return option.surface ? option.surface(surface) : option.run(run);
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

/// `key = value`, or nothing for the default.
std::string line(const Option& option, const kinds::Slot& slot, const kinds::Slot& standard) {
  const std::string text = write_beside(slot, standard);
  return text.empty() ? "" : key_of(option) + " = " + text + "\n";
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
  Scene scene;
  SurfaceSpec surface;
  RunSettings run;
  return format_slot(slot_of(option, scene, surface, run));
}

std::string default_toml(const Option& option) {
  Scene scene;
  SurfaceSpec surface;
  RunSettings run;
  return write_slot(slot_of(option, scene, surface, run));
}

std::string limits_text(const Option& option) {
  Scene scene;
  SurfaceSpec surface;
  RunSettings run;
  return std::visit(
      [](const auto& kind) -> std::string {
        if constexpr (requires { limits_of(kind); }) return limits_of(kind);
        return "";
      },
      slot_of(option, scene, surface, run));
}

std::vector<std::string> choices(const Option& option) {
  Scene scene;
  SurfaceSpec surface;
  RunSettings run;
  const kinds::Slot slot = slot_of(option, scene, surface, run);
  if (std::holds_alternative<kinds::ColormapName>(slot)) return colormap_names();
  const auto* const choice = std::get_if<kinds::Choice>(&slot);
  return choice == nullptr ? std::vector<std::string>{} : choice->words;
}

std::vector<std::string> keys_of(Table table) {
  std::vector<std::string> keys;
  each_row(table, [&](const Option& option) { keys.push_back(key_of(option)); });
  return keys;
}

void check_value(const Option& option, const std::string& text) {
  Scene scene;
  scene.surfaces.resize(1);
  RunSettings run;
  const kinds::Slot slot = slot_of(option, scene, scene.surfaces[0], run);
  if (std::holds_alternative<kinds::Moment>(slot)) return;  // it may use the scene's parameters
  parse_slot(slot, {nullptr, dashed(option), text});
}

void apply_option(const Option& option, const std::string& text, Scene& scene) {
  const kinds::Given given{&scene, dashed(option), text};
  if (option.scene) parse_slot(option.scene(scene), given);
  if (!option.surface) return;
  for (SurfaceSpec& surface : scene.surfaces) parse_slot(option.surface(surface), given);
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
    with(value, key_of(option), [&](const TomlValue& v) {
      read_slot(option.surface(surface), {reader, prefix + key_of(option), v});
    });
  });
}

std::string write_keys(Table table, const Scene& scene) {
  Scene written = scene;
  Scene standard = standard_scene(scene.theme);
  std::string text;
  each_row(table, [&](const Option& option) {
    text += line(option, option.scene(written), option.scene(standard));
  });
  return text;
}

std::string write_keys(const SurfaceSpec& surface, Theme theme) {
  SurfaceSpec written = surface;
  SurfaceSpec standard = themed_surface(theme);
  std::string text;
  each_row(Table::Surface, [&](const Option& option) {
    text += line(option, option.surface(written), option.surface(standard));
  });
  return text;
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
    if (!option.is_option() || option.run) continue;
    if (option.table == Table::Animation && !said.animation) continue;
    const auto text = [&](Scene& of) {
      return format_slot(option.scene ? option.scene(of) : option.surface(of.surfaces[0]));
    };
    std::string is = text(said);
    if (!is.empty() && is != text(standard)) settings.push_back({&option, std::move(is)});
  }
  return settings;
}

}  // namespace saddle
