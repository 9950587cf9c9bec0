// Rows for the lights of a scene.
#pragma once

#include "view/panel/desk.h"

namespace saddle {

void show_lights(Desk& desk);

}  // namespace saddle
