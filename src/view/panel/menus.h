// The menus, from the table of actions.
#pragma once

#include <functional>
#include <optional>

#include "view/model/actions.h"

namespace saddle {

/// In a window with a menu bar. `can`: whether an action would do anything; `is_on`: whether what
/// it switches is on. Returns the action that was chosen.
std::optional<Action> show_menus(const std::function<bool(Action)>& can,
                                 const std::function<bool(Action)>& is_on);

}  // namespace saddle
