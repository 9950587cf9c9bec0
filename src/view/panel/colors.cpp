#include "view/panel/colors.h"

namespace saddle {
namespace {

const Inks kOnDark{{1.0F, 0.6F, 0.55F, 1}, {1.0F, 0.78F, 0.4F, 1}, {0.78F, 0.78F, 0.82F, 1}};
const Inks kOnLight{{0.62F, 0.05F, 0.05F, 1}, {0.42F, 0.25F, 0.0F, 1}, {0.26F, 0.26F, 0.3F, 1}};

/// A ground on which something can be pressed, as it rests, below the pointer, and pressed.
struct Grounds {
  ImVec4 resting;
  ImVec4 hovered;
  ImVec4 active;
};
const Grounds kDarkGrounds{
    {0.08F, 0.15F, 0.25F, 1}, {0.1F, 0.22F, 0.38F, 1}, {0.1F, 0.25F, 0.47F, 1}};
const Grounds kLightGrounds{{1, 1, 1, 1}, {0.8F, 0.9F, 1, 1}, {0.65F, 0.82F, 1, 1}};
/// Buttons, headers and what is chosen of a list: other than fields.
const ImVec4 kDarkButton{0.2F, 0.23F, 0.28F, 1};
const ImVec4 kLightButton{0.84F, 0.88F, 0.94F, 1};

void use(const Grounds& grounds, const ImVec4& button) {
  constexpr float kUnusable = 0.7F;
  ImGui::GetStyle().DisabledAlpha = kUnusable;
  auto& colors = ImGui::GetStyle().Colors;
  colors[ImGuiCol_FrameBg] = grounds.resting;
  colors[ImGuiCol_Button] = colors[ImGuiCol_Header] = button;
  for (const int i : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered}) {
    colors[i] = grounds.hovered;
  }
  for (const int i : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive,
                      ImGuiCol_TextSelectedBg}) {
    colors[i] = grounds.active;
  }
  // The picture does not shine through.
  for (const int i : {ImGuiCol_WindowBg, ImGuiCol_PopupBg}) colors[i].w = 1;
}

/// Texts of sliders stand on their handles, too.
void use_handles(const ImVec4& resting, const ImVec4& active) {
  auto& colors = ImGui::GetStyle().Colors;
  colors[ImGuiCol_SliderGrab] = resting;
  colors[ImGuiCol_SliderGrabActive] = active;
}

}  // namespace

void use_dark_colors() {
  ImGui::StyleColorsDark();
  use(kDarkGrounds, kDarkButton);
  auto& colors = ImGui::GetStyle().Colors;
  colors[ImGuiCol_TextDisabled] = {0.72F, 0.72F, 0.72F, 1};
  use_handles({0.22F, 0.44F, 0.74F, 1}, {0.24F, 0.46F, 0.76F, 1});
}

void use_light_colors() {
  ImGui::StyleColorsLight();
  use(kLightGrounds, kLightButton);
  auto& colors = ImGui::GetStyle().Colors;
  colors[ImGuiCol_TextDisabled] = {0.28F, 0.28F, 0.28F, 1};
  colors[ImGuiCol_PopupBg] = colors[ImGuiCol_WindowBg];
  colors[ImGuiCol_CheckMark] = {0.15F, 0.4F, 0.75F, 1};
  use_handles({0.3F, 0.5F, 0.8F, 1}, {0.27F, 0.47F, 0.77F, 1});
}

const Inks& inks() {
  constexpr float kMiddle = 0.5F;
  return ImGui::GetStyleColorVec4(ImGuiCol_WindowBg).x < kMiddle ? kOnDark : kOnLight;
}

}  // namespace saddle
