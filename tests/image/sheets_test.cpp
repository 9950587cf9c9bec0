// Pictures of surfaces that jump or rise steeply show every sheet and nothing between them: they
// are compared with points of the formula as C++, without a mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "meshing/tessellate.h"
#include "render/picture/picture.h"
#include "scene/model/camera.h"
#include "scene/options/resolve.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;
/// Points that cover a quarter of a pixel of a level sheet: its samples are as far apart, and the
/// tips of sheets are narrower.
constexpr int kCovers = 180;

struct Sheets {
  std::string z;
  std::function<double(double, double)> height;
  int half_side = 1;  ///< of the square of parameters
  std::vector<dvec3> more = {};
};

/// A picture at a low angle, in which sheets of different heights are apart.
Scene scene_of(const Sheets& sheets) {
  const std::string side = std::to_string(sheets.half_side);
  const std::string range = "[-" + side + ", " + side + "]\n";
  return resolve(read_scene(
      {"test", "background = \"transparent\"\n[[surface]]\nz = \"" + sheets.z + "\"\nu = " + range +
                   "v = " + range + "grid = [0, 0]\n[camera]\nview = [0.3, -1, 0.15]\n" +
                   "target = [0, 0, 0.4]\northo = true\ndistance = 10\nfov = " +
                   std::to_string(16 * sheets.half_side) + "\n"}));
}

/// Points of the sheets, several a pixel.
std::vector<dvec3> points_of(const Sheets& sheets) {
  constexpr int kPlaces = 800;
  std::vector<dvec3> points = sheets.more;
  for (int j = 0; j < kPlaces; ++j) {
    for (int i = 0; i < kPlaces; ++i) {
      // On the axes and edges formulas have values of their own.
      const double u = sheets.half_side * ((2.0 * i + 1) / kPlaces - 1);
      const double v = sheets.half_side * ((2.0 * j + 1) / kPlaces - 1);
      points.emplace_back(u, v, sheets.height(u, v));
    }
  }
  return points;
}

using Pixels = std::vector<std::vector<bool>>;

/// Pixels of the first without one of the second that is the same or a neighbour.
int count_alone(const Pixels& pixels, const Pixels& others) {
  int count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      bool is_near = false;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, kHeight - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, kWidth - 1); ++i)
          is_near = is_near || others[j][i];
      }
      if (pixels[y][x] && !is_near) ++count;
    }
  }
  return count;
}

void expect_sheets(const Sheets& sheets) {
  const Scene scene = scene_of(sheets);
  const Mesh mesh = tessellate(scene, scene.surfaces[0], {.picture = true}, 1).mesh;
  PictureSettings settings = scene.picture;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.antialias = 4;  // parts of a wall may be narrower than a pixel
  const Image image = render(scene, std::span(&mesh, 1), settings).image;
  const FittedCamera camera =
      fit_camera(drawn_camera(scene), mesh.bounds, double(kWidth) / kHeight);
  Pixels drawn(kHeight, std::vector<bool>(kWidth));
  Pixels touched = drawn;
  Pixels covered = drawn;
  std::vector<std::vector<int>> counts(kHeight, std::vector<int>(kWidth));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) drawn[y][x] = image.pixel(x, y)[3] > 0;
  }
  for (const dvec3& point : points_of(sheets)) {
    const dvec2 at = pixel_of(camera, point, dvec2(kWidth, kHeight)).value();
    ASSERT_TRUE(at.x > 0 && at.x < kWidth && at.y > 0 && at.y < kHeight) << sheets.z;
    const auto x = static_cast<std::size_t>(at.x);
    const auto y = static_cast<std::size_t>(at.y);
    touched[y][x] = true;
    covered[y][x] = ++counts[y][x] >= kCovers;
  }
  EXPECT_EQ(count_alone(covered, drawn), 0) << sheets.z << ": pixels without the surface";
  EXPECT_EQ(count_alone(drawn, touched), 0) << sheets.z << ": pixels between sheets";
}

TEST(Sheets, AreAllInThePictureAndNothingBetweenThem) {
  expect_sheets({"(u^2+v^2<0.5&&v>0)?1:0",
                 [](double u, double v) { return u * u + v * v < 0.5 && v > 0 ? 1.0 : 0.0; }});
  expect_sheets({"(u^2+v^2<0.001)?1:0",
                 [](double u, double v) { return u * u + v * v < 0.001 ? 1.0 : 0.0; }});
  expect_sheets({"sign(u*v)/2+0.5", [](double u, double v) { return u * v > 0 ? 1.0 : 0.0; }});
  expect_sheets({"floor(hypot(u,v))/2",
                 [](double u, double v) { return std::floor(std::hypot(u, v)) / 2; }, 3});
}

TEST(Sheets, OfAThinFenceAreInThePicture) {
  const auto height = [](double u, double v) {
    const double s = (u * u + v * v - 0.5) / 1e-3;
    return std::exp(-s * s);
  };
  Sheets fence{"exp(-((u^2+v^2-0.5)/1e-3)^2)", height};
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += 1e-3) {
    for (double s = -3; s <= 3; s += 0.02) {
      const double r = std::sqrt(0.5 + 1e-3 * s);
      fence.more.emplace_back(r * std::cos(angle), r * std::sin(angle), std::exp(-s * s));
    }
  }
  expect_sheets(fence);
}

}  // namespace
}  // namespace saddle
