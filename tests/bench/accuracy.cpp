// The accuracy of the gallery against 50 digits, and of complex functions against 100, as tables:
// ./dev accuracy [POINTS-PER-SURFACE | complex]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "base/parallel.h"
#include "conformance/complex_accuracy.h"
#include "conformance/gallery_accuracy.h"

namespace {

constexpr int kDefaultPoints = 2000;  // 10^5 over the gallery
constexpr std::uint64_t kSeed = 2;
constexpr int kComplexPoints = 4000;  // half a minute

void print(const std::vector<saddle::testing::GalleryAccuracy>& rows) {
  std::printf(
      "Largest errors at random interior points, against 50 digits. Positions in units in the "
      "last\n"
      "place of the surface's largest coordinate (box) and of the point's (point), and as a share\n"
      "of what rounding may do to the formula as it is written (rounding: at most 1). Normals in\n"
      "degrees, and as a share of what rounding of the tangents may do.\n\n"
      "%-22s %7s %7s %9s %9s %7s %9s %9s\n",
      "surface", "points", "box", "point", "rounding", "normals", "degrees", "rounding");
  for (const auto& row : rows) {
    std::printf("%-22s %7d %7.2f %9.2f %9.3f %7d %9.2g %9.3f\n", row.name.c_str(), row.points,
                row.box_ulps, row.point_ulps, row.rounding, row.normals, row.degrees,
                row.normal_rounding);
  }
}

/// In Markdown, as docs/ACCURACY.md has it.
void print_complex_functions() {
  std::printf(
      "| function of w | plane, ulps | on the axes, ulps | 1e-8 beside them, ulps |\n"
      "| --- | --- | --- | --- |\n");
  for (const auto& function : saddle::testing::complex_functions()) {
    const auto accuracy = saddle::testing::measure_accuracy(function, kComplexPoints);
    std::printf("| `%s` | %.1f | %.1f | %.1f |\n", function.formula.c_str(), accuracy.plane.ulps,
                accuracy.axes.ulps, accuracy.beside.ulps);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "complex") == 0) {
    print_complex_functions();
    return 0;
  }
  const int points = argc > 1 ? std::atoi(argv[1]) : kDefaultPoints;
  if (points <= 0 || argc > 2) {
    std::fprintf(stderr, "usage: saddle_accuracy [POINTS-PER-SURFACE | complex]\n");
    return 2;
  }
  const auto entries = saddle::gallery();
  std::vector<saddle::testing::GalleryAccuracy> rows(entries.size());
  saddle::parallel_chunks(entries.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      rows[i] = saddle::testing::measure_accuracy(entries[i], points, kSeed);
    }
  });
  print(rows);
  return 0;
}
