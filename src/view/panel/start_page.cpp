#include "view/panel/start_page.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <imgui.h>

#include "scene/model/gallery.h"
#include "view/panel/fields.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

/// The width of the column at the left, in half letters.
constexpr float kColumn = 17;

bool was_pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

void show_ways(StartPage& page) {
  constexpr std::array kWays{Action::New, Action::Open, Action::Gallery, Action::Restore,
                             Action::Help};
  for (const Action action : kWays) {
    if (action == Action::Restore && !page.has_work) continue;
    const ActionRow& row = row_of(action);
    if (ImGui::Button(row.name, {-1, 0})) page.action = action;
    show_tip(std::string(row.help) + (*row.key != 0 ? " (" + std::string(row.key) + ")" : ""));
  }
}

void show_recent(StartPage& page) {
  if (page.recent.empty()) return;
  ImGui::Dummy({0, ImGui::GetFontSize() / 2});
  ImGui::TextDisabled("recent files");
  for (const auto& path : page.recent) {
    ImGui::PushID(path.c_str());
    if (ImGui::Selectable(path.filename().c_str())) page.file = path;
    show_tip(path.string());
    ImGui::PopID();
  }
}

void move(StartPage& page, std::size_t columns) {
  const std::size_t last = gallery().size() - 1;
  std::size_t& at = page.selected;
  if (was_pressed(ImGuiKey_RightArrow)) at = std::min(at + 1, last);
  if (was_pressed(ImGuiKey_LeftArrow)) at -= at > 0 ? 1 : 0;
  if (was_pressed(ImGuiKey_DownArrow)) at = std::min(at + columns, last);
  if (was_pressed(ImGuiKey_UpArrow)) at -= at >= columns ? columns : 0;
}

/// A picture with its name below; true if it was pressed.
bool show_entry(const StartPage& page, std::size_t entry) {
  const std::string name(gallery()[entry].name);
  const ImVec2 size{static_cast<float>(page.thumbnail_width),
                    static_cast<float>(page.thumbnail_height)};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::BeginGroup();
  const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
  const bool is_selected = entry == page.selected;
  if (ImGui::IsItemHovered()) show_tip(name + ": " + std::string(gallery()[entry].description));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  list.AddRectFilled(corner, end, IM_COL32_BLACK);
  if (const unsigned texture = page.thumbnail(entry)) {
    // NOLINTNEXTLINE: ImGui's type of a texture is a pointer
    list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), corner, end);
  }
  const ImGuiCol rim = is_selected ? ImGuiCol_NavHighlight : ImGuiCol_Border;
  list.AddRect(corner, end, ImGui::GetColorU32(rim), 0, 0, is_selected ? 3.0F : 1.0F);
  list.AddText({corner.x, end.y + 2}, ImGui::GetColorU32(ImGuiCol_Text),
               shortened(name, size.x).c_str());
  ImGui::Dummy({size.x, ImGui::GetTextLineHeight()});
  ImGui::EndGroup();
  return pressed;
}

void show_gallery(StartPage& page, bool is_confirmed) {
  const float space = ImGui::GetStyle().ItemSpacing.x;
  const float width = static_cast<float>(page.thumbnail_width) + space;
  const auto columns =
      static_cast<std::size_t>(std::max(1.0F, (ImGui::GetContentRegionAvail().x + space) / width));
  const std::size_t before = page.selected;
  if (!is_popup_open()) move(page, columns);
  for (std::size_t entry = 0; entry < gallery().size(); ++entry) {
    if (entry % columns != 0) ImGui::SameLine();
    if (show_entry(page, entry)) page.entry = entry;
    if (entry == page.selected && page.selected != before) ImGui::SetScrollHereY();
  }
  if (is_confirmed && !is_popup_open()) page.entry = page.selected;
}

}  // namespace

void show_start_page(StartPage& page, bool is_confirmed) {
  page.entry.reset();
  page.file.reset();
  page.action.reset();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoNav |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::Begin("start", nullptr, kFlags);
  const float column = kColumn * ImGui::GetFontSize() / 2;
  ImGui::BeginChild("##ways", {column, 0}, false, ImGuiWindowFlags_NoNav);
  show_ways(page);
  show_recent(page);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("##gallery", {0, 0}, false, ImGuiWindowFlags_NoNav);
  show_gallery(page, is_confirmed);
  ImGui::EndChild();
  ImGui::End();
}

}  // namespace saddle
