// The scenes of examples/lighting: colours at chosen pixels, computed here from what the systems
// are said to be, with lights, cameras and shapes written down a second time.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "base/image_png.h"
#include "image/lighting_reference.h"
#include "paths.h"

namespace saddle {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Levels: half of one for rounding, the rest for floats and, on curved surfaces, for the mesh,
/// whose normals are off by up to 3 degrees at the default tolerance where colours change by 1 per
/// radian; pixels are chosen away from edges.
constexpr double kFlatTolerance = 1;
constexpr double kCurvedTolerance = 6;

/// Draws an example with one sample per pixel.
Image draw(const std::string& name, const std::string& arguments) {
  const std::string out = testing::TempDir() + "/example-" + std::to_string(::getpid()) + ".png";
  const std::string command = program_path() + " " + source_folder() + "/examples/lighting/" +
                              name + ".toml " + arguments + " --antialias 1 -o " + out;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  Image image = read_png(out).image;
  std::filesystem::remove(out);
  return image;
}

/// The camera of an example, from the look-at formula.
class Eye {
 public:
  Eye(const dvec3& view, double distance, double fov, int width, int height)
      : distance_(distance), width_(width), height_(height) {
    z_ = glm::normalize(view);
    x_ = glm::normalize(glm::cross(dvec3(0, 1, 0), z_));
    y_ = glm::cross(z_, x_);
    camera_.fov = fov;
    camera_.distance = distance;
  }
  void set_ortho() { camera_.ortho = true; }

  dvec3 vector(const dvec3& w) const { return {dot(w, x_), dot(w, y_), dot(w, z_)}; }
  dvec3 point(const dvec3& w) const { return vector(w) - dvec3(0, 0, distance_); }

  /// The pixel that a point of the world is in.
  std::pair<int, int> pixel(const dvec3& world) const {
    const dvec3 p = point(world);
    const double depth = camera_.ortho ? distance_ : -p.z;
    const double half = depth * std::tan(camera_.fov * kDegree / 2);
    return {static_cast<int>(std::floor((p.x / half * height_ + width_) / 2)),
            static_cast<int>(std::floor((1 - p.y / half) * height_ / 2))};
  }
  Sight sight(int x, int y) const { return sight_through(camera_, width_, height_, x, y); }
  dvec3 to_eye(const Sight& sight) const { return camera_.ortho ? dvec3(0, 0, 1) : -sight.along; }

  /// A light of the world in eye coordinates.
  Light seen(Light light) const {
    light.position = light.directional ? vector(light.position) : point(light.position);
    if (light.spot) light.spot->direction = vector(light.spot->direction);
    return light;
  }

 private:
  dvec3 x_, y_, z_;
  double distance_;
  int width_, height_;
  Camera camera_;
};

/// What the picture should have where it shows `world`, a point of a plane with this normal.
void expect_plane(const Image& image, const Eye& eye, const dvec3& world, const dvec3& normal,
                  const Material& material, const std::vector<Light>& lights,
                  Specular kind = Specular::Phong) {
  const auto [x, y] = eye.pixel(world);
  const Sight sight = eye.sight(x, y);
  const dvec3 n = eye.vector(normal);
  const dvec3 p = meet_plane(sight, eye.point(world), n);
  const dvec3 color = lit_color({p, n, eye.to_eye(sight)}, material, lights, kind);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(image.pixel(x, y)[c], 255 * color[c], kFlatTolerance)
        << "pixel " << x << " " << y << " channel " << c;
  }
}

Material dull(const Color& color) {
  return {color, {0, 0, 0}, 32};
}

Light viewpoint(double brightness) {
  return {.position = {0, 0, 0}, .color = {brightness, brightness, brightness}};
}

TEST(Examples, ViewpointCubeHasAColourPerFaceInDirectionalLight) {
  const Eye eye({2, 2, 6}, std::sqrt(44.0), 36, 600, 600);
  const Image image = draw("viewpoint-cube", "light=0");
  const Light light = {.position = {0, 0, 1}, .directional = true, .color = {1, 1, 1}};
  for (const dvec3& at : {dvec3(0.5, 0.6, 1), dvec3(-0.7, -0.6, 1)}) {
    expect_plane(image, eye, at, {0, 0, 1}, dull({0, 0, 1}), {light});
  }
  expect_plane(image, eye, {1, 0.6, -0.4}, {1, 0, 0}, dull({1, 0, 0}), {light});
  expect_plane(image, eye, {-0.5, 1, -0.4}, {0, 1, 0}, dull({0, 1, 0}), {light});
}

TEST(Examples, ViewpointCubeBlendsItsCornersInPointLight) {
  const Eye eye({2, 2, 6}, std::sqrt(44.0), 36, 600, 600);
  const Image image = draw("viewpoint-cube", "light=1");
  const auto at_corner = [&](double x, double y) {
    const dvec3 p = eye.point({x, y, 1});
    return glm::dot(eye.vector({0, 0, 1}), glm::normalize(-p));
  };
  // Halfway from the middle of the front face to a corner, on the diagonal of two triangles or
  // inside of one.
  const auto [x, y] = eye.pixel({0.5, 0.5, 1});
  const double on_diagonal = 0.75 * at_corner(1, 1) + 0.25 * at_corner(-1, -1);
  const double inside = 0.5 * at_corner(1, 1) + 0.25 * at_corner(1, -1) + 0.25 * at_corner(-1, 1);
  const double got = image.pixel(x, y)[2] / 255.0;
  // A pixel is 0.005 wide there, across which colours change by 0.2 per unit.
  EXPECT_LT(std::min(std::abs(got - on_diagonal), std::abs(got - inside)), 1.5 / 255);
}

/// Where a sight first meets the torus with the circle of radius 2 and the tube of radius 1 around
/// the z axis, by steps of the distance to it; NaN: it does not.
dvec3 meet_torus(const Sight& sight, const dvec3& centre) {
  double t = 0;
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p = sight.from + t * sight.along - centre;
    const double d = std::hypot(std::hypot(p.x, p.y) - 2, p.z) - 1;
    if (d < 1e-12) return p + centre;
    t += d;
  }
  return dvec3(std::nan(""));
}

TEST(Examples, SpecularTorusIsLitByEachOfFiveLights) {
  const Eye eye({0, 0, 1}, 15, 36, 600, 600);
  const Color grey{0.8, 0.8, 0.8};
  const std::vector<Light> lights = {
      {.position = {0, 0, 0}, .color = grey},
      {.position = {0, 0, 1}, .directional = true, .color = grey},
      {.position = {0, 1, 0}, .directional = true, .color = grey},
      {.position = {0, 0, -10}, .color = grey},
      {.position = {2, 3, 5}, .directional = true, .color = grey},
  };
  const Material white = {{1, 1, 1}, {0.25, 0.25, 0.25}, 10};
  const dvec3 centre(0, 0, -15);
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const Image image = draw("specular-torus", "light=" + std::to_string(k));
    int compared = 0;
    for (int y = 30; y < 600; y += 45) {
      for (int x = 30; x < 600; x += 45) {
        const Sight sight = eye.sight(x, y);
        const dvec3 p = meet_torus(sight, centre);
        if (std::isnan(p.x)) continue;
        const dvec3 q = p - centre;
        const double ring = std::hypot(q.x, q.y);
        const dvec3 n = q - dvec3(q.x, q.y, 0) * (2 / ring);
        if (glm::dot(n, -sight.along) < 0.4) continue;
        const dvec3 color = lit_color({p, n, -sight.along}, white, {lights[k]});
        EXPECT_NEAR(image.pixel(x, y)[1], 255 * color.g, kCurvedTolerance)
            << "light " << k << " pixel " << x << " " << y;
        ++compared;
      }
    }
    EXPECT_GE(compared, 40);
  }
  EXPECT_NEAR(draw("specular-torus", "").pixel(300, 300)[2], 0.3 * 255, 0.51);  // the hole
}

TEST(Examples, SpotlightsFallOnTheSquare) {
  const Eye eye({0, 1, 1}, 40, 60, 640, 640);
  const Material square = {{0.8, 0.8, 0.8}, {0.3, 0.3, 0.3}, 32};
  struct Variant {
    double cutoff, exponent;
    const char* arguments;
  };
  for (const Variant& v : {Variant{30, 10, ""}, Variant{20, 0, "cutoff=20 exponent=0"},
                           Variant{60, 50, "cutoff=60 exponent=50"}, Variant{30, 10, "fixed=1"}}) {
    std::vector<Light> lights = {viewpoint(0.5)};
    for (int i = 0; i < 3; ++i) {
      const double a = 120 * i * kDegree;
      Light light = {.position = {10 * std::sin(a), 10, 10 * std::cos(a)},
                     .color = {i == 0 ? 0.8 : 0, i == 1 ? 0.8 : 0, i == 2 ? 0.8 : 0}};
      light.spot.emplace();
      light.spot->direction = dvec3(-4 * std::sin(a), -10, -4 * std::cos(a));
      light.spot->cutoff = v.cutoff;
      light.spot->exponent = v.exponent;
      lights.push_back(eye.seen(light));
    }
    const Image image = draw("spotlights", v.arguments);
    for (const dvec3& at : {dvec3(0.5, 0, 0.7), dvec3(0, 0, 6), dvec3(5, 0, -3), dvec3(-5, 0, -3),
                            dvec3(-12, 0, 12), dvec3(3, 0, 3)}) {
      expect_plane(image, eye, at, {0, 1, 0}, square, lights);
    }
  }
  const Image dark = draw("spotlights", "viewpoint=0 specular=0");
  const auto [x, y] = eye.pixel({-14, 0, 14});
  EXPECT_EQ(int{dark.pixel(x, y)[0]}, 0);
}

TEST(Examples, SpotlightsThatAreFixedStayWithTheViewer) {
  const Image fixed = draw("spotlights", "fixed=1 --view 1,1,1");
  const Image turning = draw("spotlights", "fixed=0 --view 1,1,1");
  EXPECT_NE(fixed.rgba, turning.rgba);
}

/// The lights of the disk world at time t, in the world.
std::vector<Light> diskworld_lights(const Eye& eye, double t) {
  const double f = 60 * t;
  const double s = std::fmod(90 + f / 2, 360);
  std::vector<Light> lights = {viewpoint(0.2)};
  if (s < 180) {
    lights.push_back(eye.seen({.position = {std::cos(s * kDegree), std::sin(s * kDegree), 0},
                               .directional = true,
                               .color = {0.6, 0.6, 0.5}}));
    return lights;
  }
  Light lamp = {.position = {0, 1.5, 0}, .color = {1, 1, 0.8}};
  lamp.attenuation = {1, 2, 0, {}};
  lights.push_back(eye.seen(lamp));
  // By -f about y, (x, z) goes to (x cos f - z sin f, x sin f + z cos f).
  const double c = std::cos(f * kDegree);
  const double d = std::sin(f * kDegree);
  const auto turned = [&](const dvec3& p) {
    return dvec3(p.x * c - p.z * d, p.y, p.x * d + p.z * c);
  };
  for (const double z : {-1.0, 1.0}) {
    const dvec3 in_car = dvec3(0, 0.3, 4) + 0.3 * dvec3(-3, 0.6, z);
    Light light = {.position = turned(in_car), .color = {0.5, 0.5, 0.4}};
    light.spot.emplace();
    // Along -x, turned by -15 degrees about y: to (-cos 15, 0, -sin 15).
    light.spot->direction = turned(dvec3(-std::cos(15 * kDegree), 0, -std::sin(15 * kDegree)));
    light.spot->cutoff = 22.5;
    light.spot->exponent = 5;
    lights.push_back(eye.seen(light));
  }
  return lights;
}

TEST(Examples, DiskworldHasDayAndNight) {
  const Eye eye({0, 1, 2}, 17, 45, 600, 600);
  const Material road = {{0.7, 0.7, 0.8}, {0.1, 0.1, 0.1}, 16};
  for (const double t : {0.0, 1.5, 5.0, 7.0, 11.667}) {
    std::ostringstream arguments;
    arguments.precision(17);
    arguments << "--t " << t;
    const Image image = draw("diskworld", arguments.str());
    const std::vector<Light> lights = diskworld_lights(eye, t);
    EXPECT_EQ(lights.size(), t == 5 || t == 7 ? 4U : 2U);
    // The middle of the road where neither car nor trees are, and in the headlights' beams.
    std::vector<dvec3> places;
    for (const double degrees : {80.0, 140.0, 215.0, 250.0, 325.0}) {
      const double car = 90 + 60 * t;  // where it is: at (0, 4) turned by -f
      const double apart = std::abs(std::remainder(degrees - car, 360));
      if (apart < 35) continue;
      places.emplace_back(3.7 * std::cos(degrees * kDegree), 0, 3.7 * std::sin(degrees * kDegree));
    }
    for (const dvec3& at : places) expect_plane(image, eye, at, {0, 1, 0}, road, lights);
  }
}

TEST(Examples, LightCastersReachTheMiddleBox) {
  const Eye eye({0, 0, 1}, 3, 45, 800, 600);
  const Material box = {{1, 1, 1}, {1, 1, 1}, 32};
  Light sun = {.position = {0.2, 1, 0.3}, .directional = true, .color = {0.5, 0.5, 0.5}};
  sun.specular = Color{1, 1, 1};
  sun.ambient = {0.2, 0.2, 0.2};
  Light bulb = sun;
  bulb.directional = false;
  bulb.position = dvec3(1.2, 1, 2);
  bulb.attenuation = {1, 0.09, 0.032, {}};
  Light torch = sun;
  torch.directional = false;
  torch.position = dvec3(0, 0, 3);
  torch.spot.emplace();
  torch.spot->cutoff = 17.5;
  torch.spot->inner = 12.5;
  Light hard = torch;
  hard.spot->cutoff = 12.5;
  hard.spot->inner.reset();
  const std::vector<std::vector<Light>> choices = {
      {sun}, {bulb}, {torch}, {hard}, {sun, bulb, torch}};
  for (std::size_t k = 0; k < choices.size(); ++k) {
    const Image image = draw("light-casters", "light=" + std::to_string(k));
    std::vector<Light> lights;
    for (const Light& light : choices[k]) lights.push_back(eye.seen(light));
    for (const dvec3& at :
         {dvec3(0.05, 0.02, 0.5), dvec3(-0.45, 0.4, 0.5), dvec3(0.3, -0.4, 0.5)}) {
      expect_plane(image, eye, at, {0, 0, 1}, box, lights);
    }
  }
}

TEST(Examples, LightCastersAreInSightAllAlongTheFlight) {
  for (int t = 1; t < 12; t += 2) {
    const Image image = draw("light-casters", "light=all -s 80x60 --t " + std::to_string(t));
    int lit = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) lit += image.pixel(x, y)[0] > 0 ? 1 : 0;
    }
    EXPECT_GT(lit, image.width * image.height / 20) << "at " << t << " seconds";
  }
}

TEST(Examples, DiffuseReflectionBlendsWhatItsCornersReflect) {
  Light sun = {.position = {-1, 1, -1}, .directional = true, .color = {1, 1, 1}};
  Light bulb = sun;
  bulb.directional = false;
  Light near = {.position = {0, 1, 2}, .color = {1, 1, 1}};
  near.attenuation = {0, 1, 0, {}};
  Light spot = near;
  spot.spot.emplace();
  spot.spot->direction = dvec3(-1, -0.5, -1);
  spot.spot->cutoff = 80;
  spot.spot->exponent = 20;
  const std::vector<Light> lights = {sun, bulb, near, spot};
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const Eye eye(k < 2 ? dvec3(-2, 1, -1) : dvec3(-1, 1, 3), 6, k < 3 ? 24 : 36, 400, 400);
    const dvec3 target(k < 3 ? 0 : -1, 0, 0);  // what the eye has in the middle
    Light light = lights[k];
    if (!light.directional) light.position = dvec3(light.position) - target;
    const Image image = draw("diffuse-reflection", "light=" + std::to_string(k));
    int compared = 0;
    for (int y = 20; y < 400; y += 20) {
      for (int x = 20; x < 400; x += 20) {
        const Sight sight = eye.sight(x, y);
        const dvec3 p = meet_sphere(sight, eye.point(-target), 1, false);
        const dvec3 n = p - eye.point(-target);
        if (!(glm::dot(n, -sight.along) > 0.3)) continue;
        const dvec3 color = lit_color({p, n, -sight.along}, dull({1, 0.8, 0.8}), {eye.seen(light)});
        EXPECT_NEAR(image.pixel(x, y)[0], 255 * color.r, kCurvedTolerance)
            << "light " << k << " pixel " << x << " " << y;
        ++compared;
      }
    }
    EXPECT_GT(compared, 40);
  }
}

TEST(Examples, PedestalsStandInTheLightOfThreeFrames) {
  Eye eye({0.3, 0.5, 1}, 20, 2 * std::atan(5.0 / 20) / kDegree, 500, 500);
  eye.set_ortho();
  for (const double t : {0.0, 1.0}) {
    const Image image = draw("pedestals", "--t " + std::to_string(t));
    const double a = 60 * t * kDegree;
    const std::vector<Light> lights = {
        viewpoint(0.3),
        eye.seen({.position = {-5, 5, 5}, .color = {0.4, 0.4, 0.4}}),
        eye.seen({.position = {4 * std::cos(a), 4, -4 * std::sin(a)}, .color = {0.5, 0.5, 0.4}}),
    };
    for (const dvec3& at : {dvec3(2, -3, 1), dvec3(0, -3, 3)}) {
      expect_plane(image, eye, at, {0, 1, 0}, dull({0.3, 0.4, 0.3}), lights);
    }
  }
}

TEST(Examples, SpotEdgesAreHardLinearAndSmooth) {
  const Eye eye({0.3, 0.4, 1}, 12, 30, 400, 400);
  const Material wall = {{0.7, 0.7, 0.7}, {0.3, 0.3, 0.3}, 32};
  for (int edge = 0; edge < 3; ++edge) {
    Light light = {.position = {0, 0, 5}, .color = {0.8, 0.8, 0.8}};
    light.spot.emplace();
    light.spot->cutoff = 25;
    if (edge > 0) light.spot->inner = 15;
    if (edge == 2) light.spot->falloff = Spot::Falloff::Smooth;
    const Image image = draw("spot-edges", "edge=" + std::to_string(edge));
    for (const double radius : {0.1, 1.2, 1.5, 1.9, 2.2, 2.5}) {  // the edge: 1.34 to 2.33
      expect_plane(image, eye, {radius * 0.8, radius * 0.6, 0}, {0, 0, 1}, wall, {eye.seen(light)},
                   Specular::Blinn);
    }
  }
}

/// Every example draws without a warning, and its file is what saddle writes but for comments.
TEST(Examples, DrawWithoutWarnings) {
  int drawn = 0;
  for (const auto& file :
       std::filesystem::recursive_directory_iterator(source_folder() + "/examples")) {
    if (file.path().extension() != ".toml") continue;
    const std::string errors = testing::TempDir() + "/warnings-" + std::to_string(::getpid());
    const std::string command =
        program_path() + " " + file.path().string() + " -s 60x60 -o " + errors + ".png 2>" + errors;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::stringstream said;
    said << std::ifstream(errors).rdbuf();
    EXPECT_EQ(said.str(), "") << file.path();
    std::filesystem::remove(errors);
    std::filesystem::remove(errors + ".png");
    ++drawn;
  }
  EXPECT_GE(drawn, 17);
}

TEST(Examples, AreListedOnTheirPage) {
  std::stringstream page;
  page << std::ifstream(source_folder() + "/examples/README.md").rdbuf();
  for (const auto& file : std::filesystem::directory_iterator(source_folder() + "/examples")) {
    if (file.path().extension() != ".toml") continue;
    const std::string name = file.path().stem();
    const std::string row = "[" + name + "](" + name + ".toml) | ![";
    const std::size_t begin = page.str().find(row);
    ASSERT_NE(begin, std::string::npos) << name;
    const std::string rest = page.str().substr(begin, page.str().find('\n', begin) - begin);
    EXPECT_NE(rest.find("](../tests/golden/"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace saddle
