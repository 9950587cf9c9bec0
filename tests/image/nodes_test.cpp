// Surfaces and lights in nodes, against transforms written out in the test.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include <glm/ext/matrix_transform.hpp>

#include "image/analytic_mesh.h"
#include "image/lighting_reference.h"
#include "render/gl/context.h"
#include "render/gl/gl.h"
#include "render/picture/picture.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/instances.h"

namespace saddle {
namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 180;

/// Half a level of rounding; the mesh's normals are off by less than 1e-4 radians after stretching
/// by at most 4, where colours change by at most 5 per radian.
constexpr double kTolerance = 0.8;

Scene scene_of(const Transform& transform) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].in = {"node"};
  scene.nodes = {{"node", "", {transform}}};
  scene.camera.view = {0, 0, 1};
  scene.camera.up = {0, 1, 0};
  scene.camera.target = dvec3(0);
  scene.camera.distance = 10;
  return scene;
}

Transform scale(const dvec3& factor) {
  return {Transform::Kind::Scale, factor, 0};
}

Transform translate(const dvec3& way) {
  return {Transform::Kind::Translate, way, 0};
}

Transform rotate(double angle, const dvec3& axis) {
  return {Transform::Kind::Rotate, axis, angle};
}

Image draw(const Scene& scene, const Mesh& mesh) {
  return render(scene, std::span(&mesh, 1), {kWidth, kHeight, 1}).image;
}

/// Compares pixels with the ellipsoid of these half-axes around the target.
int compare_with_ellipsoid(const Scene& scene, const Image& image, const dvec3& axes,
                           const Material& material) {
  int compared = 0;
  const dvec3 centre(0, 0, -10);
  for (int y = 2; y < kHeight; y += 5) {
    for (int x = 2; x < kWidth; x += 5) {
      Sight sight = sight_through(scene.camera, kWidth, kHeight, x, y);
      // In coordinates where the ellipsoid is the unit sphere.
      const double length = glm::length(sight.along / axes);
      const Sight to_sphere{(sight.from - centre) / axes, sight.along / axes / length};
      const dvec3 on_sphere = meet_sphere(to_sphere, dvec3(0), 1, false);
      const dvec3 n = glm::normalize(on_sphere / axes);
      if (!(glm::dot(n, -sight.along) > 0.5)) continue;
      const dvec3 p = centre + on_sphere * axes;
      const dvec3 color = lit_color({p, n, -sight.along}, material, scene.lights);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(image.pixel(x, y)[c], 255 * color[c], kTolerance) << x << " " << y;
      }
      ++compared;
    }
  }
  return compared;
}

TEST(Nodes, TransformNormalsByTheInverseTranspose) {
  const dvec3 axes(2, 1, 0.5);
  const Scene scene = scene_of(scale(axes));
  const Image image = draw(scene, sphere_mesh(dvec3(0), 1, {256, 256, 0}));
  EXPECT_GT(compare_with_ellipsoid(scene, image, axes, kFrontMaterial), 50);
}

TEST(Scale, LightsTheSurfaceThatIsSeen) {
  const dvec3 axes(2, 1, 0.5);
  Scene scene = scene_of(scale(dvec3(1)));
  scene.scale = {.automatic = false, .factors = axes};
  const Mesh sphere = sphere_mesh(dvec3(0), 1, {256, 256, 0});
  const Image moved = draw(scene, sphere);
  scene.surfaces[0].in.clear();
  const Image image = draw(scene, sphere);
  EXPECT_GT(compare_with_ellipsoid(scene, image, axes, kFrontMaterial), 50);
  EXPECT_EQ(image.rgba, moved.rgba) << "a node that does nothing";
}

TEST(Scale, PutsTheTargetWhereThePictureHasIt) {
  Scene scene = scene_of(scale(dvec3(1)));
  scene.scale = {.automatic = false, .factors = {0.25, 1, 1}};
  const Mesh far = sphere_mesh(dvec3(40, 0, 0), 1, {64, 64, 0});
  scene.camera.target = dvec3(40, 0, 0);
  const Image image = draw(scene, far);
  EXPECT_GT(int{image.pixel(kWidth / 2, kHeight / 2)[0]}, 100);
}

TEST(Scale, KeepsTheShapeOfWhatIsThinInItsOwnUnits) {
  // A million times as high as wide: floats of one unit for all axes have no digits for the width.
  const Mesh sphere = sphere_mesh(dvec3(0), 1, {256, 256, 0});
  Mesh needle = transformed(sphere, glm::scale(glm::dmat4(1), dvec3(1, 1, 1e7)));
  Scene scene = scene_of(scale(dvec3(1)));
  scene.scale = {.automatic = false, .factors = {1, 1, 1e-7}};
  EXPECT_GT(compare_with_ellipsoid(scene, draw(scene, needle), dvec3(1), kFrontMaterial), 30);
}

TEST(Nodes, KeepFrontAndBackWhereTheyMirror) {
  const Mesh mesh = sphere_mesh(dvec3(0), 1, {256, 256, 0});
  for (const dvec3& factor : {dvec3(-1, 1, 1), dvec3(1, -2, 1), dvec3(-1, -1, -1)}) {
    const Scene scene = scene_of(scale(factor));
    EXPECT_GT(compare_with_ellipsoid(scene, draw(scene, mesh), glm::abs(factor), kFrontMaterial),
              50);
  }
}

TEST(Nodes, DrawAMeshOnceForEachThatItIsIn) {
  Scene scene = scene_of(translate(dvec3(-1.5, 0, 0)));
  scene.nodes.push_back({"right", "", {translate(dvec3(1.5, 0, 0))}});
  scene.surfaces[0].in.emplace_back("right");
  const Image image = draw(scene, sphere_mesh(dvec3(0), 1));
  // The spheres' centres, 1.5 to either side of the middle; 10 * tan(15 degrees) is half the
  // height.
  const int offset = static_cast<int>(1.5 / (10 * std::tan(std::numbers::pi / 12)) * kHeight / 2);
  EXPECT_GT(int{image.pixel(kWidth / 2 - offset, kHeight / 2)[0]}, 100);
  EXPECT_GT(int{image.pixel(kWidth / 2 + offset, kHeight / 2)[0]}, 100);
  EXPECT_EQ(int{image.pixel(kWidth / 2, kHeight / 2)[0]}, 0);
}

TEST(Nodes, ShareOneMeshHoweverManyTheyAre) {
  const auto context = make_osmesa_context();
  const Mesh mesh = sphere_mesh(dvec3(0), 1);
  const auto next_name = [] {  // of a buffer: that many have been made
    GLuint name = 0;
    glGenBuffers(1, &name);
    glDeleteBuffers(1, &name);
    return name;
  };
  const auto buffers_for = [&](int nodes) {
    const GLuint before = next_name();
    Scene scene;
    scene.surfaces.resize(1);
    for (int i = 0; i < nodes; ++i) {
      scene.nodes.push_back({std::to_string(i), "", {translate(dvec3(2.5 * i, 0, 0))}});
      scene.surfaces[0].in.push_back(std::to_string(i));
    }
    Renderer renderer;
    renderer.set_mesh(0, mesh);
    draw_image(renderer, scene, fit_to_meshes(scene, std::span(&mesh, 1), dvec2(kWidth, kHeight)),
               {kWidth, kHeight, 1});
    return next_name() - before;
  };
  const GLuint one = buffers_for(1);
  EXPECT_GE(one, 3U);  // vertices, triangles, lines
  EXPECT_EQ(buffers_for(200), one);
}

TEST(Nodes, ApplyTransformsAsTheyAreWrittenOutermostFirst) {
  Scene scene = scene_of(translate(dvec3(1, 2, 3)));
  scene.nodes[0].in = "outer";
  scene.nodes[0].transform.push_back(scale(dvec3(2)));
  scene.nodes.push_back({"outer", "", {rotate(90, dvec3(0, 0, 5))}});
  const glm::dvec4 moved = NodeFrames(scene).to_world("node") * glm::dvec4(1, 0, 0, 1);
  // (1, 0, 0) is doubled, moved to (3, 2, 3), and turned to (-2, 3, 3).
  EXPECT_NEAR(glm::length(dvec3(moved) - dvec3(-2, 3, 3)), 0, 1e-14);
}

TEST(Nodes, CarryLights) {
  // A spot that points along -x of a node which is turned so that this is -z, and stretched: its
  // direction goes as a vector does.
  Scene scene = scene_of(translate(dvec3(0)));
  scene.nodes.push_back(
      {"lamp",
       "",
       {translate(dvec3(0.3, 0, 4)), rotate(-90, dvec3(0, 1, 0)), scale(dvec3(3, 1, 1))}});
  Light light = {.position = {0, 0, 0}, .color = {0.8, 0.8, 0.8}, .frame = "lamp"};
  light.spot.emplace();
  light.spot->direction = dvec3(-1, 0, 0.3);
  light.spot->cutoff = 20;
  light.spot->inner = 2;
  scene.lights = {light};
  const Mesh mesh = plane_mesh(dvec3(0), 2);
  const Image image = draw(scene, mesh);
  // By -90 degrees about y, (x, y, z) goes to (-z, y, x).
  light.frame = "eye";
  light.position = dvec3(0.3, 0, 4 - 10);
  light.spot->direction = dvec3(-0.3, 0, -3);
  int lit = 0;
  for (int y = 5; y < kHeight; y += 10) {
    for (int x = 5; x < kWidth; x += 10) {
      const Sight sight = sight_through(scene.camera, kWidth, kHeight, x, y);
      const dvec3 p = meet_plane(sight, dvec3(0, 0, -10), dvec3(0, 0, 1));
      if (std::max(std::abs(p.x), std::abs(p.y)) > 1.99) continue;
      const dvec3 color = lit_color({p, dvec3(0, 0, 1), -sight.along}, kFrontMaterial, {light});
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(image.pixel(x, y)[c], 255 * color[c], kTolerance) << x << " " << y;
      }
      lit += color.r > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(lit, 20);
}

TEST(Nodes, WorldLightsStayWhenTheCameraTurns) {
  Scene scene = scene_of(rotate(30, dvec3(0, 0, 1)));
  scene.lights = {
      {.position = {0, 0, 1}, .directional = true, .color = {0.5, 0.5, 0.5}, .frame = "world"}};
  scene.surfaces[0].front.specular = {};
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  for (const dvec3& view : {dvec3(0, 0, 1), dvec3(1, 0.5, 1)}) {
    scene.camera.view = view;
    EXPECT_NEAR(draw(scene, mesh).pixel(kWidth / 2, kHeight / 2)[0], 127.5, 1);
  }
}

TEST(Nodes, PlaceExportedMeshesWhereTheyAreDrawn) {
  const glm::dmat4 mirror = NodeFrames(scene_of(scale(dvec3(-2, 1, 1)))).to_world("node");
  const Mesh mesh = sphere_mesh(dvec3(0), 1, {16, 16, 0});
  const Mesh moved = transformed(mesh, mirror);
  EXPECT_NEAR(moved.bounds.high.x, 2, 1e-12);
  for (const Triangle& t : moved.triangles) {
    const dvec3 a = moved.position[t[0]];
    const dvec3 cross = glm::cross(moved.position[t[1]] - a, moved.position[t[2]] - a);
    if (glm::length(cross) < 1e-9) continue;  // at a pole
    EXPECT_GT(glm::dot(cross, moved.normal[t[0]]), 0);
    EXPECT_GT(glm::dot(cross, a), 0);
  }
}

}  // namespace
}  // namespace saddle
