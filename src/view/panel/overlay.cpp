#include "view/panel/overlay.h"

#include <imgui.h>

namespace saddle {
namespace {

constexpr ImU32 kMarkColor = IM_COL32(255, 80, 60, 255);
constexpr ImU32 kMarkRim = IM_COL32(0, 0, 0, 255);

void show_text(const char* id, const std::string& text, const ImVec2& place, const ImVec2& pivot) {
  if (text.empty()) return;
  ImGui::SetNextWindowPos(place, ImGuiCond_Always, pivot);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin(id, nullptr, kFlags)) {
    // Carets and columns want letters of one width: the last font.
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts.back());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
  }
  ImGui::End();
}

}  // namespace

void show_overlay(const Overlay& overlay) {
  const auto left = static_cast<float>(overlay.left);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float middle = (left + size.x) / 2;
  show_text("message", overlay.message, {middle, size.y - ImGui::GetFontSize()}, {0.5F, 1});
  show_text("help", overlay.help, {middle, size.y / 2}, {0.5F, 0.5F});
  ImDrawList& background = *ImGui::GetBackgroundDrawList();
  if (!overlay.mark) return;
  const ImVec2 at{left + static_cast<float>(overlay.mark->x), static_cast<float>(overlay.mark->y)};
  if (at.x < left) return;
  const float radius = ImGui::GetFontSize() / 4;
  background.AddCircleFilled(at, radius + 1.5F, kMarkRim);
  background.AddCircleFilled(at, radius, kMarkColor);
}

}  // namespace saddle
