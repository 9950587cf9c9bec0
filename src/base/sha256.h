// The hash by which a page names the scripts and styles that it allows.
// Source: National Institute of Standards and Technology, "Secure hash standard", FIPS 180-4, 2015.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace saddle {

std::array<std::uint8_t, 32> sha256(std::string_view bytes);

}  // namespace saddle
