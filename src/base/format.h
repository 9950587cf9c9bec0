// Text with numbers in it.
#pragma once

#include <string>

namespace saddle {

/// The text that printf would write.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// A number rounded to so many digits, without zeros at its end; 0 has no sign.
std::string rounded(double value, int digits);

}  // namespace saddle
