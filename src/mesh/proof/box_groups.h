// Groups of boxes that touch: around one feature each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/parameter_box.h"

namespace saddle {

/// For each box the number of the first box of its group. Boxes that share a corner touch.
std::vector<std::uint32_t> groups_of(std::span<const ParameterBox> boxes);

}  // namespace saddle
