#include "view/panel/menus.h"

#include <imgui.h>

#include "view/panel/widgets.h"

namespace saddle {

std::optional<Action> show_menus(const std::function<bool(Action)>& can,
                                 const std::function<bool(Action)>& is_on) {
  std::optional<Action> chosen;
  if (!ImGui::BeginMenuBar()) return chosen;
  for (const Menu menu : {Menu::File, Menu::Edit, Menu::View, Menu::Look, Menu::Help}) {
    if (!ImGui::BeginMenu(title_of(menu))) continue;
    for (const ActionRow& row : action_table()) {
      if (row.menu != menu) continue;
      if (ImGui::MenuItem(row.name, row.key, is_on(row.action), can(row.action))) {
        chosen = row.action;
      }
      show_tip(row.help, TipPlace::BesideWindow);  // the menu's keys stay to be seen
    }
    ImGui::EndMenu();
  }
  ImGui::EndMenuBar();
  return chosen;
}

}  // namespace saddle
