// The program's commands: one function each, in a file of its own.
#pragma once

#include "app/command_line/cli.h"
#include "app/report/clock.h"

namespace saddle {

/// Formulas to pictures, meshes and reports. `start` is when the program began. Throws Error;
/// Machine if the picture differs from the reference by more than the threshold.
void run_graph(const CommandLine& line, Clock::time_point start);

/// Formulas in a window. Throws Error; Machine if there is no display.
void run_view(const CommandLine& line);

/// Writes the facts of the surface in words to standard output, and as a report. Throws Error.
void run_check(const CommandLine& line, Clock::time_point start);

/// Measures the methods on one surface and writes what each costs and how exact it is. Throws
/// Error: Machine if a chart needs gnuplot and it is missing.
void run_chart(const CommandLine& line);

/// Prints the names of the gallery, each with its description.
void run_list(const CommandLine& line);

/// Prints a surface of the gallery as a scene file, with the overrides in it; with --shader the
/// shaders that a scene is drawn with. Throws Error: Nothing if no surface is drawn.
void run_show(const CommandLine& line);

}  // namespace saddle
