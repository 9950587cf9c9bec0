#include "export/losses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "export/scene_lines.h"
#include "exported.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

std::vector<Loss> losses(const char* extension, const Mesh& mesh,
                         const Scene& scene = kSurfaceScene) {
  const std::vector<Shells> shells = {shells_of(mesh)};
  return losses_of(*find_format(extension), {{&mesh, 1}, scene, shells});
}

std::string text_of(const std::vector<Loss>& losses, Loss::Kind kind) {
  const auto found = std::ranges::find(losses, kind, &Loss::kind);
  return found == losses.end() ? "" : found->text;
}

TEST(Losses, AreNoneOfASolidWithItsOwnColours) {
  for (const char* extension : {"ply", "stl", "obj", "glb", "3mf"}) {
    EXPECT_TRUE(losses(extension, tetrahedron()).empty()) << extension;
  }
}

TEST(Losses, AreNoneOfASheetMadeSolidInTwoColours) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].back.diffuse = {1, 0, 0};
  for (const char* extension : {"obj", "glb", "3mf"}) {
    EXPECT_TRUE(losses(extension, thick_square(), scene).empty()) << extension;
  }
  EXPECT_EQ(text_of(losses("stl", thick_square(), scene), Loss::Kind::Open), "");
  EXPECT_NE(text_of(losses("stl", thick_square(), scene), Loss::Kind::LeftOut), "");
}

TEST(Losses, TellOpenEdgesWhereFormatsAreForSolids) {
  for (const char* extension : {"stl", "3mf"}) {
    EXPECT_TRUE(text_of(losses(extension, open_square()), Loss::Kind::Open).find("4 open edges") !=
                std::string::npos)
        << extension;
  }
  EXPECT_TRUE(losses("ply", open_square()).empty());
}

TEST(Losses, NameWhatIsLeftOutAndTheFormatsThatHaveRoom) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].back.diffuse = {1, 0, 0};
  scene.surfaces[0].opacity = 0.5;
  EXPECT_EQ(text_of(losses("obj", open_square(), scene), Loss::Kind::LeftOut),
            "the colour of --back is left out; .glb and .3mf can hold all of it");
  EXPECT_EQ(text_of(losses("ply", open_square(), scene), Loss::Kind::LeftOut),
            "the colour of --back and --opacity are left out; .glb and .3mf can hold all of it");
  EXPECT_TRUE(losses("glb", open_square(), scene).empty());
}

TEST(Losses, TellRoundingAndFlattenedTriangles) {
  const auto stl = losses("stl", tetrahedron({1e9, 0, 0}));
  EXPECT_NE(text_of(stl, Loss::Kind::Rounded), "");
  EXPECT_NE(text_of(stl, Loss::Kind::Flattened).find("2 triangles"), std::string::npos);
  EXPECT_TRUE(losses("obj", tetrahedron({1e9, 0, 0})).empty());
}

TEST(Losses, TellThatPlyKeepsItsUnits) {
  Scene scene = scene_of_surface();
  scene.mesh.print_size = 80;
  EXPECT_NE(text_of(losses("ply", tetrahedron(), scene), Loss::Kind::Units), "");
  EXPECT_TRUE(losses("stl", tetrahedron(), scene).empty());
}

TEST(PrintSize, IsThatOfTheLongestSideInTheFilesUnit) {
  Scene scene = scene_of_surface();
  Mesh mesh = open_square();
  for (dvec3& p : mesh.position) p.x *= 4;
  const MeshContent content{{&mesh, 1}, scene};
  EXPECT_EQ(factor_of(*find_format("stl"), content), 1);
  scene.mesh.print_size = 80;
  EXPECT_DOUBLE_EQ(factor_of(*find_format("stl"), content), 20);
  EXPECT_DOUBLE_EQ(factor_of(*find_format("glb"), content), 0.02);  // metres
  EXPECT_EQ(factor_of(*find_format("ply"), content), 1);
}

TEST(Shells, AreTurnedOutwardPartByPart) {
  Mesh mesh = tetrahedron();
  const Mesh inner = tetrahedron({5, 0, 0}, true);
  for (std::size_t i = 0; i < inner.position.size(); ++i) {
    mesh.position.push_back(dvec3(inner.position[i]));
    mesh.normal.push_back(dvec3(inner.normal[i]));
    mesh.uv.push_back(dvec2(inner.uv[i]));
    mesh.point.push_back(4 + inner.point[i]);
    mesh.bounds.add(inner.position[i]);
  }
  mesh.point_count = 8;
  for (const Triangle& t : inner.triangles)
    mesh.triangles.push_back({t[0] + 12, t[1] + 12, t[2] + 12});
  const Shells shells = shells_of(mesh);
  EXPECT_TRUE(shells.is_solid());
  for (std::size_t t = 0; t < 8; ++t) EXPECT_EQ(shells.is_turned(t), t >= 4) << t;
}

TEST(SceneLines, KeepLongLinesWhole) {
  Scene scene = scene_of_surface();
  std::string formula = "0";
  while (formula.size() < 3000) formula += "+sin(u*v)";
  scene.surfaces[0].z = formula;
  scene.title = std::string(300, ' ') + "\xC3\xA4\xC3\xB6";
  const std::string lines = scene_lines(scene, "# ");
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    EXPECT_TRUE(line.starts_with("# ")) << line;
    EXPECT_LE(line.size(), 250U);
  }
  EXPECT_EQ(scene_in_lines("first\n" + lines + "v 1 2 3\n", "# ", 1), write_scene(scene));
  EXPECT_EQ(scene_in_lines("first\n# by hand\nv 1 2 3\n", "# ", 1), std::nullopt);
}

}  // namespace
}  // namespace saddle
