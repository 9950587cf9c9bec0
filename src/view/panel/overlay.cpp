#include "view/panel/overlay.h"

#include <algorithm>

#include <imgui.h>

#include "view/panel/widgets.h"

namespace saddle {
namespace {

constexpr ImU32 kMarkColor = IM_COL32(255, 80, 60, 255);
constexpr ImU32 kMarkRim = IM_COL32(0, 0, 0, 255);

/// Lines of a message; the rest of a longer one is left out.
constexpr std::size_t kMostLines = 12;

/// Letters in a window that is low, as a share of their size.
constexpr float kSmallest = 0.5F;

std::string first_lines(const std::string& text) {
  std::size_t end = 0;
  for (std::size_t line = 0; line < kMostLines; ++line) {
    end = text.find('\n', end);
    if (end == std::string::npos) return text;
    ++end;
  }
  return text.substr(0, end) + "...";
}

/// Text in a window that takes no keys and covers no more than the width between two places.
void show_text(const char* id, const std::string& text, const ImVec2& place, const ImVec2& pivot,
               float width) {
  if (text.empty()) return;
  ImGui::SetNextWindowPos(place, ImGuiCond_Always, pivot);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin(id, nullptr, kFlags)) {
    // Carets and columns want letters of one width: the last font.
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts.back());
    // Smaller letters where there is no room for all lines.
    ImGui::SetWindowFontScale(1);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float height = ImGui::GetIO().DisplaySize.y - 3 * ImGui::GetStyle().WindowPadding.y;
    const float share = size.y > height ? std::min(height / size.y, width / size.x) : 1;
    ImGui::SetWindowFontScale(std::clamp(share, kSmallest, 1.0F));
    ImGui::PushTextWrapPos(width);
    ImGui::TextUnformatted(beginning_of(text).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
  }
  ImGui::End();
}

}  // namespace

void show_overlay(const Overlay& overlay) {
  const auto left = static_cast<float>(overlay.left);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float middle = (left + size.x) / 2;
  const float width = std::max(1.0F, size.x - left - 2 * ImGui::GetFontSize());
  show_text("message", first_lines(overlay.message), {middle, size.y - ImGui::GetFontSize()},
            {0.5F, 1}, width);
  show_text("help", overlay.help, {middle, size.y / 2}, {0.5F, 0.5F}, width);
  ImDrawList& background = *ImGui::GetBackgroundDrawList();
  if (!overlay.mark) return;
  const ImVec2 at{left + static_cast<float>(overlay.mark->x), static_cast<float>(overlay.mark->y)};
  if (at.x < left) return;
  const float radius = ImGui::GetFontSize() / 4;
  if (overlay.is_mark_hidden) {
    background.AddCircle(at, radius, kMarkRim, 0, 3);
    background.AddCircle(at, radius, kMarkColor, 0, 1.5F);
    return;
  }
  background.AddCircleFilled(at, radius + 1.5F, kMarkRim);
  background.AddCircleFilled(at, radius, kMarkColor);
}

}  // namespace saddle
