// A float of 10^-3 to 10^5 times a power of ten has nine digits before its point, and fits into 64
// bits with all of its binary places. So do the middles between it and its neighbours: whatever is
// between these reads back as the float. Source of that idea: G. Steele, J. White, "How to print
// floating-point numbers accurately", 1990. Most floats need seven to nine digits; those that need
// fewer, and powers of two, whose neighbours are not as far from both sides, are std::to_chars'.
#include "export/common/number_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace saddle {
namespace {

constexpr float kLeast = 1e-3F;  // smaller ones may be shorter with an exponent,
constexpr float kMost = 1e5F;    // as from here on
constexpr int kFractionBits = 23;
constexpr int kBias = 127 + kFractionBits;
constexpr int kDigits = 9;  // they tell all floats apart
constexpr std::uint32_t kTooLong = 1'000'000'000;

constexpr std::array<std::uint64_t, 12> kPowers = {
    1,         10,         100,         1'000,         10'000,         100'000,
    1'000'000, 10'000'000, 100'000'000, 1'000'000'000, 10'000'000'000, 100'000'000'000};

/// Digits of which the last ones are zeros.
struct Digits {
  std::uint32_t count;  ///< with kDigits digits
  int behind_point;     ///< of these
  int zeros;            ///< at the end
};

/// Where the powers of ten are among floats with one exponent.
struct Binade {
  int places;  ///< kDigits less the digits before the point; negative ones are zeros behind it
  float next;  ///< from this float on there is one place less
};

/// By exponents, from that of kLeast, 2^-10, to that of kMost, 2^16.
constexpr int kFirstExponent = 117;
constexpr auto kBinades = [] {
  constexpr std::array kTens = {1e-2F, 1e-1F, 1.F, 1e1F, 1e2F, 1e3F, 1e4F, kMost};
  std::array<Binade, 27> binades{};
  float begin = 0x1p-10F;
  for (Binade& binade : binades) {
    std::size_t below = 0;
    while (below + 1 < kTens.size() && kTens[below] <= begin) ++below;
    binade = {kDigits + 2 - static_cast<int>(below), kTens[below]};
    begin *= 2;
  }
  return binades;
}();

/// Nothing for a float that is left to std::to_chars. `x`: kLeast to kMost.
std::optional<Digits> shortest(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t fraction = bits & ((1U << kFractionBits) - 1);
  const std::uint64_t whole = fraction | 1U << kFractionBits;
  const Binade& binade = kBinades[(bits >> kFractionBits) - kFirstExponent];
  const int places = binade.places - (x >= binade.next ? 1 : 0);
  // x * 10^places, in units of 2^-shift. Half the way to a neighbour is `power` of these.
  const int shift = kBias + 1 - static_cast<int>(bits >> kFractionBits);
  const std::uint64_t power = kPowers[static_cast<std::size_t>(places)];
  const std::uint64_t exact = 2 * whole * power;
  const std::uint64_t odd = whole & 1;  // a middle reads back as the even neighbour
  const std::uint64_t part = (std::uint64_t{1} << shift) - 1;
  const auto low = static_cast<std::uint32_t>((exact - power + odd + part) >> shift);
  const auto high = static_cast<std::uint32_t>((exact + power - odd) >> shift);
  const bool is_tens = high / 10 * 10 >= low;
  const bool is_hundreds = high / 100 * 100 >= low;
  const bool is_thousands = high / 1000 * 1000 >= low;
  if (is_thousands || fraction == 0) return std::nullopt;
  const int zeros = static_cast<int>(is_tens) + static_cast<int>(is_hundreds);
  // The nearest multiple; of two that are as near, the even one. Division by 1, 10 or 100 is a
  // product: the reciprocals are right for all numbers below 2^30.
  constexpr std::array<std::uint64_t, 3> kReciprocal = {std::uint64_t{1} << 34, 13743895348,
                                                        10995116278};
  constexpr std::array kReciprocalShift = {34, 37, 40};
  const auto z = static_cast<std::size_t>(zeros);
  const auto digits = static_cast<std::uint32_t>(exact >> shift);
  const std::uint64_t multiple = digits * kReciprocal[z] >> kReciprocalShift[z];
  const std::uint64_t step = kPowers[z];
  const std::uint64_t twice_rest = 2 * (((digits - multiple * step) << shift) + (exact & part));
  const std::uint64_t whole_step = step << shift;
  const bool is_up = twice_rest + (multiple & 1) > whole_step;
  const std::uint64_t count = (multiple + (is_up ? 1 : 0)) * step;
  if (count >= kTooLong) return std::nullopt;
  return Digits{static_cast<std::uint32_t>(count), places, zeros};
}

constexpr std::uint64_t kZeros = 0x3030303030303030;  // eight letters
constexpr std::uint32_t kEightDigits = 100'000'000;

/// The eight digits of a number below 10^8, 0 to 9, the first one in the lowest byte.
std::uint64_t eight_digits(std::uint32_t number) {
  const std::uint64_t fours = number / 10'000 | std::uint64_t{number % 10'000} << 32;
  // Quotients by 100 and by 10 in parts of the word, as products.
  const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x7F0000007F;
  const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
  const std::uint64_t tens = (twos * 103 >> 10) & 0x0F000F000F000F;
  return (tens | (twos - 10 * tens) << 8);
}

void put_eight(char* at, std::uint64_t digits) {
  if constexpr (std::endian::native == std::endian::big) {
    for (int i = 0; i < 8; ++i) at[i] = static_cast<char>(digits >> 8 * i);
  } else {
    std::memcpy(at, &digits, sizeof(digits));
  }
}

/// The letters of a number of at most eight digits, the first one in the lowest byte.
struct ShortText {
  std::uint64_t letters;
  int count;
};

bool is_short(std::size_t number) {
  return number > 0 && number < kEightDigits;
}

ShortText short_text(std::size_t number) {
  const std::uint64_t digits = eight_digits(static_cast<std::uint32_t>(number));
  const int zeros = std::countr_zero(digits) / 8;
  return {(digits + kZeros) >> 8 * zeros, 8 - zeros};
}

char* put_short(char* at, const ShortText& text) {
  put_eight(at, text.letters);
  return at + text.count;
}

}  // namespace

char* write_float(char* begin, float x) {
  const float size = std::abs(x);
  const bool is_usual = size >= kLeast && size < kMost;
  const std::optional<Digits> usual = is_usual ? shortest(size) : std::nullopt;
  if (!usual) return std::to_chars(begin, begin + kMostNumberText, x).ptr;
  *begin = '-';
  begin += x < 0 ? 1 : 0;
  const auto first = static_cast<char>('0' + usual->count / kEightDigits);
  const std::uint64_t rest = eight_digits(usual->count % kEightDigits) + kZeros;
  const int before = kDigits - usual->behind_point;
  if (before > 0) {
    *begin = first;
    put_eight(begin + 1, rest);
    begin[before] = '.';
    put_eight(begin + before + 1, rest >> 8 * (before - 1));
    return begin + 1 + kDigits - usual->zeros;
  }
  std::copy_n("0.00", 4, begin);
  begin += 2 - before;
  *begin = first;
  put_eight(begin + 1, rest);
  return begin + kDigits - usual->zeros;
}

char* write_whole(char* begin, std::size_t number) {
  if (!is_short(number)) return std::to_chars(begin, begin + kMostNumberText, number).ptr;
  return put_short(begin, short_text(number));
}

char* write_millionths(char* begin, std::uint32_t millionths) {
  begin[0] = '0';
  begin[1] = '.';
  put_eight(begin + 2,
            (eight_digits(millionths) + kZeros) >> 16);  // two zeros are before six digits
  return begin + 8;
}

char* write_twice(char* begin, std::size_t number, char between) {
  if (!is_short(number)) {
    begin = write_whole(begin, number);
    *begin++ = between;
    return write_whole(begin, number);
  }
  const ShortText text = short_text(number);
  begin = put_short(begin, text);
  *begin++ = between;
  return put_short(begin, text);
}

}  // namespace saddle
