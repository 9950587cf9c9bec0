// One surface in the light, as the tests of lighting look at it.
#pragma once

#include <span>

#include <gtest/gtest.h>

#include "image/lighting_reference.h"
#include "mesh/mesher/grid_mesh.h"
#include "render/picture/picture.h"
#include "scene/model/assignments.h"
#include "scene/model/prepare.h"

namespace saddle {

inline constexpr int kWidth = 320;
inline constexpr int kHeight = 240;

/// In 8-bit levels: half a level of rounding; the 256-cell sphere lies up to 7.5e-5 radii inside of
/// the true one, which turns the normal by as many radians and changes a colour by at most
/// 32 * 0.6 * 0.2 + 1.2 = 5 per radian, 0.1 levels; floats and the driver's pow: below 0.05.
inline constexpr double kTolerance = 0.65;

/// One surface under the three lights, one sample per pixel.
inline Scene lit_scene(double distance) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.lights = three_lights();
  scene.camera.view = {0, 0, 1};
  scene.camera.up = {0, 1, 0};
  scene.camera.target = dvec3(0);
  scene.camera.distance = distance;
  return scene;
}

inline Image draw(const Scene& scene, const Mesh& mesh) {
  return render(scene, std::span(&mesh, 1), {kWidth, kHeight, 1}).image;
}

inline void expect_pixel(const Image& image, int x, int y, const dvec3& color) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(image.pixel(x, y)[c], 255 * color[c], kTolerance)
        << "pixel " << x << " " << y << " channel " << c;
  }
  EXPECT_EQ(image.pixel(x, y)[3], 255);
}

/// A sphere whose corners know which of them are one point.
inline Mesh closed_sphere_mesh() {
  Scene scene;
  for (const char* text :
       {"x=cos(u)*cos(v)", "y=sin(u)*cos(v)", "z=sin(v)", "u=0:2*pi", "v=-pi/2:pi/2"}) {
    assign(scene, text);
  }
  GridOptions grid;
  grid.cells_u = grid.cells_v = 256;
  grid.lines_u = grid.lines_v = 0;
  return mesh_on_grid(prepare_surface(scene, scene.surfaces[0]).surface, grid).mesh;
}

inline Light point_light(const dvec3& position) {
  return {.position = position, .color = {0.9, 0.8, 0.7}};
}

inline Spot cone(double cutoff) {
  Spot spot;
  spot.direction = dvec3(0.1, -0.2, -3);
  spot.cutoff = cutoff;
  return spot;
}

}  // namespace saddle
