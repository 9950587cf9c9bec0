#include "scene/toml/toml_writer.h"

#include <algorithm>

#include "base/format.h"
#include "scene/model/color.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

/// Integers have 64 bits in TOML, which this many digits always fit.
constexpr std::size_t kIntegerDigits = 18;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Drops the digits that `text` begins with, and says how many there were.
std::size_t skip_digits(std::string_view& text) {
  const std::size_t count = std::ranges::find_if_not(text, is_digit) - text.begin();
  text.remove_prefix(count);
  return count;
}

}  // namespace

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (byte < 0x20 || byte == 0x7f) {
      result += formatted("\\u%04X", static_cast<unsigned>(byte));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string toml_number(const Number& number) {
  if (!number.text.empty()) return toml_string(number.text);
  const std::string text = format_number(number.value);
  const bool integer = text.find_first_of(".e") == std::string::npos;
  return integer && text.size() > kIntegerDigits ? text + ".0" : text;
}

std::string toml_numbers(const std::vector<Number>& numbers) {
  std::string text;
  for (const Number& n : numbers) text += (text.empty() ? "[" : ", ") + toml_number(n);
  return text + "]";
}

std::string toml_vector(const Vector& vector) {
  return toml_numbers({vector.x, vector.y, vector.z});
}

std::string toml_color(const Color& color) {
  const std::string text = format_color(color);
  if (parse_color("color", text) == color) return toml_string(text);
  return color.a == Number(1) ? toml_numbers({color.r, color.g, color.b})
                              : toml_numbers({color.r, color.g, color.b, color.a});
}

std::string toml_key(const std::string& name) {
  const bool is_bare = std::ranges::all_of(name, [](char c) { return c > 0; });
  return is_bare ? name : toml_string(name);
}

std::string toml_names(const std::vector<std::string>& names) {
  if (names.size() == 1) return toml_string(names[0]);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "[" : ", ") + toml_string(name);
  return text + "]";
}

bool is_toml_number(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const bool zero_first = text.starts_with('0');
  const std::size_t integer = skip_digits(text);
  if (integer == 0 || (zero_first && integer > 1)) return false;
  if (text.empty()) return integer <= kIntegerDigits;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    if (skip_digits(text) == 0) return false;
  }
  if (text.empty()) return true;
  if (text[0] != 'e' && text[0] != 'E') return false;
  text.remove_prefix(1);
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return skip_digits(text) > 0 && text.empty();
}

}  // namespace saddle
