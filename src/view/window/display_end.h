// The end of the display, from whatever is being done: X then ends the process.
#pragma once

#include <functional>

namespace saddle {

/// `act` is called if the display goes, and the process then ends with status 1. Both the window
/// and `act` must live until then. Before libX11 1.7, and where the display is no X, it is not
/// called.
void call_when_display_goes(const std::function<void()>& act);

}  // namespace saddle
