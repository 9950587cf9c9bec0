// Errors that a user can cause or must be told about: a message, the place in the text they
// wrote, a way out, and the exit status of the program. Programmers' errors are asserts.
#pragma once

#include <cstddef>
#include <exception>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace saddle {

/// Exit status of the program; every Error carries one of the failing three.
enum class Status { Done = 0, Machine = 1, Input = 2, Nothing = 3 };

/// Half-open range of bytes [begin, end) in a text.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Where an error is: the name of the thing that was written ("y", "--size", "u"), its text as the
/// user wrote it, and the bytes of the text that are meant. `text` empty: only the name is known.
/// In a file, `text` is the whole file and `where` says which, with line and column.
struct Place {
  std::string name;
  std::string text;
  Span span;
  std::string where = {};
};

/// The way out of an error, line by line. A line with a line break in it, from a file's name, is
/// still one line.
class Hint {
 public:
  Hint() = default;
  Hint(std::string line);
  Hint(const char* line) : Hint(std::string(line)) {}
  Hint(std::initializer_list<std::string> lines) : lines_(lines) {}

  void add(std::string_view line) { lines_.emplace_back(line); }
  std::vector<std::string>::const_iterator begin() const { return lines_.begin(); }
  std::vector<std::string>::const_iterator end() const { return lines_.end(); }

 private:
  std::vector<std::string> lines_;
};

/// The one exception type for everything that is not a programmer's mistake.
class Error : public std::exception {
 public:
  Error(Status status, std::string message, Place place = {}, Hint hint = {});

  /// The message alone, without place and hint.
  const char* what() const noexcept override { return message_.c_str(); }
  Status status() const { return status_; }
  const Place& place() const { return place_; }
  const Hint& hint_lines() const { return hint_; }
  std::string hint() const;  ///< its lines, joined by line breaks

 private:
  Status status_;
  std::string message_;
  Place place_;
  Hint hint_;
};

/// The exception that is being handled, whatever its type, as an Error: what is no Error is the
/// machine's. Called in a catch block.
Error caught_error();

/// The same error with one more line below its hint.
Error with_hint_line(const Error& error, std::string_view line);

/// The text for standard error, ending in a newline:
///
///     saddle: y: unknown name 'foo'
///       y = cos(u)*foo(v)
///                  ^~~
///     did you mean 'floor'?
///
/// In a file it begins with `saddle: FILE:LINE:COLUMN: `, and the file's line is shown. Columns
/// count characters, not bytes. A line longer than a terminal is cut around the place.
std::string format_error(const Error& error);

}  // namespace saddle
