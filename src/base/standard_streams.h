// Standard output, with its failures noticed, and standard error. No other file writes to them, so
// that names from scenes and pictures reach the terminal as printable() shows them.
#pragma once

#include <functional>
#include <ostream>
#include <span>
#include <string>

#include "base/error.h"

namespace saddle {

/// Lets `write` write to standard output and flushes it. Throws Error (Machine) if it is closed,
/// full or a broken pipe.
void write_standard_output(const std::function<void(std::ostream&)>& write);

/// The same for a text of the program's own, or a file's content.
void print(const std::string& text);

/// The same for lines that people read, each as printable() shows it.
void print_lines(std::span<const std::string> lines);

/// Lines on standard error, each as printable() shows it.
void tell(std::span<const std::string> lines);
void tell(const std::string& line);
void tell(const Error& error);

/// A line on standard error, which must be a terminal, in place of the last one; or none.
void show_status(const std::string& line);
void clear_status();

void flush_standard_streams();

bool standard_output_is_terminal();
bool standard_error_is_terminal();

/// Makes a broken pipe an error of the writer's, which would end the program silently otherwise,
/// and keeps files from getting the number of a standard stream that is closed: what is printed
/// would go into them. Called once, at the start of main.
void guard_standard_streams();

}  // namespace saddle
