// Other programs that do a part of the work: gnuplot.
#pragma once

#include <string>
#include <vector>

namespace saddle {

/// Runs `command` (the program, looked up in PATH, and its arguments), hands it `input` through a
/// pipe and waits; SIGPIPE must be ignored. What it prints is thrown away, but for an error's sake.
/// Throws Error (Machine): the program is missing, and `package` has it; it fails, with the last
/// line of what it said.
void run_with_input(const std::vector<std::string>& command, const std::string& input,
                    const std::string& package);

}  // namespace saddle
