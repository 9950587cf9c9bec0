// toml++ as Debian compiles it (TOML_HEADER_ONLY=0 comes from CMake): its header-only form aborts
// on some malformed texts.
#include "scene/toml/toml.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "base/utf8.h"

namespace saddle {
namespace {

/// Doubles hold every whole number up to this one.
constexpr std::int64_t kMostExact = std::int64_t{1} << 53;

/// Finds the byte of a line and column, in a time that does not depend on the line's length.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text), begins_{0} {
    std::size_t character = 0;
    for (std::size_t at = 0; at < text.size(); ++character) {
      if (character % kStride == 0) strides_.push_back(at);
      if (text[at] == '\n') begins_.push_back(character + 1);
      at += decode_utf8(text, at).bytes;
    }
  }

  /// The byte at a place of toml++, which counts lines and characters from 1.
  std::size_t byte(const toml::source_position& place) const {
    if (place.line == 0 || place.line > begins_.size()) return text_.size();
    const std::size_t column = std::max<std::size_t>(place.column, 1);
    const std::size_t character = begins_[place.line - 1] + column - 1;
    if (character / kStride >= strides_.size()) return text_.size();
    std::size_t at = strides_[character / kStride];
    for (std::size_t i = character % kStride; i > 0 && at < text_.size(); --i) {
      at += decode_utf8(text_, at).bytes;
    }
    return at;
  }

  Span span(const toml::source_region& region) const {
    const std::size_t begin = byte(region.begin);
    return {begin, std::max(begin, byte(region.end))};
  }

 private:
  static constexpr std::size_t kStride = 64;

  std::string_view text_;
  std::vector<std::size_t> begins_;   ///< of lines, in characters
  std::vector<std::size_t> strides_;  ///< bytes of every kStride-th character
};

/// The bytes of a string in quotes that begins at `at`, up to its closing quote or the line's end:
/// no key goes on in the next line.
std::size_t quoted_length(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (std::size_t i = at + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (text[i] == quote)
      return i + 1 - at;
  }
  return 1;
}

/// Throws Error at the first key with too many dots. Dots are counted between the characters that
/// no key has outside of quotes, so that an array of decimals counts one for each.
void check_key_depth(const SourceText& source) {
  const std::string_view text = source.text;
  std::size_t begin = 0;
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i += quoted_length(text, i) - 1;
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '.') {
      if (++dots <= kMaxKeyDepth) continue;
      throw source.error("", "a key of more than " + std::to_string(kMaxKeyDepth) + " parts",
                         {begin, i});
    } else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) {
      begin = i + 1;
      dots = 0;
    }
  }
}

/// toml++'s tree as ours.
class Converter {
 public:
  explicit Converter(const SourceText& source) : source_(source), lines_(source.text) {}

  TomlValue value(const toml::node& node) const {
    TomlValue result;
    result.span = lines_.span(node.source());
    if (const auto* table = node.as_table()) {
      add_entries(*table, result);
    } else if (const auto* array = node.as_array()) {
      result.kind = TomlValue::Kind::Array;
      for (const toml::node& item : *array) result.items.push_back(value(item));
    } else if (const auto* text = node.as_string()) {
      result.kind = TomlValue::Kind::String;
      result.text = text->get();
    } else if (const auto* boolean = node.as_boolean()) {
      result.kind = TomlValue::Kind::Boolean;
      result.boolean = boolean->get();
    } else if (const auto* whole = node.as_integer()) {
      result.kind = TomlValue::Kind::Number;
      result.number = exact_number(whole->get(), result.span);
    } else if (const auto* real = node.as_floating_point()) {
      result.kind = TomlValue::Kind::Number;
      result.number = real->get();
      if (!std::isfinite(result.number)) {
        throw source_.error("", "not a finite number", result.span,
                            "every number of a scene is finite");
      }
    } else {
      result.kind = TomlValue::Kind::Date;
    }
    return result;
  }

  Lines lines() const { return lines_; }

 private:
  /// A whole number as a double. TOML promises all 64 bits of it.
  double exact_number(std::int64_t whole, Span span) const {
    if (whole >= -kMostExact && whole <= kMostExact) return static_cast<double>(whole);
    const std::string text = std::to_string(whole);
    throw source_.error("", "a whole number beyond 2^53, which is not exact", span,
                        "write " + text + ".0 for the nearest double");
  }

  void add_entries(const toml::table& table, TomlValue& result) const {
    for (const auto& [key, node] : table) {
      result.entries.push_back({std::string(key.str()), lines_.span(key.source()), value(node)});
    }
    // toml++ keeps its tables by name.
    std::ranges::sort(result.entries, {}, [](const TomlEntry& e) { return e.key_span.begin; });
  }

  const SourceText& source_;
  Lines lines_;
};

std::size_t count_characters(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); at += decode_utf8(text, at).bytes) ++count;
  return count;
}

}  // namespace

const TomlValue* TomlValue::find(const std::string& key) const {
  const auto found = std::ranges::find(entries, key, &TomlEntry::key);
  return found == entries.end() ? nullptr : &found->value;
}

Error SourceText::error(const std::string& subject, const std::string& message, Span span,
                        const Hint& hint) const {
  const std::string_view before = std::string_view(text).substr(0, span.begin);
  const std::size_t line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
  const std::size_t column = count_characters(before.substr(before.rfind('\n') + 1)) + 1;
  const std::string where = name + ":" + std::to_string(line) + ":" + std::to_string(column);
  return {Status::Input, message, {subject, text, span, where}, hint};
}

TomlValue parse_toml(const SourceText& source) {
  if (source.text.size() > kMaxTomlBytes) {
    throw source.error("", "a scene file of more than 4 MiB", {0, 0},
                       "saddle show torus prints a scene");
  }
  check_key_depth(source);
  try {
    const toml::table table = toml::parse(std::string_view(source.text));
    return Converter(source).value(table);
  } catch (const toml::parse_error& error) {
    const Span span = Lines(source.text).span(error.source());
    throw source.error("", std::string(error.description()), span,
                       {"scene files are TOML, where text stands in quotes: title = \"Torus\"",
                        "saddle show torus prints one"});
  }
}

}  // namespace saddle
