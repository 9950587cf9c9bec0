#include "scene/toml/toml_reader.h"

#include <algorithm>
#include <cmath>

#include "base/nearest.h"
#include "scene/model/color.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

using Kind = TomlValue::Kind;

/// Descriptions of values, for messages.
constexpr const char* kVector = "three numbers, such as [2, -3, 1.5]";
constexpr const char* kColor = "a colour such as \"#ffff80\", \"tomato\" or [1, 1, 0.5]";

std::string described(const TomlValue& value) {
  switch (value.kind) {
    case Kind::String:
      return "text";
    case Kind::Number:
      return "a number";
    case Kind::Boolean:
      return "true or false";
    case Kind::Array:
      return "an array of " + std::to_string(value.items.size());
    case Kind::Table:
      return "a table";
    case Kind::Date:
      return "a date or time";
  }
  return "";
}

/// A hint in which the range of `name` is written as on the command line, u=0:2*pi, with that range
/// as a file has it: u = ["0", "2*pi"].
Hint with_range_of_file(const Hint& hint, const std::string& name) {
  Hint result;
  for (std::string line : hint) {
    const std::size_t begin = line.find(" " + name + "=");
    const std::size_t equals = line.find('=', begin);
    const std::size_t end = std::min(line.find_first_of(" ;", equals), line.size());
    const std::size_t colon = line.find(':', equals);
    if (begin != std::string::npos && colon < end) {
      const std::string low = line.substr(equals + 1, colon - equals - 1);
      const std::string high = line.substr(colon + 1, end - colon - 1);
      line.replace(equals, end - equals, " = [\"" + low + "\", \"" + high + "\"]");
    }
    result.add(std::move(line));
  }
  return result;
}

/// Whole numbers without an exponent.
std::string in_digits(double number) {
  constexpr double kMost = 1e15;  // doubles count on to here without gaps
  return number == std::floor(number) && std::abs(number) < kMost
             ? std::to_string(static_cast<long long>(number))
             : format_number(number);
}

}  // namespace

Error TomlPlaces::wrong_type(const std::string& subject, const TomlValue& value,
                             const std::string& wanted) const {
  return error(subject, "must be " + wanted + ", not " + described(value), value.span);
}

void TomlPlaces::check_keys(const std::string& subject, const TomlValue& value,
                            const std::vector<std::string>& known) const {
  if (value.kind != Kind::Table) throw wrong_type(subject, value, "a table");
  for (const TomlEntry& entry : value.entries) {
    if (std::ranges::find(known, entry.key) != known.end()) continue;
    std::string hint = "known keys:";
    for (const std::string& key : known) hint += " " + key;
    const auto has_key = [&](const KnownTable& table) {
      return std::ranges::find(table.keys, entry.key) != table.keys.end();
    };
    const auto home = std::ranges::find_if(tables_, has_key);
    if (home != tables_.end()) {
      hint += "; '" + entry.key + "' belongs " + home->name;
    } else if (const auto nearest = nearest_name(entry.key, known)) {
      hint += "; did you mean '" + *nearest + "'?";
    }
    throw error("", "unknown key '" + entry.key + "'", entry.key_span, hint);
  }
}

Error TomlPlaces::located(const Error& error, const std::string& prefix) const {
  const Place& place = error.place();
  const auto [begin, end] = places_.equal_range(prefix + place.name);
  if (begin == end) return prefix.empty() ? error : located(error);
  const auto same =
      std::find_if(begin, end, [&](const auto& p) { return p.second.text == place.text; });
  const Span span = same != end ? inside(same->second, place.span) : begin->second.span;
  const std::size_t key = place.name.rfind(' ') + 1;  // of "animation: t"
  return text_.error(place.name, error.what(), span,
                     with_range_of_file(error.hint_lines(), place.name.substr(key)));
}

/// The bytes `part` of a noted text, in the file: unless it is written with escapes there.
Span TomlPlaces::inside(const Noted& noted, Span part) const {
  const std::size_t quote = text_.text.find(noted.text, noted.span.begin) - noted.span.begin;
  if (part.end == 0 || quote > 4) return noted.span;  // 4: """ and a line break
  const std::size_t begin = noted.span.begin + quote;
  return {begin + part.begin, begin + part.end};
}

std::string TomlReader::text(const std::string& subject, const TomlValue& value,
                             const char* wanted) {
  if (value.kind != Kind::String) throw source_.wrong_type(subject, value, wanted);
  source_.note(subject, value.text, value.span);
  return value.text;
}

std::string TomlReader::formula(const std::string& subject, const TomlValue& value) {
  std::string text = value.text;
  if (value.kind == Kind::Number) {
    text = format_number(value.number);
  } else if (value.kind != Kind::String) {
    throw source_.wrong_type(subject, value, "a formula in quotes, or a number");
  }
  source_.note(subject, text, value.span);
  if (text.empty()) throw source_.error(subject, "the expression is empty", value.span);
  return text;
}

Number TomlReader::number(const std::string& subject, const TomlValue& value, const char* wanted) {
  if (value.kind == Kind::Number) {
    source_.note(subject, format_number(value.number), value.span);
    return value.number;
  }
  if (value.kind != Kind::String) throw source_.wrong_type(subject, value, wanted);
  return Number(formula(subject, value));
}

std::vector<Number> TomlReader::numbers(const std::string& subject, const TomlValue& value,
                                        std::size_t count, const char* wanted) {
  if (value.kind != Kind::Array || value.items.size() != count) {
    throw source_.wrong_type(subject, value, wanted);
  }
  source_.note(subject, "", value.span);
  std::vector<Number> result;
  for (const TomlValue& item : value.items) result.push_back(number(subject, item));
  return result;
}

Vector TomlReader::vector(const std::string& subject, const TomlValue& value) {
  const std::vector<Number> n = numbers(subject, value, 3, kVector);
  return {n[0], n[1], n[2]};
}

Color TomlReader::color(const std::string& subject, const TomlValue& value, bool alpha) {
  if (value.kind == Kind::String) {
    source_.note(subject, value.text, value.span);
    return in_place([&] {
      return alpha ? parse_color(subject, value.text) : opaque_color(subject, value.text);
    });
  }
  const bool has_alpha = alpha && value.kind == Kind::Array && value.items.size() == 4;
  const std::vector<Number> n = numbers(subject, value, has_alpha ? 4 : 3, kColor);
  return {n[0], n[1], n[2], has_alpha ? n[3] : Number(1)};
}

bool TomlReader::boolean(const std::string& subject, const TomlValue& value) const {
  if (value.kind != Kind::Boolean) throw source_.wrong_type(subject, value, "true or false");
  return value.boolean;
}

int TomlReader::whole(const std::string& subject, const TomlValue& value, int low, int high) const {
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  if (value.kind != Kind::Number) {
    throw source_.wrong_type(subject, value, "a whole number from " + range);
  }
  if (value.number != std::floor(value.number) || value.number < low || value.number > high) {
    throw source_.error(subject, "must be a whole number from " + range, value.span);
  }
  return static_cast<int>(value.number);
}

std::string TomlReader::option(const std::string& subject, const TomlValue& value,
                               const std::string& wanted) {
  std::string text = value.text;
  if (value.kind == Kind::Array && value.items.size() == 2 && value.items[0].kind == Kind::Number &&
      value.items[1].kind == Kind::Number) {
    text = in_digits(value.items[0].number) + "x" + in_digits(value.items[1].number);
  } else if (value.kind == Kind::Number) {
    text = format_number(value.number);
  } else if (value.kind != Kind::String) {
    throw source_.wrong_type(subject, value, wanted);
  }
  source_.note(subject, text, value.span);
  return text;
}

const std::vector<TomlValue>& TomlReader::tables(const std::string& key,
                                                 const TomlValue& value) const {
  const auto is_table = [](const TomlValue& item) { return item.kind == Kind::Table; };
  if (value.kind == Kind::Array && std::ranges::all_of(value.items, is_table)) {
    return value.items;
  }
  throw source_.error(key, "must be written as [[" + key + "]]", value.span);
}

}  // namespace saddle
