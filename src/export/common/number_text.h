// Numbers as text, quicker than std::to_chars where most coordinates and indices are.
#pragma once

#include <cstddef>
#include <cstdint>

namespace saddle {

/// Characters of a number's text at most, with room for copies of eight.
inline constexpr int kMostNumberText = 32;

/// Writes the shortest text that reads back as this float, the nearest one of those: the same that
/// std::to_chars(begin, end, x) gives. Returns its end. `begin` has room for kMostNumberText
/// characters.
char* write_float(char* begin, float x);

/// Writes a number in decimal digits. Returns their end. `begin`: as for write_float().
char* write_whole(char* begin, std::size_t number);

/// Writes "0." and six digits. `millionths`: below 10^6.
char* write_millionths(char* begin, std::uint32_t millionths);

/// Writes it twice with a letter between. `begin` has twice the room.
char* write_twice(char* begin, std::size_t number, char between);

}  // namespace saddle
