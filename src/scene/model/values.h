// Values of options and of the scene file from their text. All throw Error (Input) with the place
// in the text.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/model/scene.h"

namespace saddle {

inline constexpr int kMaxPixels = 16384;  ///< each way: what OpenGL implementations can draw
inline constexpr int kMaxTriangles = 1'000'000'000;  ///< corners are numbered in 32 bits
inline constexpr int kMaxFrames = 1'000'000;         ///< nine hours at 30 a second
/// More grid lines than a picture of the largest size has pixels would paint it over.
inline constexpr int kMaxGridLines = kMaxPixels;
/// Lines of u times lines of v: each crossing is a vertex. So many take 1 GB and 3 seconds, and are
/// more than a picture shows.
inline constexpr int kMostGridCrossings = 1024 * 1024;
/// Limits of --max-memory in bytes: no OpenGL starts with less, no machine has more.
inline constexpr double kLeastMemory = 64e6;
inline constexpr double kMostMemory = 1e15;

/// The shortest decimal that reads back as the same double.
std::string format_number(double value);

/// A number's expression, or its value.
std::string expression_of(const Number& number);

/// The range of a number, the ends included unless `open`.
struct Limits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;

  bool contain(double value) const {
    return open ? value > low && value < high : value >= low && value <= high;
  }
};

inline constexpr Limits kAny = {};
inline constexpr Limits kNotNegative = {.low = 0};
inline constexpr Limits kPositive = {.low = 0, .open = true};
inline constexpr Limits kShare = {0, 1};
inline constexpr Limits kHalfTurn = {0, 180};  ///< degrees
inline constexpr Limits kFieldOfView = {0, 180, true};
inline constexpr Limits kLineWidths = {0, 100, true};  ///< pixels; tiles have as much margin
inline constexpr Limits kFramesPerSecond = {kMinFps, kMaxFps, true};

/// "from 0 to 1", "more than 0"
std::string describe(const Limits& limits);

/// The finite number that a part of a text is, as parse_number().
double number_in(const std::string& option, const std::string& text, Span part);

/// A finite number within its limits; a constant expression such as 2*pi is one too.
double parse_number(const std::string& option, const std::string& text,
                    const Limits& limits = kAny);

/// A whole number from `low` to `high`, in digits.
int parse_whole(const std::string& option, const std::string& text, int low, int high);

/// The parts of `A,B,...` between commas that are in no bracket. Throws Error (Input) unless they
/// are `count`; `what` and `sample` for the message: "a vector", "2,-3,1.5".
std::vector<Span> parse_list(const std::string& option, const std::string& text, std::size_t count,
                             const std::string& what, const std::string& sample);

/// A colour without opacity: of a surface, which has --opacity, of a line or of a light.
Color opaque_color(const std::string& option, const std::string& text);

/// A length: `0.5px`, or a share of the bounding box's diagonal such as `1e-3`; more than 0.
ToleranceValue parse_tolerance(const std::string& option, const std::string& text);

/// `X0:X1,Y0:Y1,Z0:Z1`, the ends of each in order; `auto` or `off`.
Clip parse_clip(const std::string& option, const std::string& text);

/// `MxN`, both from `low` to `high`.
GridSize parse_pair(const std::string& option, const std::string& text, int low, int high);

/// The place of a word among those that there are.
std::size_t parse_choice(const std::string& option, const std::string& text,
                         const std::vector<std::string>& words);

/// Cells of a uniform grid, `MxN`.
GridSize parse_samples(const std::string& option, const std::string& text);

/// Frames of an animation, counted from 0, both ends included.
struct FrameRange {
  int first = 0;
  int last = 0;

  int count() const { return last - first + 1; }
};

/// Bytes from a number with a unit, as 2GB, 500MB or 1.5GiB; kLeastMemory to kMostMemory.
double parse_memory(const std::string& option, const std::string& text);

/// `A:B`, whole numbers, A <= B.
FrameRange parse_frame_range(const std::string& option, const std::string& text);

/// Grid lines, `MxN` or `off`; each number is 0 or at least 2.
GridSize parse_grid_lines(const std::string& option, const std::string& text);

}  // namespace saddle
