// What GLSL leaves undefined, each in a picture that would be black or white without a guard.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "image/analytic_mesh.h"
#include "image/lit_scene.h"

namespace saddle {
namespace {

/// What would be undefined without a guard: the picture is that of the other light alone.
TEST(Guards, KeepOneLightFromBlackeningTheOthers) {
  const Light good = {.position = {0, 0, 1}, .directional = true, .color = {0.5, 0.5, 0.5}};
  Light at_point = point_light({0, 0, -4});  // where the middle pixel is
  at_point.attenuation = {0, 1, 0, {}};
  Light spot_at_point = at_point;
  spot_at_point.spot = cone(90);
  spot_at_point.spot->exponent = 0;
  Light behind = point_light({0, 0, -5});
  Light spot_from_behind = behind;
  spot_from_behind.spot = cone(180);
  Light against_the_eye = {.position = {0, 0, -1}, .directional = true, .color = {1, 1, 1}};
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  const auto lit_by = [&mesh](Scene& scene, const std::vector<Light>& lights) {
    scene.lights = lights;
    return render(scene, std::span(&mesh, 1), {kWidth + 1, kHeight + 1, 1}).image;
  };
  for (Specular specular : {Specular::Phong, Specular::Blinn}) {
    for (Shading shading : {Shading::Pixel, Shading::Vertex}) {
      for (double shininess : {0.0, 32.0}) {
        Scene scene = lit_scene(4);
        scene.surfaces[0].front.shininess = shininess;
        scene.picture.specular = specular;
        scene.picture.shading = shading;
        const Image alone = lit_by(scene, {good});
        const auto* wanted = alone.pixel(kWidth / 2, kHeight / 2);
        for (const Light& bad :
             {at_point, spot_at_point, behind, spot_from_behind, against_the_eye}) {
          const Image image = lit_by(scene, {bad, good});
          const auto* got = image.pixel(kWidth / 2, kHeight / 2);
          for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], 1);
          EXPECT_GT(int{got[0]}, 100);
        }
      }
    }
  }
}

TEST(Guards, DrawNormalsOfLengthZeroAsUnlit) {
  Scene scene = lit_scene(4);
  scene.surfaces[0].front.emission = {0.2, 0.2, 0.2};
  Mesh mesh = plane_mesh(dvec3(0), 1);
  for (dvec3& n : mesh.normal) n = dvec3(0);
  expect_pixel(draw(scene, mesh), kWidth / 2, kHeight / 2, dvec3(0.2));
}

TEST(Guards, KeepTheNormalsOfAFlattenedSurface) {
  Scene scene = lit_scene(4);
  scene.nodes = {{"flat", "", {{Transform::Kind::Scale, dvec3(1, 1, 0), 0}}}};
  scene.surfaces[0].in = {"flat"};
  const Mesh mesh = plane_mesh(dvec3(0), 1);  // which is flat already; the matrix is singular
  const Image image = draw(scene, mesh);
  const Sight sight = sight_through(scene.camera, kWidth, kHeight, 180, 110);
  const dvec3 p = meet_plane(sight, dvec3(0, 0, -4), dvec3(0, 0, 1));
  expect_pixel(image, 180, 110,
               lit_color({p, dvec3(0, 0, 1), -sight.along}, kFrontMaterial, scene.lights));
  scene.nodes[0].transform[0].vector = dvec3(0, 0, 0);
  expect_pixel(draw(scene, mesh), 180, 110, dvec3(0));  // nothing is left of it
}

TEST(Guards, GiveAConeWhoseInnerAngleIsItsCutoffAHardEdge) {
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  Scene scene = lit_scene(4);
  Light light = point_light({0, 0, -1});
  light.spot = cone(12);
  scene.lights = {light};
  const Image hard = draw(scene, mesh);
  EXPECT_GT(int{hard.pixel(kWidth / 2 + 5, kHeight / 2 + 10)[0]}, 100);
  for (const auto falloff : {Spot::Falloff::Linear, Spot::Falloff::Smooth}) {
    for (const double cutoff : {12.0, 0.0}) {
      scene.lights[0].spot->cutoff = cutoff;
      scene.lights[0].spot->inner = cutoff;
      scene.lights[0].spot->falloff = falloff;
      if (cutoff > 0) {
        EXPECT_EQ(draw(scene, mesh).rgba, hard.rgba);
      } else {  // so narrow that nothing is lit
        expect_pixel(draw(scene, mesh), kWidth / 2 + 5, kHeight / 2 + 10, dvec3(0));
      }
    }
  }
}

/// Per vertex a corner may be where the eye is, and the light too; in perspective its triangles are
/// seen edge on.
TEST(Guards, LightACornerAtTheEye) {
  Mesh mesh = plane_mesh(dvec3(0), 1, {1, 1, 0});
  for (dvec3& p : mesh.position) p = dvec3(p.x, p.y, p.x > 0 && p.y > 0 ? 4.0 : 0.0);
  mesh.bounds.add(dvec3(1, 1, 4));
  for (const Specular specular : {Specular::Phong, Specular::Blinn}) {
    Scene scene = lit_scene(4);
    scene.camera.target = dvec3(1, 1, 0);  // the eye is at (1, 1, 4)
    scene.camera.ortho = true;
    scene.picture.shading = Shading::Vertex;
    scene.picture.specular = specular;
    scene.surfaces[0].back = scene.surfaces[0].front;
    scene.surfaces[0].front.emission = scene.surfaces[0].back.emission = {0.2, 0.2, 0.2};
    scene.lights = {point_light({0, 0, 0})};
    const Image image = draw(scene, mesh);
    int seen = 0;
    for (int i = 0; i < kWidth * kHeight; ++i) {
      const std::uint8_t* const pixel = image.rgba.data() + 4 * static_cast<std::ptrdiff_t>(i);
      if (pixel[0] + pixel[1] + pixel[2] == 0) continue;  // background
      ++seen;
      ASSERT_GE(int{pixel[0]}, 50);  // at least what it emits
    }
    EXPECT_GT(seen, 1000);
  }
}

}  // namespace
}  // namespace saddle
