// The colours of the panel, dark or light. Text has a contrast of at least 4.5 on any ground that
// it may stand on, also while a pointer is over it; text of what cannot be used has at least 3.
#pragma once

#include <imgui.h>

namespace saddle {

/// Sets those of the current style.
void use_dark_colors();
void use_light_colors();

/// The colours of letters on the grounds of the current style.
struct Inks {
  ImVec4 wrong;
  ImVec4 warning;
  ImVec4 quiet;
};
const Inks& inks();

}  // namespace saddle
