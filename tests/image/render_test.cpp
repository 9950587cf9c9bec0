// What a picture shows: lines, edges, transparency, depth, size, tiles.
#include "render/picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <optional>

#include "base/error.h"
#include "base/image_compare.h"
#include "image/analytic_mesh.h"
#include "image/lighting_reference.h"
#include "render/gl/context.h"
#include "render/gl/library.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/camera.h"

namespace saddle {
namespace {

constexpr int kLine = 51;  // 0.2 in 8 bits

Scene scene_of(std::size_t surfaces) {
  Scene scene;
  scene.surfaces.resize(surfaces);
  scene.lights = three_lights();
  return scene;
}

/// Straight at the xy-plane, `half_height` of it to be seen above and below the target.
Scene flat_scene(std::size_t surfaces, double half_height) {
  Scene scene = scene_of(surfaces);
  scene.camera.view = {0, 0, 1};
  scene.camera.up = {0, 1, 0};
  scene.camera.ortho = true;
  scene.camera.fov = 90;  // at distance d, d above and below
  scene.camera.distance = half_height;
  scene.camera.target = dvec3(0);
  return scene;
}

Image draw(const Scene& scene, std::span<const Mesh> meshes, const PictureSettings& options) {
  return render(scene, meshes, options).image;
}

Image draw(const Scene& scene, const Mesh& mesh, const PictureSettings& options) {
  return draw(scene, std::span(&mesh, 1), options);
}

bool is_line(const std::uint8_t* pixel) {
  return pixel[0] == kLine && pixel[1] == kLine && pixel[2] == kLine;
}

/// The largest difference of any channel, and how many pixels differ by more than one level.
struct Difference {
  int largest = 0;
  int pixels = 0;
};

Difference difference(const Image& a, const Image& b) {
  Difference result;
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int largest = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      largest = std::max(largest, std::abs(a.rgba[i + c] - b.rgba[i + c]));
    }
    result.largest = std::max(result.largest, largest);
    result.pixels += largest > 1 ? 1 : 0;
  }
  return result;
}

/// Every quarter of a pixel along the mesh's lines there is a line pixel within a pixel.
int missing_line_samples(const Scene& scene, const Mesh& mesh, const Image& image) {
  const FittedCamera camera =
      fit_camera(scene.camera, mesh.bounds, double(image.width) / image.height);
  const auto on_screen = [&](const dvec3& p) {
    const glm::dvec4 clip = camera.eye_to_clip * camera.world_to_eye * glm::dvec4(p, 1);
    return dvec2((clip.x / clip.w + 1) / 2 * image.width, (1 - clip.y / clip.w) / 2 * image.height);
  };
  int missing = 0;
  for (const auto& line : mesh.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const dvec2 a = on_screen(mesh.position[line[i - 1]]);
      const dvec2 b = on_screen(mesh.position[line[i]]);
      const int steps = static_cast<int>(4 * glm::length(b - a)) + 1;
      for (int k = 0; k <= steps; ++k) {
        const dvec2 at = a + (b - a) * (double(k) / steps);
        bool found = false;
        for (const dvec2& d :
             {dvec2(0, 0), dvec2(0.5, 0), dvec2(-0.5, 0), dvec2(0, 0.5), dvec2(0, -0.5)}) {
          const int x = std::clamp(static_cast<int>(std::floor(at.x + d.x)), 0, image.width - 1);
          const int y = std::clamp(static_cast<int>(std::floor(at.y + d.y)), 0, image.height - 1);
          found = found || is_line(image.pixel(x, y));
        }
        missing += found ? 0 : 1;
      }
    }
  }
  return missing;
}

TEST(Lines, AreUnbrokenOnAPlane) {
  const Mesh mesh = plane_mesh(dvec3(0), 1, {60, 60, 4});
  for (const dvec3& view :
       {dvec3(2, -3, 1.5), dvec3(0, -1, 0.2), dvec3(0.3, 0.1, 1), dvec3(-1, 2, -0.5)}) {
    Scene scene = scene_of(1);
    scene.camera.view = view;
    const Image image = draw(scene, mesh, {400, 300, 1});
    EXPECT_EQ(missing_line_samples(scene, mesh, image), 0) << view.x << " " << view.y;
  }
}

TEST(Lines, DoNotShowThroughASurfaceInFront) {
  // Only the hidden plane has lines. The one in front is pushed back by the depth across a pixel,
  // 0.013, and lies 0.05 in front.
  const std::array meshes{plane_mesh(dvec3(0, 0, 0.05), 1), plane_mesh(dvec3(0), 0.9, {60, 60, 4})};
  for (int antialias : {1, 2, 4}) {
    Scene scene = scene_of(2);
    scene.camera.view = {0.2, -1, 1};
    const Image image = draw(scene, meshes, {400, 300, antialias});
    int lines = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) lines += is_line(&image.rgba[i]) ? 1 : 0;
    EXPECT_EQ(lines, 0) << antialias;
  }
}

TEST(Lines, AreOnePixelWideWhateverTheSupersampling) {
  const Mesh mesh = plane_mesh(dvec3(0), 1, {10, 10, 5});
  Scene scene = flat_scene(1, 1.2);
  scene.lights = {{{0, 0, 1}, true, {0.8, 0.8, 0.8, 1}}};  // the same everywhere
  for (int antialias : {1, 2, 3, 4, 8}) {
    const Image image = draw(scene, mesh, {240, 240, antialias});
    // The darkness of the middle line, summed over a row that crosses it, in lines of one pixel.
    const auto* flat = image.pixel(90, 70);
    double width = 0;
    for (int x = 100; x < 140; ++x) {
      width += double(flat[0] - image.pixel(x, 70)[0]) / (flat[0] - kLine);
    }
    EXPECT_NEAR(width, 1, 0.05) << antialias;
  }
}

TEST(Edges, AreTransparentByTheShareOfTheirPixelThatIsCovered) {
  // 40 pixels for 1 unit; the square ends a quarter of a pixel inside its border pixels on each
  // side.
  const Mesh mesh = plane_mesh(dvec3(0), (40 + 0.25) / 40);
  Scene scene = flat_scene(1, 2);
  scene.background = {0, 0, 0, 0};
  scene.lights = {{{0, 0, 1}, true, {0.5, 0.5, 0.5, 1}}};
  const Image image = draw(scene, mesh, {160, 160, 4});
  const std::array<std::uint8_t, 4> none{0, 0, 0, 0};
  const auto pixel = [&](int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return std::array<std::uint8_t, 4>{p[0], p[1], p[2], p[3]};
  };
  EXPECT_EQ(pixel(0, 0), none);
  EXPECT_EQ(pixel(80, 38), none);
  const auto inside = pixel(80, 80);
  EXPECT_EQ(inside[3], 255);
  auto side = inside;
  side[3] = 64;  // 4 of 16 samples
  EXPECT_EQ(pixel(80, 39), side);
  EXPECT_EQ(pixel(80, 120), side);
  EXPECT_EQ(pixel(39, 80), side);
  EXPECT_EQ(pixel(120, 80), side);
  auto corner = inside;
  corner[3] = 16;  // 1 of 16 samples
  EXPECT_EQ(pixel(39, 39), corner);
  EXPECT_EQ(pixel(120, 120), corner);
}

TEST(Edges, BlendWithAnOpaqueBackground) {
  const Mesh mesh = plane_mesh(dvec3(0), (40 + 0.5) / 40);
  Scene scene = flat_scene(1, 2);
  scene.background = {1, 1, 1, 1};
  const Image image = draw(scene, mesh, {160, 160, 2});
  const int inside = image.pixel(80, 40)[2];
  EXPECT_EQ(image.pixel(80, 38)[2], 255);
  EXPECT_NEAR(image.pixel(80, 39)[2], (inside + 255) / 2.0, 1);
  EXPECT_EQ(image.pixel(80, 39)[3], 255);
}

TEST(Background, IsTheColourThatWasAskedFor) {
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  Scene scene = flat_scene(1, 10);
  scene.background = {200 / 255.0, 100 / 255.0, 7 / 255.0, 16 / 255.0};
  for (int antialias : {1, 2, 3}) {
    const Image image = draw(scene, mesh, {40, 40, antialias});
    const std::uint8_t* p = image.pixel(1, 1);
    EXPECT_EQ((std::array{p[0], p[1], p[2], p[3]}), (std::array<std::uint8_t, 4>{200, 100, 7, 16}));
  }
}

TEST(Picture, HasUpAtTheTopAndRightAtTheRight) {
  Scene scene = flat_scene(1, 2);
  const Image image = draw(scene, plane_mesh(dvec3(1, 1, 0), 0.5), {100, 100, 1});
  EXPECT_GT(image.pixel(75, 25)[0], 50);
  EXPECT_EQ(image.pixel(25, 25)[0], 0);
  EXPECT_EQ(image.pixel(75, 75)[0], 0);
}

TEST(Picture, EachSurfaceHasItsOwnMaterials) {
  const std::array meshes{plane_mesh(dvec3(-1, 0, 0), 0.5), plane_mesh(dvec3(1, 0, 0), 0.5)};
  Scene scene = flat_scene(2, 2);
  scene.surfaces[0].front = {{1, 0, 0}, {0, 0, 0}, 1};
  scene.surfaces[1].front = {{0, 0, 1}, {0, 0, 0}, 1};
  const Image image = draw(scene, meshes, {100, 100, 1});
  EXPECT_GT(image.pixel(25, 50)[0], 100);
  EXPECT_EQ(image.pixel(25, 50)[2], 0);
  EXPECT_EQ(image.pixel(75, 50)[0], 0);
  EXPECT_GT(image.pixel(75, 50)[2], 100);
}

TEST(Picture, IsTheSameEveryTime) {
  const Mesh mesh = torus_mesh(2, 1, {64, 64, 4});
  const Scene scene = scene_of(1);
  EXPECT_EQ(draw(scene, mesh, {200, 150, 2}).rgba, draw(scene, mesh, {200, 150, 2}).rgba);
}

TEST(Picture, DependsNeitherOnPlaceNorOnSize) {
  const auto picture = [](const dvec3& shift, double scale) {
    Mesh mesh = torus_mesh(2, 1, {64, 64, 4});
    mesh.bounds = {};
    for (dvec3& p : mesh.position) {
      p = scale * p + shift;
      mesh.bounds.add(p);
    }
    return draw(scene_of(1), mesh, {300, 200, 2});
  };
  const Image near = picture(dvec3(0), 1);
  // Rounding in the 16th digit may move a sample on an edge to its other side, here and there.
  constexpr int kFew = 10;
  EXPECT_LE(difference(near, picture(dvec3(1e7, -1e7, 1e7), 1)).pixels, kFew);
  EXPECT_LE(difference(near, picture(dvec3(0), 1e-8)).pixels, kFew);
  EXPECT_LE(difference(near, picture(dvec3(0), 1e8)).pixels, kFew);
  EXPECT_LE(difference(near, picture(dvec3(0), 1e-100)).pixels, kFew);
  EXPECT_LE(difference(near, picture(dvec3(0), 1e100)).pixels, kFew);
}

TEST(Picture, LightsAStripHoweverMuchLongerThanWide) {
  const auto picture = [](double length) {
    // z = x*y: its normals are along y but for a part that grows less with the length.
    const auto strip = [length](double s, double t) {
      const double x = length * (0.1 + s);
      const double y = 2 * t - 1;
      return AnalyticPoint{{x, y, x * y}, glm::normalize(dvec3(-y / x, -1, 1 / x))};
    };
    return draw(scene_of(1), analytic_mesh(strip), {300, 200, 2});
  };
  const Image image = picture(1e100);
  EXPECT_LE(difference(image, picture(1e200)).pixels, 10);
}

TEST(Picture, LooksTheSameFromFarAwayThroughATelescope) {
  const Mesh mesh = sphere_mesh(dvec3(0), 1, {64, 64, 0});
  Scene scene = scene_of(1);
  scene.lights = {{{0, 1, 1}, true, {1, 1, 1, 1}}};
  scene.surfaces[0].front.specular = {};
  scene.camera.ortho = true;
  scene.camera.fov = 1e-4;
  const Image parallel = draw(scene, mesh, {200, 200, 1});
  scene.camera.ortho = false;
  // The sphere appears from a million radii away: parallel to 1e-6. The fits differ less than that.
  EXPECT_LE(difference(parallel, draw(scene, mesh, {200, 200, 1})).pixels, 10);
}

TEST(Picture, ResolvesDepthInADeepScene) {
  // Planes a thousandth apart, seen from 10; a third one a hundred away makes the scene deep.
  const std::array meshes{plane_mesh(dvec3(0), 1), plane_mesh(dvec3(0, 0, -1e-3), 1),
                          plane_mesh(dvec3(0, 0, -100), 1)};
  Scene scene = scene_of(3);
  scene.camera.view = {0.5, 0, 1};
  scene.camera.up = {0, 1, 0};
  scene.camera.target = dvec3(0);
  scene.camera.distance = 10;
  scene.surfaces[0].front.diffuse = {1, 0, 0};
  scene.surfaces[1].front.diffuse = {0, 1, 0};
  const Image image = draw(scene, meshes, {200, 200, 1});
  int red = 0;
  int green = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint8_t* p = &image.rgba[i];
    red += p[0] > p[1] + 30 ? 1 : 0;
    green += p[1] > p[0] + 30 ? 1 : 0;
  }
  EXPECT_GT(red, 2000);
  EXPECT_LE(green, 80);  // the rim of the lower one: a pixel's width along one side at most
}

TEST(Picture, MayBeOfAnySize) {
  const Mesh mesh = torus_mesh(2, 1, {32, 32, 4});
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(4, 4), std::pair(301, 7)}) {
    for (int antialias : {1, 2, 16}) {
      const Image image = draw(scene_of(1), mesh, {width, height, antialias});
      EXPECT_EQ(image.width, width);
      EXPECT_EQ(image.height, height);
      bool drawn = false;  // a picture of background alone has red only where there is surface
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) drawn = drawn || image.rgba[i] > 0;
      EXPECT_TRUE(drawn || width == 1);  // the middle of a torus is its hole
    }
  }
}

TEST(Picture, IsBackgroundWhereThereIsNothing) {
  const Mesh empty;
  const Image image = draw(scene_of(1), empty, {4, 4, 2});
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    EXPECT_EQ(image.rgba[i], i % 4 == 3 ? 255 : 0);
  }
}

TEST(Tiles, GiveTheSamePictureAsOnePiece) {
  const PictureSettings options{301, 203, 2};
  const Mesh mesh = torus_mesh(2, 1, {64, 64, 0});
  const Scene scene = scene_of(1);
  const Image whole = draw(scene, mesh, options);
  for (int limit : {64, 150, 333}) {
    const Image tiled = render_in_tiles(scene, std::span(&mesh, 1), options, limit).image;
    // Positions are rounded to floats and to 1/256 sample anew in each tile: 1e-7 of the picture.
    EXPECT_LE(difference(whole, tiled).pixels, 10) << limit;
  }
}

TEST(Tiles, ContinueLinesAcrossTheirBorders) {
  const Mesh mesh = plane_mesh(dvec3(0), 1, {60, 60, 4});
  Scene scene = scene_of(1);
  const Image tiled = render_in_tiles(scene, std::span(&mesh, 1), {400, 300, 1}, 37).image;
  EXPECT_EQ(missing_line_samples(scene, mesh, tiled), 0);
}

TEST(Tiles, HaveRoomForWideLines) {
  const Mesh mesh = plane_mesh(dvec3(0), 1, {60, 60, 4});
  Scene scene = scene_of(1);
  scene.surfaces[0].line_width = Number(9);
  scene.surfaces[0].line_color = {1, 0, 0};
  const PictureSettings options{400, 300, 2};
  const Image whole = draw(scene, mesh, options);
  const Image tiled = render_in_tiles(scene, std::span(&mesh, 1), options, 128).image;
  EXPECT_LE(difference(whole, tiled).pixels, 20);
}

/// The share of the pixels of a plane that its lines cover. They are red, the plane is not.
double share_of_lines(const PictureSettings& options, std::optional<double> width = {}) {
  const Mesh mesh = plane_mesh(dvec3(0), 1, {60, 60, 30});
  Scene scene = scene_of(1);
  if (width) scene.surfaces[0].line_width = Number(*width);
  scene.surfaces[0].line_color = {1, 0, 0};
  scene.surfaces[0].front.diffuse = scene.surfaces[0].back.diffuse = {0, 1, 0};
  const Image image = draw(scene, mesh, options);
  double red = 0;
  double all = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto* const pixel = image.pixel(x, y);
      red += pixel[0];
      all += pixel[0] > 0 || pixel[1] > 0 ? 255 : 0;
    }
  }
  return red / all;
}

TEST(Lines, AreAsWideInPixelsAsIsAskedForHoweverManySamplesThereAre) {
  const double thin = share_of_lines({400, 300, 2}, 2);
  EXPECT_NEAR(share_of_lines({400, 300, 1}, 2), thin, 0.1 * thin);
  EXPECT_NEAR(share_of_lines({400, 300, 4}, 2), thin, 0.1 * thin);
  EXPECT_NEAR(share_of_lines({400, 300, 2}, 4), 2 * thin, 0.2 * thin);
}

TEST(Lines, TakeTheSameShareOfLargerPictures) {
  const double usual = share_of_lines({800, 600, 2});
  EXPECT_NEAR(share_of_lines({1600, 1200, 2}), usual, 0.1 * usual);
  EXPECT_NEAR(share_of_lines({3200, 2400, 1}), usual, 0.1 * usual);
}

TEST(Renderer, DrawsTheSameAgainAndAfterAMeshIsReplaced) {
  const std::array meshes{torus_mesh(2, 1, {24, 24, 8}), plane_mesh(dvec3(0.5), 1.5)};
  const Scene scene = scene_of(2);
  const PictureSettings options{120, 90, 2};
  const Image fresh = draw(scene, meshes, options);
  const auto context = make_osmesa_context();
  Renderer renderer;
  renderer.set_mesh(0, plane_mesh(dvec3(5), 3));
  renderer.set_mesh(1, meshes[1]);
  const FittedCamera camera = fit_to_meshes(scene, meshes, dvec2(120, 90));
  EXPECT_NE(draw_image(renderer, scene, camera, options).rgba, fresh.rgba);
  renderer.set_mesh(0, meshes[0]);
  EXPECT_EQ(draw_image(renderer, scene, camera, options).rgba, fresh.rgba);
  EXPECT_EQ(draw_image(renderer, scene, camera, options).rgba, fresh.rgba);
}

TEST(Renderer, ReportsItsNameAndTimes) {
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  const Rendering rendering = render(scene_of(1), std::span(&mesh, 1), {40, 30, 1});
  EXPECT_EQ(rendering.renderer, "osmesa");
  EXPECT_GT(rendering.times.context, 0);
  EXPECT_GT(rendering.times.upload, 0);
  EXPECT_GT(rendering.times.draw, 0);
}

TEST(Renderer, DrawsTheSamePictureThroughEgl) {
  try {
    make_context(Backend::Egl);
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  const Mesh mesh = torus_mesh(2, 1, {64, 64, 8});
  const PictureSettings picture{200, 150, 2};
  const Rendering egl = render(scene_of(1), std::span(&mesh, 1), picture, Backend::Egl);
  const Rendering osmesa = render(scene_of(1), std::span(&mesh, 1), picture, Backend::Osmesa);
  EXPECT_EQ(egl.renderer, "egl");
  EXPECT_EQ(osmesa.renderer, "osmesa");
  constexpr double kIndistinguishable = 0.01;  // of the scale of compare_images()
  EXPECT_LT(compare_images(egl.image, osmesa.image).error, kIndistinguishable);
}

TEST(Renderer, NamesThePackageOfALibraryThatIsMissing) {
  const std::array names{"libnonsense.so.1", "libnonsense.so"};
  try {
    const Library library(names, "libnonsense1");
    FAIL() << "such a library was found";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Machine);
    EXPECT_NE(std::string(error.what()).find("libnonsense.so.1"), std::string::npos);
    EXPECT_NE(error.hint().find("libnonsense1"), std::string::npos);
  }
}

TEST(Renderer, RefusesAnImpossibleCamera) {
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  Scene scene = scene_of(1);
  scene.camera.fov = 180;
  EXPECT_THROW(draw(scene, mesh, {40, 30, 1}), Error);
}

}  // namespace
}  // namespace saddle
