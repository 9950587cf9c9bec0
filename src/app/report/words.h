// Numbers and places in sentences.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"
#include "mesh/model/mesh_report.h"
#include "study/facts.h"

namespace saddle::words {

/// Normals this close are one, degrees.
inline constexpr double kSameDegrees = 1e-3;

/// Six digits: what an area keeps at the least.
std::string number(double value);
/// As many of the six digits as are known; "about 3.1" if that is less, "0 within 1e-9" if none is.
std::string number(const Estimate& estimate);
/// The same of an area or a volume, the power `dimension` of lengths up to `size`; says so where
/// that is too small for doubles.
std::string measure(const Estimate& estimate, double size, int dimension);
/// "1 place", "2 places".
std::string plural(std::size_t count, const std::string& noun);
/// "u = 1", "u = 1:2".
std::string range(const std::string& name, double low, double high);
/// "near u = 1, v = 2".
std::string near(const dvec2& uv, const Domain& domain);
/// "1 to 2", or toward where values have no bound; numbers up to `rounding` are 0.
std::string found(const ValueRange& range, double rounding, const Domain& domain);
/// "within 1 to 2" by the bounds of all values, "exact", or empty if nothing is proved.
std::string proved(const ValueRange& range, double rounding);
/// Without what is no more than `rounding`.
std::string vector(const dvec3& v, double rounding);

/// Where cuts are: "none", lines of constant u or v, and boxes around other places; single places
/// are counted. `count`: with those that are not listed; `lines`: of them, from end to end.
std::string cuts(std::span<const dvec2> listed, std::size_t count, const ParameterLines& lines,
                 const Domain& domain);

/// Where a surface jumps, as cuts(), and at which points it has no limit.
std::string jumps(const MeshReport& report, const Domain& domain);

/// Where a surface of a diagonal is singular, and its normals there: "none", or lines, curves and
/// single points.
std::string singular(const Facts& facts, double diagonal);

}  // namespace saddle::words
