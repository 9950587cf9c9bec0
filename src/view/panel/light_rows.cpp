#include "view/panel/light_rows.h"

#include <cstddef>
#include <string>
#include <vector>

#include <imgui.h>

#include "base/format.h"
#include "view/panel/number_fields.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

/// A light of the scene, with the name that messages have for it.
struct LightRow {
  std::size_t index;
  std::string what;

  Light& in(Scene& scene) const { return scene.lights[index]; }
};

void edit_light(const Desk& desk, const LightRow& row, const std::string& part,
                const auto& change) {
  desk.edit(row.what + part, [&](Scene& scene) { change(row.in(scene)); });
}

void show_frame(Desk& desk, const LightRow& row, const Light& light) {
  std::vector<std::string> frames{"eye", "world"};
  for (const SceneNode& node : desk.scene().nodes) frames.push_back(node.name);
  if (const auto frame = word_field("frame", light.frame, frames)) {
    edit_light(desk, row, "frame", [&](Light& l) { l.frame = *frame; });
  }
  const std::string kind = light.directional ? "direction" : "position";
  if (const auto other = word_field("from a", kind, {"position", "direction"})) {
    edit_light(desk, row, "kind", [&](Light& l) { l.directional = *other == "direction"; });
  }
  vector_field(desk, kind, row.what + kind,
               [&row](Scene& scene) -> Vector& { return row.in(scene).position; });
}

void show_spot(Desk& desk, const LightRow& row, const Light& light) {
  bool is_spot = light.spot.has_value();
  if (ImGui::Checkbox("spot", &is_spot)) {
    edit_light(desk, row, "spot", [&](Light& l) {
      if (is_spot) {
        l.spot.emplace();
      } else {
        l.spot.reset();
      }
    });
    return;
  }
  if (!is_spot) return;
  const std::string what = row.what + "spot: ";
  vector_field(desk, "direction", what + "direction",
               [&](Scene& scene) -> Vector& { return row.in(scene).spot->direction; });
  number_field(desk, "cutoff", what + "cutoff",
               [&](Scene& scene) -> Number& { return row.in(scene).spot->cutoff; });
  number_field(desk, "exponent", what + "exponent",
               [&](Scene& scene) -> Number& { return row.in(scene).spot->exponent; });
  bool is_soft = light.spot->inner.has_value();
  if (ImGui::Checkbox("soft edge", &is_soft)) {
    edit_light(desk, row, "inner", [&](Light& l) {
      l.spot->inner = is_soft ? std::optional(Number(0.8 * l.spot->cutoff)) : std::nullopt;
    });
    return;
  }
  if (!is_soft) return;
  number_field(desk, "inner", what + "inner",
               [&](Scene& scene) -> Number& { return *row.in(scene).spot->inner; });
  using Falloff = Spot::Falloff;
  const std::string falloff = light.spot->falloff == Falloff::Smooth ? "smooth" : "linear";
  if (const auto other = word_field("falloff", falloff, {"linear", "smooth"})) {
    edit_light(desk, row, "spot: falloff", [&](Light& l) {
      l.spot->falloff = *other == "smooth" ? Falloff::Smooth : Falloff::Linear;
    });
  }
}

void show_attenuation(Desk& desk, const LightRow& row, const Light& light) {
  bool has_range = light.attenuation.range.has_value();
  if (ImGui::Checkbox("reaches as far as", &has_range)) {
    edit_light(desk, row, "range", [&](Light& l) {
      l.attenuation.range = has_range ? std::optional(Number(50)) : std::nullopt;
    });
    return;
  }
  const std::string what = row.what + "attenuation: ";
  if (has_range) {
    number_field(desk, "range", what + "range",
                 [&](Scene& scene) -> Number& { return *row.in(scene).attenuation.range; });
    return;
  }
  const auto part = [&](const char* name, Number Attenuation::*number) {
    number_field(desk, name, what + name, [&, number](Scene& scene) -> Number& {
      return row.in(scene).attenuation.*number;
    });
  };
  part("constant", &Attenuation::constant);
  part("linear", &Attenuation::linear);
  part("quadratic", &Attenuation::quadratic);
}

/// Colour, eye, name, buttons; true if the row is unfolded and its light still there.
bool show_row(Desk& desk, const LightRow& row, const Light& light) {
  if (const auto color = color_chip("##color", light.color)) {
    edit_light(desk, row, "color", [&](Light& l) { l.color = *color; });
  }
  ImGui::SameLine();
  const bool is_on = light.enabled != 0;
  if (icon_button(is_on ? Icon::Eye : Icon::ClosedEye, "on or off")) {
    edit_light(desk, row, "", [&](Light& l) { l.enabled = is_on ? 0 : 1; });
  }
  ImGui::SameLine();
  const auto [is_open, icons] = fold_row(formatted("light %zu", row.index + 1), 2);
  if (icons > 1) {
    if (icon_button(Icon::Copy, "a copy of it")) {
      desk.edit("", [&](Scene& scene) { scene.lights.push_back(light); });
      return false;
    }
    ImGui::SameLine();
  }
  if (icons > 0 && icon_button(Icon::Delete, "delete it (Ctrl-Z brings it back)")) {
    desk.edit("", [&](Scene& scene) {
      scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(row.index));
    });
    return false;
  }
  return is_open;
}

}  // namespace

void show_lights(Desk& desk) {
  bool any = false;
  for (std::size_t i = 0; i < desk.scene().lights.size(); ++i) {
    const Light light = desk.scene().lights[i];
    const LightRow row{i, formatted("light %zu: ", i + 1)};
    any = any || light.enabled != 0;
    ImGui::PushID("light");
    ImGui::PushID(static_cast<int>(i));
    if (show_row(desk, row, light)) {
      show_frame(desk, row, light);
      show_attenuation(desk, row, light);
      show_spot(desk, row, light);
    }
    ImGui::PopID();
    ImGui::PopID();
  }
  if (!any) show_wrapped(Tone::Warning, "all lights are off: surfaces have only their own light");
}

}  // namespace saddle
