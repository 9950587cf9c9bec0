#include "export/obj.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "base/image_png.h"
#include "exported.h"
#include "scene/model/colormap.h"

namespace saddle {
namespace {

/// Lines of an OBJ or MTL by their first word, in order.
std::map<std::string, std::vector<std::string>> lines_of(const std::string& text) {
  std::map<std::string, std::vector<std::string>> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t space = line.find(' ');
    lines[line.substr(0, space)].push_back(line.substr(std::min(space + 1, line.size())));
  }
  return lines;
}

MeshContent named(const Mesh& mesh, const Scene& scene) {
  MeshContent content{{&mesh, 1}, scene};
  content.stem = "a b";
  return content;
}

TEST(Obj, WeldsPositionsAndSplitsNormals) {
  const Mesh mesh = tetrahedron();
  const Scene scene = scene_of_surface();
  auto lines = lines_of(bytes_of(write_obj, named(mesh, scene)));
  EXPECT_EQ(lines["v"].size(), 4U);
  EXPECT_EQ(lines["vn"].size(), 12U);
  EXPECT_EQ(lines["vt"].size(), 12U);
  EXPECT_EQ(lines["f"], (std::vector<std::string>{"1/1/1 3/2/2 2/3/3", "1/4/4 2/5/5 4/6/6",
                                                  "2/7/7 3/8/8 4/9/9", "1/10/10 4/11/11 3/12/12"}));
  EXPECT_EQ(lines["vn"][0], "0 0 -1");
  EXPECT_EQ(lines["vn"][6], "0.577350 0.577350 0.577350");
  EXPECT_EQ(lines["mtllib"], (std::vector<std::string>{"a b.mtl"}));
}

TEST(Obj, HasAMaterialForEachPartOfASolid) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].name = "s";
  scene.surfaces[0].front.diffuse = {1, 0, 0};
  scene.surfaces[0].back.diffuse = {0, 0, 1};
  for (const bool numbered : {false, true}) {
    if (numbered) scene.surfaces[0].color = "u";
    const Mesh mesh = thick_square(numbered);
    std::istringstream obj(bytes_of(write_obj, named(mesh, scene)));
    std::map<std::string, int> count;  // of the faces of each material
    std::string material;
    for (std::string line; std::getline(obj, line);) {
      if (line.starts_with("usemtl ")) material = line.substr(7);
      if (line.starts_with("f ")) ++count[material];
    }
    EXPECT_EQ(count, (std::map<std::string, int>{{"s", 2}, {"s-back", 2}, {"s-walls", 8}}));
    auto mtl = lines_of(bytes_of(write_mtl, named(mesh, scene)));
    const std::string white = "1 1 1";
    EXPECT_EQ(mtl["newmtl"][1], "s");
    EXPECT_EQ(mtl["newmtl"][2], "s-back");
    EXPECT_EQ(mtl["newmtl"][3], "s-walls");
    EXPECT_EQ(mtl["Kd"][1], numbered ? white : "1 0 0");
    EXPECT_EQ(mtl["Kd"][2], numbered ? white : "0 0 1");
    EXPECT_EQ(mtl["Kd"][3], numbered ? white : "0.5 0 0.5");
    EXPECT_EQ(mtl["map_Kd"].size(), numbered ? 3U : 0U);
  }
}

TEST(Obj, HasLinesInAnObjectOfTheirOwnAfterAllFaces) {
  const Mesh mesh = tetrahedron();
  const Scene scene = scene_of_surface();
  const std::string obj = bytes_of(write_obj, named(mesh, scene));
  auto lines = lines_of(obj);
  EXPECT_EQ(lines["o"], (std::vector<std::string>{"surface", "surface-lines"}));
  EXPECT_EQ(lines["l"], (std::vector<std::string>{"1 3"}));
  EXPECT_GT(obj.find("o surface-lines"), obj.rfind("\nf "));
}

TEST(Obj, OnStandardOutputNamesNoMaterials) {
  const Mesh mesh = tetrahedron();
  const Scene scene = scene_of_surface();
  auto lines = lines_of(bytes_of(write_obj, {{&mesh, 1}, scene}));
  EXPECT_EQ(lines.count("mtllib"), 0U);
  EXPECT_EQ(lines.count("usemtl"), 0U);
}

TEST(Obj, KeepsDoublesWhereFloatsWouldRound) {
  const Mesh mesh = tetrahedron({1e9, 0.1, 0});
  const Scene scene = scene_of_surface();
  auto lines = lines_of(bytes_of(write_obj, named(mesh, scene)));
  EXPECT_EQ(lines["v"][0], "1e+09 0.1 0");
  EXPECT_EQ(lines["v"][1], "1000000001 0.1 0");
}

TEST(Obj, NumbersTheSecondMeshBehindTheFirst) {
  const std::vector<Mesh> meshes = {tetrahedron(), open_square()};
  Scene scene = scene_of_surface();
  scene.surfaces.push_back(scene.surfaces[0]);
  auto lines = lines_of(bytes_of(write_obj, {meshes, scene}));
  EXPECT_EQ(lines["f"][4], "5/13/13 6/14/14 8/16/16");
  EXPECT_EQ(lines["o"][1], "surface-2") << "names differ";
}

TEST(Mtl, HasTheFrontsMaterialAndThatOfLines) {
  const Mesh mesh = tetrahedron();
  Scene scene = scene_of_surface();
  scene.surfaces[0].front.diffuse = {1, 0.5, 0};
  scene.surfaces[0].opacity = 0.25;
  auto lines = lines_of(bytes_of(write_mtl, named(mesh, scene)));
  EXPECT_EQ(lines["newmtl"], (std::vector<std::string>{"surface-lines", "surface"}));
  EXPECT_EQ(lines["Kd"][1], "1 0.5 0");
  EXPECT_EQ(lines["d"], (std::vector<std::string>{"1", "0.25"}));
  EXPECT_EQ(lines.count("map_Kd"), 0U);
}

TEST(Mtl, NamesThePictureOfColoursWhichCoordinatesPointInto) {
  const Mesh mesh = numbered_square();
  Scene scene = scene_of_surface();
  scene.surfaces[0].color = "u";
  const MeshContent content = named(mesh, scene);
  ASSERT_TRUE(is_colored(content));
  auto materials = lines_of(bytes_of(write_mtl, content));
  EXPECT_EQ(materials["map_Kd"], (std::vector<std::string>{"a b-color.png"}));
  EXPECT_EQ(materials["Kd"][1], "1 1 1");
  auto lines = lines_of(bytes_of(write_obj, content));
  EXPECT_EQ(lines["vt"][0], "0.001953125 0.5");  // the middle of the first pixel of 256
  EXPECT_EQ(lines["vt"][1], "0.9980469 0.5");
  const Image image = decode_png(bytes_of(write_color_png, content), "colours").image;
  ASSERT_EQ(image.width, 256);
  const dvec3 last = colormap_at("viridis", 1);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(image.pixel(255, 0)[k], 255 * last[k], 0.5);
}

}  // namespace
}  // namespace saddle
