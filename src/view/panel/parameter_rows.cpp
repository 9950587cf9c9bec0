#include "view/panel/parameter_rows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "scene/model/values.h"
#include "view/model/sliders.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

/// Widths of the fields beside a slider, in letters.
constexpr float kValueLetters = 6;
constexpr float kEndLetters = 3;

/// A definition of the scene, or of a surface.
struct ParameterRow {
  ParameterPlace place;
  std::string what;  ///< for undo()
};

Definition& definition_in(Scene& scene, const ParameterPlace& place) {
  return *find_definition(scene, place);
}

void delete_row(const Desk& desk, const ParameterRow& row) {
  desk.edit("", [&](Scene& scene) {
    std::erase_if(definitions_of(scene, row.place.surface),
                  [&](const Definition& d) { return d.name == row.place.name; });
    std::erase_if(sliders_of(scene, row.place.surface),
                  [&](const Slider& s) { return s.name == row.place.name; });
  });
}

void show_text(Desk& desk, const ParameterRow& row, const std::string& text, float letters,
               bool wrong) {
  if (const auto changed = bare_field("##text", text, letters, wrong)) {
    desk.edit(row.what, [&](Scene& scene) { definition_in(scene, row.place).text = *changed; });
  }
}

void show_end(Desk& desk, const ParameterRow& row, const char* id, double value,
              Number Slider::*end) {
  const auto text = bare_field(id, format_number(value), kEndLetters);
  if (!text) return;
  double number = 0;
  const auto [rest, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  if (error != std::errc() || rest != text->data() + text->size() || number == value) return;
  desk.edit(row.what + id, [&](Scene& scene) { slider_in(scene, row.place).*end = number; });
}

/// The names that a parameter chooses from.
void show_choices(Desk& desk, const ParameterRow& row, const std::vector<std::string>& choices,
                  double number) {
  const auto chosen = static_cast<std::size_t>(std::max(0.0, number));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - icons_width(1));
  if (!ImGui::BeginCombo("##choice", chosen < choices.size() ? choices[chosen].c_str() : ""))
    return;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    if (!ImGui::Selectable(choices[k].c_str(), k == chosen)) continue;
    desk.edit(row.what,
              [&](Scene& scene) { definition_in(scene, row.place).text = std::to_string(k); });
  }
  ImGui::EndCombo();
}

/// The names of manners, in their order.
const std::vector<std::string>& manner_names() {
  static const std::vector<std::string> names{"to and fro", "again and again", "once"};
  return names;
}

/// The step of a slider and the manner of playing, in a window of their own.
void show_manner(Desk& desk, const ParameterRow& row, const Slider& ends) {
  if (!ImGui::BeginPopup("##how")) return;
  constexpr float kLetters = 14;
  ImGui::Dummy({kLetters * ImGui::GetFontSize(), 0});
  const std::string step = ends.step > 0 ? format_number(ends.step) : "";
  if (const auto text = text_field("step", step, false, "round")) {
    double number = 0;
    const auto [rest, error] = std::from_chars(text->data(), text->data() + text->size(), number);
    const bool is_number = error == std::errc() && rest == text->data() + text->size();
    const bool is_step = text->empty() || (is_number && number >= 0 && std::isfinite(number));
    if (is_step && number != ends.step) {
      desk.edit(row.what + "step",
                [&](Scene& scene) { slider_in(scene, row.place).step = number; });
    }
  }
  ViewState view = desk.model.view();
  const std::string& manner = manner_names()[static_cast<std::size_t>(view.manner)];
  if (const auto other = word_field("plays", manner, manner_names())) {
    const auto found = std::ranges::find(manner_names(), *other) - manner_names().begin();
    view.manner = static_cast<PlayManner>(found);
    desk.model.change_view(view, "");
  }
  ImGui::EndPopup();
}

/// From end to end, in round steps.
void show_slider(Desk& desk, const ParameterRow& row, double number) {
  const Slider ends = slider_of(desk.scene(), row.place, number);
  const double low = ends.min;
  const double high = ends.max;
  show_end(desk, row, "##min", low, &Slider::min);
  ImGui::SameLine();
  const float right = ImGui::GetFontSize() / 2 * kEndLetters +
                      2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x +
                      icons_width(2);
  ImGui::SetNextItemWidth(std::max(1.0F, ImGui::GetContentRegionAvail().x - right));
  double value = number;
  if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &low, &high, "")) {
    const std::string text = rounded_text(value, ends, kDraggedSteps);
    desk.edit(row.what, [&](Scene& scene) {
      slider_in(scene, row.place);  // its ends stay while the value changes
      definition_in(scene, row.place).text = text;
    });
  }
  bool asks = ImGui::IsItemClicked(ImGuiMouseButton_Right);
  show_tip("right click: its step, and how it plays");
  ImGui::SameLine();
  show_end(desk, row, "##max", high, &Slider::max);
  ImGui::SameLine();
  const bool plays = desk.model.played() == row.place;
  const char* const tip = plays ? "stop" : "play from end to end; a right click chooses how";
  if (icon_button(plays ? Icon::Stop : Icon::Play, tip)) {
    desk.model.play(plays ? std::nullopt : std::optional(row.place));
  }
  asks = asks || ImGui::IsItemClicked(ImGuiMouseButton_Right);
  if (asks) ImGui::OpenPopup("##how");
  show_manner(desk, row, ends);
}

void show_definition(Desk& desk, const ParameterRow& row) {
  Scene scene = desk.scene();
  const Definition definition = definition_in(scene, row.place);
  const std::string name = display_name(definition);
  const bool wrong = desk.is_wrong(name) || desk.is_wrong(definition.name);
  show_name(name + (definition.is_function ? " =" : ""));
  const auto number = plain_number(definition);
  const std::vector<std::string> choices =
      number ? slider_of(scene, row.place, *number).choices : std::vector<std::string>();
  if (!choices.empty()) {
    show_choices(desk, row, choices, *number);
  } else if (number) {
    show_text(desk, row, definition.text, kValueLetters, wrong);
    ImGui::SameLine();
    show_slider(desk, row, *number);
  } else {
    const float width =
        ImGui::GetContentRegionAvail().x - icons_width(1) - 2 * ImGui::GetStyle().FramePadding.x;
    show_text(desk, row, definition.text, 2 * width / ImGui::GetFontSize(), wrong);
  }
  ImGui::SameLine();
  if (icon_button(Icon::Delete, "delete it (Ctrl-Z brings it back)")) delete_row(desk, row);
}

}  // namespace

void show_parameters(Desk& desk, std::optional<std::size_t> surface) {
  std::vector<std::string> names;
  Scene scene = desk.scene();
  for (const Definition& definition : definitions_of(scene, surface)) {
    names.push_back(definition.name);
  }
  for (const std::string& name : names) {
    const std::string owner = surface ? desk.scene().surfaces[*surface].name : "";
    ImGui::PushID(name.c_str());
    show_definition(desk, {{surface, name}, owner + name});
    ImGui::PopID();
  }
}

}  // namespace saddle
