// Backs that nobody can see are not drawn, and nobody sees that.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <span>

#include "mesh/model/hidden_back.h"
#include "meshing/tessellate.h"
#include "render/gl/context.h"
#include "render/gl/target.h"
#include "render/picture/picture.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// Nothing else is of this colour.
const Color kMark{1, 0, 1};
/// Of 19200 pixels, some 500 of which are on the outline.
constexpr int kMostBacks = 30;

/// The same to look at, but nobody knows that it is closed.
Mesh torn(Mesh mesh) {
  mesh.point.resize(mesh.position.size());
  std::iota(mesh.point.begin(), mesh.point.end(), 0U);
  mesh.point_count = static_cast<std::uint32_t>(mesh.position.size());
  return mesh;
}

/// Lines would hide what is behind them, and means of samples what each of them is.
Scene bare(Scene scene) {
  scene.picture.width = kWidth;
  scene.picture.height = kHeight;
  scene.picture.antialias = 1;
  SurfaceSpec& surface = scene.surfaces.front();
  surface.grid = GridSize{0, 0};
  surface.back = {.diffuse = {}, .specular = {}, .emission = kMark};
  return scene;
}

/// Without the backs that are there because a sliver at the outline turns around as its corners
/// are rounded to a pixel's fractions.
void expect_same_but_for_backs(const Image& culled, const Image& whole) {
  int backs = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); i += 4) {
    const std::array pixel{whole.rgba[i], whole.rgba[i + 1], whole.rgba[i + 2]};
    if (pixel == std::array<std::uint8_t, 3>{255, 0, 255}) {
      ++backs;
    } else {
      ASSERT_TRUE(std::equal(&whole.rgba[i], &whole.rgba[i] + 4, &culled.rgba[i])) << i / 4;
    }
  }
  EXPECT_LE(backs, kMostBacks);
}

/// Compares pictures of a surface from several sides, if its back is hidden. Returns whether it is.
bool compare(PictureMaker& maker, Scene scene) {
  const Mesh mesh = tessellate(scene, scene.surfaces[0], {.picture = true}, 0).mesh;
  if (!hides_its_back(mesh)) return false;
  for (const dvec3& view : {dvec3(2, -3, 1.5), dvec3(-1, 0.2, 0.1), dvec3(0.3, 0.5, -2)}) {
    scene.camera.view = view;
    maker.set_surface(scene, 0, mesh);
    const Image culled = maker.draw(scene, std::span(&mesh, 1), scene.picture);
    maker.set_surface(scene, 0, torn(mesh));
    expect_same_but_for_backs(culled, maker.draw(scene, std::span(&mesh, 1), scene.picture));
  }
  return true;
}

TEST(Culling, LeavesClosedSurfacesAsTheyAre) {
  PictureMaker maker;
  for (const char* name : {"sphere", "ellipsoid", "torus", "astroidal-ellipsoid", "trefoil-tube",
                           "superellipsoid", "superellipsoid-star", "supertoroid"}) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(compare(maker, bare(resolve(gallery_scene(*find_gallery_entry(name))))));
  }
}

TEST(Culling, TakesNothingFromTheOthersOfTheGallery) {
  PictureMaker maker;
  for (const GalleryEntry& entry : gallery()) {
    SCOPED_TRACE(entry.name);
    Scene scene = bare(resolve(gallery_scene(entry)));
    scene.mesh.samples = {.u = 40, .v = 40};
    compare(maker, scene);
  }
}

TEST(Culling, ShowsTheEdgesOfBacksThroughAWireframe) {
  const auto context = make_osmesa_context();
  const Scene scene = bare(resolve(gallery_scene(*find_gallery_entry("sphere"))));
  const Mesh mesh = tessellate(scene, scene.surfaces[0], {.picture = true}, 0).mesh;
  ASSERT_TRUE(hides_its_back(mesh));
  const FittedCamera camera = fit_to_meshes(scene, std::span(&mesh, 1), dvec2(kWidth, kHeight));
  const Target target(kWidth, kHeight);
  Renderer renderer;
  const auto picture = [&](const Mesh& drawn) {
    renderer.set_mesh(0, drawn);
    const PixelRect all{0, 0, kWidth, kHeight};
    renderer.draw(scene, camera, {kWidth, kHeight, all}, {.lines = false, .wireframe = true});
    Image image(kWidth, kHeight);
    target.read(0, 0, 1, true, all, image);
    return image;
  };
  EXPECT_EQ(picture(mesh).rgba, picture(torn(mesh)).rgba);
}

bool hides(std::initializer_list<const char*> arguments) {
  Scene scene;
  for (const char* argument : arguments) assign(scene, argument);
  scene.mesh.samples = {.u = 48, .v = 36};
  return hides_its_back(tessellate(scene, scene.surfaces[0], {.picture = true}, 0).mesh);
}

TEST(Culling, NeedsASurfaceThatWindsAroundNothingTheOtherWay) {
  EXPECT_TRUE(
      hides({"x=(2+cos(v))*cos(u)", "y=(2+cos(v))*sin(u)", "z=sin(v)", "u=0:tau", "v=0:tau"}));
  // Half of a section like an eight turns its back outside.
  EXPECT_FALSE(
      hides({"x=(2+sin(2*v))*cos(u)", "y=(2+sin(2*v))*sin(u)", "z=sin(v)", "u=0:tau", "v=0:tau"}));
  // Inside out.
  EXPECT_FALSE(
      hides({"x=(2+cos(v))*cos(u)", "y=(2+cos(v))*sin(u)", "z=-sin(v)", "u=0:tau", "v=0:tau"}));
  // Open, though its areas add up to nothing.
  EXPECT_FALSE(hides({"x=cos(u)", "y=sin(u)", "z=v", "u=0:tau", "v=-1:1"}));
}

}  // namespace
}  // namespace saddle
