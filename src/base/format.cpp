#include "base/format.h"

#include <cstdarg>
#include <cstddef>
#include <cstdio>

namespace saddle {

std::string formatted(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::va_list again;
  va_copy(again, arguments);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, arguments)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format,
                 again);  // the last one is the end's own '\0'
  va_end(again);
  va_end(arguments);
  return text;
}

std::string rounded(double value, int digits) {
  return formatted("%.*g", digits, value + 0.0);  // + 0: no "-0"
}

}  // namespace saddle
