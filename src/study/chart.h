// The results of a study as a table and as a chart: speed against accuracy, a panel for each task.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "study/measurement.h"

namespace saddle {

/// The table: panel, method, setting, milliseconds, error, unit, promise, triangles, pareto.
void write_csv(std::ostream& out, std::span<const Measurement> measurements);

/// Throws Error (Machine) if gnuplot cannot be run: before a long study is made in vain.
void check_gnuplot();

enum class ChartFormat { Svg, Png };

/// The chart as gnuplot draws it. `title` is shown as it is. Throws Error (Machine): gnuplot is
/// missing, or fails.
std::string draw_chart(std::span<const Measurement> measurements, const std::string& title,
                       ChartFormat format);

}  // namespace saddle
