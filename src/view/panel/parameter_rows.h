// Rows for definitions: a slider for a number, a field for a formula.
#pragma once

#include <cstddef>
#include <optional>

#include "view/panel/desk.h"

namespace saddle {

/// The definitions of the scene, or those of a surface's own.
void show_parameters(Desk& desk, std::optional<std::size_t> surface = {});

}  // namespace saddle
