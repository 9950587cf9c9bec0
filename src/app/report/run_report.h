// Results of commands as reports and warnings.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/command_line/cli.h"
#include "app/report/report.h"
#include "meshing/tessellate.h"

namespace saddle {

/// The report of a surface by its name. Moves the mesh's report and findings there; the mesh stays.
SurfaceReport report_of(const std::string& name, Tessellation& tessellation);

void add_times(const Tessellation& tessellation, RunTimes& times);

/// Warnings of a scene that need no mesh: definitions that nothing uses, bounds that are reversed,
/// textures that are not shown or saved as they are.
std::vector<std::string> warnings_of(const Scene& scene);

/// To standard error, unless --quiet.
void print_warnings(const CommandLine& line, std::span<const std::string> warnings);

/// To a file, or to standard output for "-"; nothing for no name.
void send_report(const std::string& path, const RunReport& report);

/// --strict: throws Error (Input) if there was a warning.
void fail_on_warnings(const RunReport& report);

}  // namespace saddle
