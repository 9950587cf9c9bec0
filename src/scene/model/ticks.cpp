// Ticks are multiples k * f * 10^e of a step: all texts are made from these whole numbers, so that
// none has digits that rounding made.
#include "scene/model/ticks.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/format.h"

namespace saddle {
namespace {

/// Numbers from here on, and steps below, are written with a power of ten apart.
constexpr int kLongExponent = 5;
/// More significant digits than this in a tick are too long to read: an offset is taken out.
constexpr int kMostDigits = 5;
/// Decimal digits that every double keeps.
constexpr int kOffsetDigits = 15;
/// A tick this much of a step outside is on the end but for rounding.
constexpr double kOnEnd = 1e-9;

/// With the minus sign that typography has.
std::string with_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return text;
}

std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> kDigits = {"\u2070", "\u00b9", "\u00b2", "\u00b3",
                                                        "\u2074", "\u2075", "\u2076", "\u2077",
                                                        "\u2078", "\u2079"};
  std::string text;
  for (const char c : std::to_string(number)) {
    text += c == '-' ? std::string_view("\u207b") : kDigits[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

int exponent_of(double value) {
  return static_cast<int>(std::floor(std::log10(value)));
}

/// A step of factor * 10^exponent.
struct Step {
  int factor = 1;
  int exponent = 0;

  /// Exact where doubles are: powers of ten up to 10^22 and quotients by them.
  double times(double k) const {
    const double power = std::pow(10.0, std::abs(exponent));
    return exponent < 0 ? k * factor / power : k * factor * power;
  }
};

/// The smallest step of which `rough` is not more.
Step step_above(double rough) {
  Step step{1, exponent_of(rough)};
  for (const int factor : {1, 2, 5}) {
    step.factor = factor;
    if (step.times(1) >= rough * (1 - kOnEnd)) return step;
  }
  return {1, step.exponent + 1};
}

/// How numbers are shortened: (value - offset) / 10^exponent.
struct Shortening {
  int exponent = 0;
  std::int64_t offset = 0;  ///< in steps

  bool is_needed() const { return exponent != 0 || offset != 0; }
};

Shortening shorten(double first, double last, const Step& step) {
  Shortening result;
  double most = std::max(std::abs(first), std::abs(last));  // in steps
  if (most >= std::pow(10.0, kMostDigits) && most < 0x1p53) {
    // A multiple of the power of ten just above the range: it has few digits, and what is left
    // begins with zeros.
    const int exponent = exponent_of(step.times(std::max(last - first, 1.0))) + 1;
    const double whole = std::round(std::pow(10.0, exponent - step.exponent) / step.factor);
    result.offset = static_cast<std::int64_t>(std::floor(first / whole) * whole);
    most = last - static_cast<double>(result.offset);
  }
  const int largest = exponent_of(std::max(step.times(most), step.times(1)));
  if (largest >= kLongExponent || largest <= -kLongExponent + 1) result.exponent = largest;
  return result;
}

std::string note_of(const Shortening& how, const Step& step) {
  if (!how.is_needed()) return {};
  std::string note;
  if (how.exponent != 0) note = "\u00d710" + superscript(how.exponent);
  if (how.offset != 0) {
    const double offset = step.times(static_cast<double>(how.offset));
    const std::string digits = rounded(std::abs(offset), kOffsetDigits);
    note += (note.empty() ? "" : " ") + std::string(offset < 0 ? "\u2212 " : "+ ") + digits;
  }
  return note;
}

}  // namespace

Ticks ticks(double low, double high, int count) {
  Ticks result;
  const double length = high - low;
  if (!std::isfinite(low) || !std::isfinite(high) || !(length >= 0)) return result;
  if (length == 0) {
    result.ticks.push_back({low, with_minus(rounded(low, kMostDigits + 1))});
    return result;
  }
  if (!std::isfinite(length)) return result;
  const Step step = step_above(length / std::max(count, 1));
  const double unit = step.times(1);
  const double first = std::ceil(low / unit - kOnEnd);
  const double last = std::floor(high / unit + kOnEnd);
  if (!(unit > 0) || !(last >= first) || std::abs(first) > 0x1p53) return result;
  const Shortening how = shorten(first, last, step);
  const int decimals = std::max(0, how.exponent - step.exponent);
  for (double k = first; k <= last; ++k) {
    const double rest = (k - static_cast<double>(how.offset)) * step.factor;
    const double shown = rest * std::pow(10.0, step.exponent - how.exponent) + 0.0;  // no -0
    result.ticks.push_back({step.times(k) + 0.0, with_minus(formatted("%.*f", decimals, shown))});
  }
  result.note = note_of(how, step);
  return result;
}

}  // namespace saddle
