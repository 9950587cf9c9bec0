// No two results of a run meet in one file.
#pragma once

#include <span>
#include <vector>

#include "app/command_line/cli.h"
#include "app/run/outputs.h"

namespace saddle {

/// Throws Error (Input) where two outputs, files beside them, the report or the picture of
/// differences meet in one file, and where a file beside an output would replace what the run
/// reads. `frames`: the numbers that numbered outputs are written for.
void check_names_differ(const CommandLine& line, const std::vector<Output>& outputs,
                        std::span<const int> frames);

}  // namespace saddle
