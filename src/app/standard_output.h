// Standard output, with its failures noticed.
#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace saddle {

/// Lets `write` write to standard output and flushes it. Throws Error (Machine) if it is closed,
/// full or a broken pipe.
void write_standard_output(const std::function<void(std::ostream&)>& write);

/// The same for a text.
void print(const std::string& text);

/// Whether standard output is a terminal.
bool standard_output_is_terminal();

/// Makes a broken pipe an error of the writer's, which would end the program silently otherwise,
/// and keeps files from getting the number of a standard stream that is closed: what is printed
/// would go into them. Called once, at the start of main.
void guard_standard_streams();

}  // namespace saddle
