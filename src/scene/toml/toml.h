// TOML text as a tree of values that know their place in it. toml++ does the reading; no other file
// includes it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace saddle {

struct TomlEntry;

struct TomlValue {
  enum class Kind { String, Number, Boolean, Array, Table, Date };
  Kind kind = Kind::Table;
  std::string text;  ///< of a string
  double number = 0;
  bool boolean = false;
  std::vector<TomlValue> items;    ///< of an array
  std::vector<TomlEntry> entries;  ///< of a table, in the order of the text
  Span span;                       ///< bytes of the text

  /// The value of a table's key, or nullptr.
  const TomlValue* find(const std::string& key) const;
};

struct TomlEntry {
  std::string key;
  Span key_span;
  TomlValue value;
};

/// A text with the name of the file it came from.
struct SourceText {
  std::string name;
  std::string text;

  /// An Error (Input) at these bytes, with line and column. `subject` is what is wrong there, or
  /// "".
  Error error(const std::string& subject, const std::string& message, Span span,
              const Hint& hint = {}) const;
};

/// Reads the whole text. Throws Error (Input) at the place that is no TOML, at numbers that are not
/// finite or too large, and at keys nested deeper than kMaxKeyDepth.
TomlValue parse_toml(const SourceText& source);

/// Deepest nesting of keys with dots. A scene needs 3; a tree of a million levels, which fits in a
/// small file, cannot be taken apart again without running out of stack.
inline constexpr int kMaxKeyDepth = 64;

/// Longest text in bytes.
inline constexpr std::size_t kMaxTomlBytes = 4 << 20;

}  // namespace saddle
