// The rows of nodes: their names, what they are in, and the steps that move what is in them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "view/panel/desk.h"

namespace saddle {

void show_nodes(Desk& desk);

/// The nodes that an object is in, each of which can be chosen; nothing where there are no nodes.
/// `what` as in Desk::edit().
void nodes_field(Desk& desk, const std::string& what,
                 const std::function<std::vector<std::string>&(Scene&)>& nodes_in);

}  // namespace saddle
