// Numbers as people write them.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace saddle {

/// With up to `digits` digits, and no more than it needs.
inline std::string number_text(double value, int digits = 6) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

}  // namespace saddle
