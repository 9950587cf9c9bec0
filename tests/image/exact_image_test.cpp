// The exact image against geometry, and pictures against it.
#include "study/exact_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "image/lighting_reference.h"
#include "mesh/mesher/grid_mesh.h"
#include "render/picture/picture.h"
#include "study/dice.h"
#include "study/methods.h"
#include "study_subject.h"

namespace saddle {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

Scene sphere() {
  Scene scene =
      scene_of("cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)", {"0", "2*pi"}, {"-pi/2", "pi/2"});
  scene.camera.view = dvec3(0, 0, 1);
  scene.camera.up = dvec3(0, 1, 0);
  scene.camera.target = dvec3(0);
  scene.camera.distance = 5;
  scene.surfaces[0].grid = GridSize{0, 0};
  return scene;
}

ExactImage exact_image(const Scene& scene) {
  Subject subject(scene, scene.surfaces[0]);
  subject.width = kWidth;
  subject.height = kHeight;
  const Bounds bounds{dvec3(-1), dvec3(1)};
  subject.camera = fit_camera(scene.camera, bounds, static_cast<double>(kWidth) / kHeight);
  return draw_exactly(subject);
}

TEST(ExactImage, OfASphereIsThatOfTheRaysThatMeetIt) {
  const Scene scene = sphere();
  const ExactImage image = exact_image(scene);
  int compared = 0;
  for (int y = 5; y < kHeight; y += 6) {
    for (int x = 5; x < kWidth; x += 6) {
      const Sight sight = sight_through(scene.camera, kWidth, kHeight, x, y);
      const dvec3 centre(0, 0, -5);
      const dvec3 p = meet_sphere(sight, centre, 1, false);
      const dvec3 color = image.color[static_cast<std::size_t>(y) * kWidth + x];
      if (!is_finite(p)) continue;
      if (glm::dot(p - centre, -sight.along) < 0.6) continue;
      const dvec3 expected =
          lit_color({p, p - centre, -sight.along}, kFrontMaterial, default_lights());
      // A pixel is 1/50 of the radius: its mean is off its middle by a curvature's worth of that.
      EXPECT_LT(glm::distance(color, expected), 2e-3) << x << " " << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

TEST(ExactImage, IsTheSameForEveryParametrisation) {
  Scene by_angles = sphere();
  by_angles.surfaces[0].v = {"0", "pi/2"};
  Scene by_height = sphere();
  by_height.surfaces[0].x = "u";
  by_height.surfaces[0].y = "v";
  by_height.surfaces[0].z = "sqrt(1-u^2-v^2)";  // with a rim
  by_height.surfaces[0].u = by_height.surfaces[0].v = {};
  by_angles.camera.view = by_height.camera.view = dvec3(2, -3, 1.5);
  const ExactImage a = exact_image(by_angles);
  const ExactImage b = exact_image(by_height);
  double largest = 0;
  for (std::size_t k = 0; k < a.color.size(); ++k) {
    largest = std::max(largest, glm::distance(a.color[k], b.color[k]));
  }
  // At the silhouette a sample or two of 64 may fall to the other side.
  EXPECT_LT(largest, 0.08);
  EXPECT_GT(glm::length(a.color[a.color.size() / 2 + kWidth / 2]), 0.1);
}

TEST(ExactImage, EndsWhereASurfaceGoesToInfinityAcrossBothParameters) {
  // Along such poles there is never an end of cells that are too large.
  Scene scene = scene_of("u", "v", "1/(u^2-v^2)");
  scene.camera.target = dvec3(0);
  const ExactImage image = exact_image(scene);
  const auto is_lit = [](const dvec3& color) { return glm::length(color) > 0.1; };
  EXPECT_GT(std::ranges::count_if(image.color, is_lit), kWidth * kHeight / 20);
}

TEST(ExactImage, EndsAtTheClipBox) {
  Scene scene = scene_of("u", "v", "sin(u)+v");
  scene.camera.target = dvec3(0);
  Subject subject(scene, scene.surfaces[0]);
  subject.width = kWidth;
  subject.height = kHeight;
  subject.clip = Bounds{dvec3(-2), dvec3(2, 0.35, 0.5)};
  subject.camera = fit_camera(scene.camera, {dvec3(-1), dvec3(1)}, 4.0 / 3);
  double area = 0;
  for (const DicedTriangle& t : dice(subject, Projection(subject))) {
    for (const dvec2& uv : t.uv) {
      EXPECT_LE(uv.y, 0.35);
      EXPECT_LE(std::sin(uv.x) + uv.y, 0.5 + 1e-15);  // another sine than the surface's
    }
    const dvec2 a = t.uv[1] - t.uv[0];
    const dvec2 b = t.uv[2] - t.uv[0];
    area += 0.5 * std::fabs(a.x * b.y - a.y * b.x);
  }
  // What is below v = 0.35 is cut by v = 0.5 - sin(u) from the u where the two meet.
  const double meet = std::asin(0.15);
  const double expected = 1.35 * (meet + 1) + 1.5 * (1 - meet) + std::cos(1) - std::cos(meet);
  EXPECT_NEAR(area, expected, 1e-4);
}

constexpr auto kSilent = [](double, const std::string&) {};

TEST(ImageStudy, DrawsWhatACoarseGridMisses) {
  // One vertex in a hundred or so of a grid is where there is a surface.
  const Scene scene = scene_of("u", "v", "sqrt(0.01-u^2-v^2)");
  Subject subject(scene, scene.surfaces[0]);
  subject.width = kWidth;
  subject.height = kHeight;
  subject.pixel = 0.2 / kHeight;
  subject.max_triangles = 1000;
  const Bounds bounds{dvec3(-0.1, -0.1, 0), dvec3(0.1)};
  subject.camera = fit_camera(scene.camera, bounds, static_cast<double>(kWidth) / kHeight);
  std::set<std::string> methods;
  for (const Measurement& m : measure_images(subject, kSilent)) {
    methods.insert(m.method);
    // Grids miss most of the rim.
    if (m.method != "uniform grid") {
      EXPECT_LT(m.error, 0.1) << m.method << " " << m.setting;
    }
  }
  EXPECT_EQ(methods, (std::set<std::string>{"exact normal", "per pixel", "per vertex",
                                            "supersampling", "uniform grid"}));
}

TEST(ExactImage, IsWhatFinerPicturesComeNearerTo) {
  const Scene scene = sphere();
  const ExactImage exact = exact_image(scene);
  const Surface surface = prepare_surface(scene, scene.surfaces[0]).surface;
  const auto error_of = [&](int cells, int antialias) {
    const Mesh mesh = mesh_on_grid(surface, {cells, cells, 0, 0, 0}).mesh;
    return rms_error(render(scene, std::span(&mesh, 1), {kWidth, kHeight, antialias}).image, exact);
  };
  const double fine = error_of(200, 4);
  // Half a level of rounding in most pixels is 1.1e-3; the edges add as much.
  EXPECT_LT(fine, 3e-3);
  EXPECT_GT(error_of(200, 1), 1.5 * fine);
  EXPECT_GT(error_of(16, 4), 4 * fine);
}

}  // namespace
}  // namespace saddle
