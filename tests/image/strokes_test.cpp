// Curves and points in pictures: where they are, what hides them, how wide they are.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "meshing/tessellate.h"
#include "render/picture/picture.h"
#include "scene/model/strokes.h"
#include "scene/options/resolve.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

constexpr int kSide = 101;

/// Seen from above, a unit 20 pixels wide; the middle pixel shows the origin.
Image picture_of(const std::string& toml) {
  const std::string camera =
      "[camera]\nview = [0, 0, 1]\nup = [0, 1, 0]\ntarget = [0, 0, 0]\ndistance = 10\n"
      "ortho = true\nfov = 28.3\n";
  const Scene scene = with_strokes(resolve(read_scene({"test", toml + camera})));
  std::vector<Mesh> meshes;
  for (const SurfaceSpec& spec : scene.surfaces) {
    meshes.push_back(tessellate(scene, spec, {.picture = true}, 1).mesh);
  }
  PictureSettings settings = scene.picture;
  settings.width = settings.height = kSide;
  settings.antialias = 1;
  return render(scene, meshes, settings).image;
}

bool is_red(const Image& image, int x, int y) {
  const auto* const p = image.pixel(x, y);
  return p[0] > 200 && p[1] < 60 && p[2] < 60;
}

int red_in_column(const Image& image, int x) {
  int count = 0;
  for (int y = 0; y < kSide; ++y) count += is_red(image, x, y) ? 1 : 0;
  return count;
}

const std::string kPlane = "[[surface]]\nname = \"plane\"\nz = \"0\"\ngrid = [0, 0]\n";
const std::string kLine =
    "[[curve]]\non = \"plane\"\nu = \"s\"\nv = \"0\"\ns = [-1, 1]\ncolor = \"red\"\nwidth = 5\n";

TEST(Strokes, WinOverTheSurfaceThatTheyLieOn) {
  const Image image = picture_of(kPlane + kLine);
  for (int x = 35; x <= 65; ++x) EXPECT_EQ(red_in_column(image, x), 5) << x;
  EXPECT_EQ(red_in_column(image, 15), 0);
}

TEST(Strokes, WinOverAnInclinedSurface) {
  const std::string slope = "[[surface]]\nname = \"plane\"\nz = \"1.5*v\"\ngrid = [0, 0]\n";
  const Image image = picture_of(slope + kLine);
  for (int x = 35; x <= 65; ++x) EXPECT_EQ(red_in_column(image, x), 5) << x;
}

/// A wide grid line on a steep plane, beside level lines that are thin: faces are behind the wider
/// ones of both.
TEST(Strokes, LeaveGridLinesWholeThatAreWiderThanLevelLines) {
  const std::string steep =
      "[[surface]]\nz = \"3*u\"\ngrid = [3, 0]\nline-width = 14\nline-color = \"red\"\n";
  const std::string levels =
      "[[surface]]\nz = \"0\"\nu = [2, 2.4]\nv = [2, 2.4]\ngrid = [0, 0]\n"
      "contours = [\"u=2.2\"]\nline-width = 0.5\n";
  const Image image = picture_of(steep + levels);
  for (int y = 35; y <= 65; ++y) {
    int red = 0;
    for (int x = 40; x <= 60; ++x) red += is_red(image, x, y) ? 1 : 0;
    EXPECT_EQ(red, 14) << y;
  }
}

TEST(Strokes, AreHiddenBehindOtherSurfaces) {
  const Image image = picture_of(kPlane + kLine + "[[surface]]\nz = \"1\"\nu = [0, 1]\n");
  EXPECT_EQ(red_in_column(image, 40), 5);
  EXPECT_EQ(red_in_column(image, 60), 0);
}

TEST(Strokes, PointsAreRoundDots) {
  const Image image = picture_of("[[point]]\nat = [0, 0, 0]\ncolor = \"red\"\nwidth = 21\n");
  const int middle = kSide / 2;
  EXPECT_EQ(red_in_column(image, middle), 21);
  EXPECT_TRUE(is_red(image, middle + 10, middle));
  EXPECT_FALSE(is_red(image, middle + 11, middle));
  EXPECT_FALSE(is_red(image, middle + 9, middle + 9)) << "the corner of a square";
}

TEST(Strokes, MoveWithTheNodesOfTheirSurface) {
  const std::string node = "[[node]]\nname = \"up\"\ntransform = [ { translate = [0, 1, 0] } ]\n";
  const Image image = picture_of(kPlane + "in = \"up\"\n" + kLine + node);
  const int middle = kSide / 2;
  EXPECT_TRUE(is_red(image, middle, middle - 20));
  EXPECT_FALSE(is_red(image, middle, middle));
}

TEST(Strokes, LabelsStandBesideTheirPoints) {
  const std::string point = "[[point]]\nat = [0, 0, 0]\ncolor = \"red\"\nwidth = 11\n";
  const Image bare = picture_of(point);
  const Image labelled = picture_of(point + "label = \"P\"\n");
  int changed = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      if (labelled.pixel(x, y)[2] == bare.pixel(x, y)[2]) continue;
      ++changed;
      EXPECT_FALSE(is_red(bare, x, y)) << "a letter on the dot";
      EXPECT_GT(x, kSide / 2);
      EXPECT_LE(x, kSide / 2 + 25);
    }
  }
  EXPECT_GT(changed, 10);
}

}  // namespace
}  // namespace saddle
