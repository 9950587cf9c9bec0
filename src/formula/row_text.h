// Texts of rows of ops.def as code of another language.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace saddle {

/// `text` with the words a, b and c replaced by the arguments.
std::string with_arguments(std::string_view text, const std::array<std::string, 3>& arguments);

}  // namespace saddle
