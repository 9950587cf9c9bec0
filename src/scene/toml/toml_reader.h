// Values of a TOML tree as those of a Scene. Each is noted with its place, so that what is found
// out later still points into the file.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/model/scene.h"
#include "scene/toml/toml.h"

namespace saddle {

/// Values with their places. A subject is what messages call a value: resolve()'s name of a number,
/// or a key.
class TomlPlaces {
 public:
  /// A table of scene files, as it is named in messages, with the keys that it may have.
  struct KnownTable {
    std::string name;
    std::vector<std::string> keys;
  };

  /// `tables`: where an unknown key may belong, in the order in which they are tried.
  explicit TomlPlaces(const SourceText& text, std::span<const KnownTable> tables = {})
      : text_(text), tables_(tables) {}

  Error error(const std::string& subject, const std::string& message, Span span,
              const Hint& hint = {}) const {
    return text_.error(subject, message, span, hint);
  }

  Error wrong_type(const std::string& subject, const TomlValue& value,
                   const std::string& wanted) const;

  /// Throws Error (Input) unless `value` is a table with no other keys than these.
  void check_keys(const std::string& subject, const TomlValue& value,
                  const std::vector<std::string>& known) const;

  /// Notes where the text that messages call `subject` stands.
  void note(const std::string& subject, const std::string& text, Span span) {
    places_.emplace(subject, Noted{text, span});
  }

  /// The folder of the file; empty for the current one, and for text without a file.
  std::filesystem::path folder() const { return std::filesystem::path(text_.name).parent_path(); }

  /// An error about a value, at its place in the file; `prefix` completes the subject.
  Error located(const Error& error, const std::string& prefix = {}) const;

 private:
  struct Noted {
    std::string text;
    Span span;
  };

  Span inside(const Noted& noted, Span part) const;

  const SourceText& text_;
  std::span<const KnownTable> tables_;
  std::multimap<std::string, Noted> places_;
};

/// All throw Error (Input) at the value's place where it has another type than it should.
class TomlReader {
 public:
  explicit TomlReader(TomlPlaces& places) : source_(places) {}

  std::string text(const std::string& subject, const TomlValue& value, const char* wanted);

  /// An expression: text, or a plain number.
  std::string formula(const std::string& subject, const TomlValue& value);

  Number number(const std::string& subject, const TomlValue& value,
                const char* wanted = "a number, or an expression in quotes");

  std::vector<Number> numbers(const std::string& subject, const TomlValue& value, std::size_t count,
                              const char* wanted);

  Vector vector(const std::string& subject, const TomlValue& value);

  /// `alpha`: a colour may be see-through.
  Color color(const std::string& subject, const TomlValue& value, bool alpha = false);

  bool boolean(const std::string& subject, const TomlValue& value) const;

  int whole(const std::string& subject, const TomlValue& value, int low, int high) const;

  /// An option of the command line: its text, or what its text would be (80x60 as [80, 60]).
  std::string option(const std::string& subject, const TomlValue& value, const std::string& wanted);

  /// The items of an array of tables.
  const std::vector<TomlValue>& tables(const std::string& key, const TomlValue& value) const;

  /// Returns the result of `action`; its errors get their place in the file.
  template <typename Action>
  auto in_place(const Action& action, const std::string& prefix = {}) const {
    try {
      return action();
    } catch (const Error& error) {
      throw error.place().where.empty() ? source_.located(error, prefix) : error;
    }
  }

  const TomlPlaces& source() const { return source_; }
  void note(const std::string& subject, const std::string& text, Span span) {
    source_.note(subject, text, span);
  }

 private:
  TomlPlaces& source_;
};

/// Calls `read` with the value of a key, if it is there.
template <typename Read>
void with(const TomlValue& table, const std::string& key, const Read& read) {
  if (const TomlValue* value = table.find(key)) read(*value);
}

}  // namespace saddle
