// Colours by a number, bars, letters and axes in pictures.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/analytic_mesh.h"
#include "image/lighting_reference.h"
#include "render/overlay/annotations.h"
#include "render/picture/picture.h"
#include "scene/model/colormap.h"

namespace saddle {
namespace {

/// A square that fills the picture, seen straight on with a light that shows its colours as they
/// are; its number is x from -1 to 1.
struct Square {
  Scene scene;
  Mesh mesh;

  explicit Square(const std::string& colormap = "viridis") {
    scene.surfaces.resize(1);
    SurfaceSpec& spec = scene.surfaces[0];
    spec.color = "x";
    spec.colormap = colormap;
    spec.front.specular = spec.back.specular = {0, 0, 0};
    scene.lights = {{.position = {0, 0, 1}, .directional = true, .color = {1, 1, 1}}};
    scene.camera.view = {0, 0, 1};
    scene.camera.up = {0, 1, 0};
    scene.camera.ortho = true;
    scene.camera.fov = 90;
    scene.camera.distance = 1;
    scene.camera.target = dvec3(0);
    mesh = analytic_mesh(
        [](double s, double t) {
          return AnalyticPoint{{2 * s - 1, 2 * t - 1, 0}, {0, 0, 1}};
        },
        {4, 4, 0});
    for (const dvec3& p : mesh.position) mesh.color.push_back(double{p.x});
    mesh.color_range = {-1, 1};
  }

  Image draw(int size = 200) const {
    return render(scene, std::span(&mesh, 1), {size, size, 1}).image;
  }

  /// Where the middle of a column of pixels is on the square, from 0 at the left to 1. The bar,
  /// which has the colours of `range`, pushes the square to the left.
  double place_of(int column, int size = 200, const ColorRange& range = {-1, 1}) const {
    const std::vector<ColorScale> scales = {{"x", scene.surfaces[0].colormap, range}};
    const auto camera = drawn_camera(scene);
    const auto seen = pyramid_beside_annotations(scene, camera, {}, scales, dvec2(size));
    return (column + 0.5) / size - seen.room().middle / 2;
  }
};

/// A level of rounding in the texture, one in the pixel, half of a filter's.
constexpr double kTwoAndAHalf = 2.5;

void expect_color(const Image& image, int x, int y, const dvec3& color) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(image.pixel(x, y)[k], 255 * color[k], kTwoAndAHalf) << x << " " << y;
  }
}

/// Left of the bar.
constexpr int kColumns = 110;

TEST(ColouredSurface, HasTheColourOfItsNumberAtEachPixel) {
  for (const char* name : {"viridis", "coolwarm", "turbo"}) {
    const Square square(name);
    const Image image = square.draw();
    for (int x = 1; x < kColumns; x += 3) {
      expect_color(image, x, 150, colormap_at(name, square.place_of(x)));
    }
  }
}

TEST(ColouredSurface, HasTheSameColourPerVertexOnAFineMesh) {
  Square square;
  const Image pixel = square.draw();
  square.scene.picture.shading = Shading::Vertex;
  square.mesh = Square().mesh;
  const Image vertex = square.draw();
  for (int k = 0; k < 3; ++k) {  // at a corner of the mesh
    EXPECT_NEAR(vertex.pixel(50, 150)[k], pixel.pixel(50, 150)[k], 3);
  }
}

TEST(ColouredSurface, HasItOnBothSides) {
  Square square;
  square.scene.camera.view = {0, 0, -1};
  const Image image = square.draw();
  for (int x = 1; x < kColumns; x += 3) {
    expect_color(image, x, 150, colormap_at("viridis", 1 - square.place_of(x)));
  }
}

TEST(ColouredSurface, IsGreyWhereItHasNoNumber) {
  Square square;
  for (double& number : square.mesh.color) number = std::numeric_limits<double>::quiet_NaN();
  expect_color(square.draw(), 60, 150, dvec3(0.5));
}

TEST(ColouredSurface, KeepsToTheScaleThatSurfacesShare) {
  Square square;
  std::vector<Mesh> meshes = {square.mesh, square.mesh};
  for (dvec3& p : meshes[1].position) p.z = -0.5;  // hidden
  meshes[1].color_range = {-3, 1};
  square.scene.surfaces.push_back(square.scene.surfaces[0]);
  const Image image = render(square.scene, meshes, {200, 200, 1}).image;
  expect_color(image, 50, 150, colormap_at("viridis", (1 + square.place_of(50, 200, {-3, 1})) / 2));
}

TEST(ColouredSurface, KeepsHugeAndTinyNumbersApart) {
  for (const double factor : {1e-200, 1e200}) {
    Square square;
    for (double& number : square.mesh.color) number *= factor;
    square.mesh.color_range = {-factor, factor};
    expect_color(square.draw(), 50, 150, colormap_at("viridis", square.place_of(50)));
  }
}

TEST(ColouredSurface, ShowsItsHighlights) {
  Square square;
  square.scene.surfaces[0].front.specular = {1, 1, 1};
  const Image image = square.draw();
  EXPECT_EQ(image.pixel(60, 150)[0], 255);
}

TEST(ColouredSurface, HasTheColourOfItsBarIfItIsUnlit) {
  for (const char* name : {"viridis", "coolwarm", "twilight"}) {
    Square square(name);
    square.scene.picture.shading = Shading::Unlit;
    square.scene.lights = three_lights();
    square.scene.surfaces[0].front.emission = {1, 0, 0};
    const Image image = square.draw(400);
    const std::vector<ColorScale> scales = {{"x", name, {-1, 1}}};
    const ColorBar bar = annotate(square.scene, {}, {}, scales, dvec2(400)).bars.at(0);
    for (int x = 2; x < 2 * kColumns; x += 3) {
      const double from_top = 1 - square.place_of(x, 400);  // the same number on the bar
      const auto y = static_cast<int>(bar.upper_left.y + from_top * bar.size.y);
      const auto* on_bar = image.pixel(static_cast<int>(bar.upper_left.x) + 3, y);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(image.pixel(x, 300)[k], on_bar[k], 2) << name << x;
      expect_color(image, x, 300, colormap_at(name, square.place_of(x, 400)));
    }
  }
}

TEST(Unlit, SurfacesHaveTheColoursOfTheirSides) {
  Square square;
  square.scene.surfaces[0].color.clear();
  square.mesh.color.clear();
  square.scene.picture.shading = Shading::Unlit;
  square.scene.lights = {};
  expect_color(square.draw(), 60, 150, {1, 1, 0.5});
  square.scene.camera.view = {0, 0, -1};
  expect_color(square.draw(), 60, 150, {0.5, 0.5, 1});
  const std::string shaders = render(square.scene, std::span(&square.mesh, 1), {8, 8, 1}).shaders;
  EXPECT_EQ(shaders.find("light_"), std::string::npos) << shaders;
  square.scene.picture.shading = Shading::Pixel;
  square.scene.lights = three_lights();
  const std::string lit = render(square.scene, std::span(&square.mesh, 1), {8, 8, 1}).shaders;
  EXPECT_EQ(lit.find("color = front"), std::string::npos) << lit;
}

/// A plain square with a level line from left to right, half way up from the middle; its true place
/// is `height` before the mesh.
Square square_with_line(double height) {
  Square square;
  square.scene.surfaces[0].color.clear();
  square.scene.surfaces[0].contours = {{"y", {}}};
  square.mesh.color.clear();
  square.mesh.contours = {{{-1, 0.5, height}, {1, 0.5, height}},
                          {{-1, 0.5, 0}, {1, 0.5, 0}},
                          {{0, 0, 1}, {0, 0, 1}},
                          {{0, 1}}};
  return square;
}

/// Rows of a column of pixels that have little green, as level lines and nothing else.
std::vector<int> rows_of_lines(const Image& image) {
  std::vector<int> rows;
  for (int y = 0; y < image.height; ++y) {
    if (image.pixel(100, y)[1] < 80) rows.push_back(y);
  }
  return rows;
}

TEST(ContourLines, AreSeenAlsoWhereTheMeshIsInFrontOfThem) {
  for (const double height : {-0.2, 0.0, 0.2}) {
    // half of the height from the middle: the eye is at distance 1 with an angle of 90 degrees
    EXPECT_EQ(rows_of_lines(square_with_line(height).draw()), (std::vector{49, 50})) << height;
  }
}

TEST(ContourLines, AreInPlaceOnASlenderSurfaceThatIsStretched) {
  Square square = square_with_line(0);
  constexpr double kSlender = 1e-3;
  for (dvec3& p : square.mesh.position) p.y *= kSlender;
  for (dvec3& p : square.mesh.contours.position) p.y *= kSlender;
  for (dvec3& p : square.mesh.contours.on_mesh) p.y *= kSlender;
  square.mesh.bounds = {{-1, -kSlender, 0}, {1, kSlender, 0}};
  square.scene.scale = {.automatic = false, .factors = {1, 1 / kSlender, 1}};
  EXPECT_EQ(rows_of_lines(square.draw()), (std::vector{49, 50}));
}

TEST(ContourLines, AreWiderThanTheGridAndInAColourOfTheirOwn) {
  Square square = square_with_line(0);
  const Image usual = square.draw();
  EXPECT_GT(usual.pixel(100, 49)[0], usual.pixel(100, 49)[1] + 100);
  square.scene.surfaces[0].line_color = {0, 0, 1};
  const Image chosen = square.draw();
  EXPECT_EQ(chosen.pixel(100, 49)[0], 0);
  EXPECT_EQ(chosen.pixel(100, 49)[2], 255);
  square.scene.surfaces[0].line_width = 3;
  EXPECT_EQ(rows_of_lines(square.draw()).size(), 6U);
}

TEST(Letters, HaveARimOfTheBackgroundsColourOnSurfaces) {
  Square square;
  square.scene.surfaces[0].color.clear();
  square.mesh.color.clear();
  square.scene.surfaces[0].label = "label";
  square.mesh.anchor = dvec3(0);
  square.scene.background = {0, 0, 1};
  const auto blue_pixels = [&] {
    const Image image = square.draw();
    int blue = 0;
    for (int y = 50; y < 150; ++y) {
      for (int x = 50; x < 150; ++x) {
        const auto* p = image.pixel(x, y);
        blue += p[0] == 0 && p[1] == 0 && p[2] == 255 ? 1 : 0;
      }
    }
    return blue;
  };
  EXPECT_GT(blue_pixels(), 30);
  square.scene.background.a = 0.5;  // for a page that is not known
  EXPECT_EQ(blue_pixels(), 0);
}

TEST(ColourBar, MarksEndsBeyondWhichThereAreNumbers) {
  Square square;
  const auto labels = [&](const ColorRange& range) {
    const std::vector<ColorScale> scales = {{"x", "viridis", range}};
    std::string all;
    for (const WrittenText& text : annotate(square.scene, {}, {}, scales, dvec2(400)).texts) {
      all += text.text + ";";
    }
    return all;
  };
  EXPECT_EQ(labels({-1, 1}).find("\u2264"), std::string::npos);
  EXPECT_NE(labels({-1, 1, true, false}).find("\u2264 \u22121.0;"), std::string::npos)
      << labels({-1, 1, true, false});
  EXPECT_EQ(labels({-1, 1, true, false}).find("\u2265"), std::string::npos);
  EXPECT_NE(labels({-1, 0.7777, true, true}).find("\u2265 0.7777;"), std::string::npos);
}

TEST(ColouredSurface, TakesOnlyWhatItNeedsOfTheShader) {
  Square square;
  const auto text = [&] {
    return render(square.scene, std::span(&square.mesh, 1), {8, 8, 1}).shaders;
  };
  for (const char* absent : {"front_diffuse", "front_ambient", "back_", "#if"}) {
    EXPECT_EQ(text().find(absent), std::string::npos) << absent << " in\n" << text();
  }
  EXPECT_NE(text().find("colormap"), std::string::npos);
  square.scene.surfaces[0].color.clear();
  EXPECT_EQ(text().find("color_number"), std::string::npos);
  EXPECT_EQ(text().find("colormap"), std::string::npos);
  EXPECT_EQ(text().find("tint"), std::string::npos);
}

TEST(ColourBar, ShowsTheColoursOfItsNumbers) {
  Square square;
  square.scene.background = {0, 0, 0};
  square.scene.surfaces[0].in = {"nowhere"};
  square.scene.nodes = {{"nowhere", "", {{Transform::Kind::Scale, dvec3(0), 0}}}};
  const Image image = square.draw(400);
  // The column in which most pixels have a colour is the bar's.
  std::vector<int> coloured(400);
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) {
      const auto* p = image.pixel(x, y);
      if (p[0] != p[1] || p[1] != p[2]) ++coloured[static_cast<std::size_t>(x)];
    }
  }
  const auto most = std::ranges::max_element(coloured);
  const auto x = static_cast<int>(most - coloured.begin()) + 2;
  EXPECT_NEAR(*most, 336, 3);  // 0.84 of the height
  const std::vector<ColorScale> scales = {{"x", "viridis", {-1, 1}}};
  const auto top =
      static_cast<int>(annotate(square.scene, {}, {}, scales, dvec2(400)).bars.at(0).upper_left.y);
  for (int y = top + 3; y < top + 331; y += 5) {
    expect_color(image, x, y, colormap_at("viridis", 1 - (y + 0.5 - top) / 336));
  }
}

TEST(Annotations, AreTheSameInOnePieceAndInTiles) {
  Square square;
  square.scene.axes = true;
  square.scene.camera.distance.reset();
  const std::span meshes(&square.mesh, 1);
  const PictureSettings options{150, 130, 2};
  const Image tiles = render_in_tiles(square.scene, meshes, options, 96).image;
  const Image whole = render(square.scene, meshes, options).image;
  std::size_t other = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
    other += std::abs(tiles.rgba[i] - whole.rgba[i]) > 1 ? 1U : 0U;
  }
  // Lines may take another sample here and there, where floats round the other way.
  EXPECT_LE(other, whole.rgba.size() / 400);
}

TEST(Annotations, OfWhichThereAreNoneChangeNothing) {
  Square square;
  square.scene.surfaces[0].color.clear();
  const Image plain = square.draw();
  square.mesh.color.clear();
  EXPECT_EQ(square.draw().rgba, plain.rgba);
}

TEST(Annotations, OnNothingHaveTheColourOfInkAndTheirOwnAlpha) {
  Square square;
  square.scene.axes = true;
  square.scene.camera.distance.reset();
  square.scene.background = {0, 0, 0, 0};
  const Image image = square.draw();
  int inked = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const auto* p = image.pixel(x, y);
      if (p[3] == 0 || p[3] == 255) continue;
      ++inked;
      EXPECT_NEAR(p[0], 127.5, 1);
    }
  }
  EXPECT_GT(inked, 20);
}

TEST(Box, IsHiddenByTheSurfaceAndNeverHidesIt) {
  // A sphere in its box: all pixels that the sphere has without axes, it has with them.
  Scene scene;
  scene.surfaces.resize(1);
  scene.lights = three_lights();
  scene.camera.distance = 6;
  scene.camera.target = dvec3(0);
  const Mesh mesh = sphere_mesh(dvec3(0), 1, {64, 64, 0});
  const auto draw = [&] { return render(scene, std::span(&mesh, 1), {200, 150, 1}).image; };
  const Image plain = draw();
  scene.axes = true;
  const Image boxed = draw();
  int lines = 0;
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 200; ++x) {
      const auto* before = plain.pixel(x, y);
      const auto* after = boxed.pixel(x, y);
      const bool is_sphere = before[0] + before[1] + before[2] > 0;
      if (is_sphere) {
        EXPECT_TRUE(std::equal(before, before + 4, after)) << x << " " << y;
      } else if (after[0] > 0) {
        ++lines;
      }
    }
  }
  EXPECT_GT(lines, 300);
}

}  // namespace
}  // namespace saddle
