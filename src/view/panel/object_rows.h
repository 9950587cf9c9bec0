// The list of what a scene has: a row for each surface, curve and point, which unfolds into its
// formulas, and further into all of its keys.
#pragma once

#include "view/panel/desk.h"

namespace saddle {

void show_surfaces(Desk& desk);
void show_curves(Desk& desk);
void show_points(Desk& desk);

}  // namespace saddle
