#include "view/panel/option_fields.h"

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include <imgui.h>

#include "scene/options/slots.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

/// Keys with rows of their own, and those that are the window's.
constexpr std::array<std::string_view, 9> kShown{"x", "y", "z",  "xyz",    "u",
                                                 "v", "s", "on", "visible"};
constexpr std::array<std::string_view, 3> kOfWindow{"size", "antialias", "t"};

bool is_in(const auto& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// Several texts of one key stand in one field.
constexpr std::string_view kBetween = "; ";

std::string text_in(const kinds::Slot& slot) {
  if (const auto* const title = std::get_if<kinds::Title>(&slot)) return title->scene->title;
  std::string text;
  for (const std::string& each : texts_of(slot)) {
    text += (text.empty() ? "" : std::string(kBetween)) + each;
  }
  return text;
}

/// Throws Error (Input).
void set_text(const kinds::Slot& slot, const Option& option, const std::string& text,
              const Scene& scene) {
  if (const auto* const title = std::get_if<kinds::Title>(&slot)) {
    title->scene->title = text;
    return;
  }
  const bool cleared = clear_slot(slot);
  if (text.empty() && cleared) return;
  const std::string name(option.name);
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end =
        option.repeats ? std::min(text.find(kBetween, begin), text.size()) : text.size();
    const std::string part = text.substr(begin, end - begin);
    parse_slot(slot, {&scene, name, part});
    begin = end + kBetween.size();
  }
}

bool has_text(const kinds::Slot& slot) {
  return std::visit(
      [](const auto& kind) {
        return requires(const kinds::Given& given) {
          kind.parse(given);
        };
      },
      slot);
}

void flag_field(Desk& desk, const std::string& name, const std::string& what, const SlotIn& slot_in,
                bool now) {
  if (!ImGui::Checkbox(name.c_str(), &now)) return;
  desk.edit(what, [&](Scene& scene) { *std::get<kinds::Flag>(slot_in(scene)).value = now; });
}

void each_row_of(Table table, const std::function<void(const Option&)>& visit) {
  for (const Option& option : options()) {
    if (option.table == table && !is_in(kShown, option.name)) visit(option);
  }
}

/// The value that holds where the field of a key is empty.
std::string hint_of(const Option& option) {
  std::string usual = default_text(option);
  const bool is_of_scene =
      option.table != Table::Scene && std::ranges::any_of(options(), [&](const Option& other) {
        return other.table == Table::Scene && other.name == option.name;
      });
  return usual.empty() && is_of_scene ? "the scene's" : usual;
}

/// The words to choose from; first none, where the key can be without one.
std::vector<std::string> words_of(const Option& option, const SlotIn& slot_in, Scene scene) {
  std::vector<std::string> words = choices(option);
  if (!words.empty() && clear_slot(slot_in(scene))) words.insert(words.begin(), "");
  return words;
}

}  // namespace

void option_field(Desk& desk, const Option& option, const std::string& owner,
                  const SlotIn& slot_in) {
  Scene scene = desk.scene();
  const kinds::Slot slot = slot_in(scene);
  const std::string name(option.name);
  const std::string what = owner + name;
  if (const auto* const flag = std::get_if<kinds::Flag>(&slot)) {
    flag_field(desk, name, what, slot_in, *flag->value);
    return show_tip(for_panel(help_of(option)));
  }
  if (!has_text(slot)) return;
  const std::string before = text_in(slot);
  const std::vector<std::string> words = words_of(option, slot_in, desk.scene());
  const std::string hint = hint_of(option);
  const auto text = words.empty() ? text_field(name, before, desk.is_wrong(name), hint)
                                  : word_field(name, before, words, hint);
  show_tip(for_panel(help_of(option)));
  if (!text) return;
  try {
    set_text(slot, option, *text, desk.scene());
    if (text_in(slot) != before) desk.model.edit(std::move(scene), what);
  } catch (const Error& error) {
    desk.refused = error;
  }
}

void scene_fields(Desk& desk) {
  each_row_of(Table::Scene, [&](const Option& option) {
    if (is_in(kOfWindow, option.name)) return;
    option_field(desk, option, "", [&](Scene& scene) { return option.scene(scene); });
  });
  each_row_of(Table::Animation, [&](const Option& option) {
    if (!desk.scene().animation) return;
    option_field(desk, option, "", [&](Scene& scene) { return option.scene(scene); });
  });
}

void camera_fields(Desk& desk) {
  each_row_of(Table::Camera, [&](const Option& option) {
    option_field(desk, option, "camera", [&](Scene& scene) { return option.scene(scene); });
  });
}

void surface_fields(Desk& desk, std::size_t index) {
  each_row_of(Table::Surface, [&](const Option& option) {
    option_field(desk, option, "surface " + std::to_string(index),
                 [&](Scene& scene) { return option.surface(scene.surfaces[index]); });
  });
}

void curve_fields(Desk& desk, std::size_t index) {
  const std::string owner = "curve " + std::to_string(index);
  each_row_of(Table::Stroke, [&](const Option& option) {
    option_field(desk, option, owner,
                 [&](Scene& scene) { return option.stroke(scene.curves[index]); });
  });
}

void point_fields(Desk& desk, std::size_t index) {
  const std::string owner = "point " + std::to_string(index);
  each_row_of(Table::Stroke, [&](const Option& option) {
    option_field(desk, option, owner,
                 [&](Scene& scene) { return option.stroke(scene.points[index]); });
  });
}

}  // namespace saddle
