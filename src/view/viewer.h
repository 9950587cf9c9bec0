// The viewer: a window that shows a scene, and a hand, a keyboard and a panel that change it.
#pragma once

#include "view/model.h"

namespace saddle {

/// Opens a window and returns when it is closed. Throws Error (Machine) without a display or
/// OpenGL 3.3.
void run_viewer(ViewerSetup setup);

}  // namespace saddle
