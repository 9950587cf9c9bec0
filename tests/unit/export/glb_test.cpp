#include "export/meshes/glb.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "base/error.h"
#include "base/image_png.h"
#include "exported.h"
#include "scene/model/texture.h"

namespace saddle {
namespace {

using Json = nlohmann::json;

/// A GLB file, read by the specification alone.
struct Glb {
  Json json;
  std::string bytes;

  explicit Glb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(number_in<std::uint32_t>(file, 4), 2U);
    EXPECT_EQ(number_in<std::uint32_t>(file, 8), file.size());
    const auto length = number_in<std::uint32_t>(file, 12);
    EXPECT_EQ(file.substr(16, 4), "JSON");
    EXPECT_EQ(length % 4, 0U);
    json = Json::parse(file.substr(20, length));
    if (20 + length == file.size()) return;
    EXPECT_EQ(number_in<std::uint32_t>(file, 20 + length), file.size() - 28 - length);
    bytes = file.substr(28 + length);
    EXPECT_EQ(json["buffers"][0]["byteLength"], bytes.size());
  }

  std::size_t begin_of(const Json& accessor) const {
    return json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"];
  }
  std::vector<dvec3> vectors(std::size_t number) const {
    const Json& accessor = json["accessors"][number];
    EXPECT_EQ(accessor["componentType"], 5126);
    std::vector<dvec3> result(accessor["count"]);
    std::size_t at = begin_of(accessor);
    for (dvec3& v : result) {
      for (int k = 0; k < 3; ++k, at += 4) v[k] = number_in<float>(bytes, at);
    }
    return result;
  }
  std::vector<std::size_t> indices(std::size_t number) const {
    const Json& accessor = json["accessors"][number];
    const bool is_long = accessor["componentType"] == 5125;
    std::vector<std::size_t> result(accessor["count"].get<std::size_t>());
    std::size_t at = begin_of(accessor);
    for (std::size_t& index : result) {
      index = is_long ? number_in<std::uint32_t>(bytes, at) : number_in<std::uint16_t>(bytes, at);
      at += is_long ? 4 : 2;
    }
    return result;
  }
  std::vector<dvec2> pairs(std::size_t number) const {
    std::vector<dvec2> result(json["accessors"][number]["count"].get<std::size_t>());
    std::size_t at = begin_of(json["accessors"][number]);
    for (dvec2& v : result) {
      for (int k = 0; k < 2; ++k, at += 4) v[k] = number_in<float>(bytes, at);
    }
    return result;
  }
  Image picture(std::size_t number) const {
    const Json& view = json["bufferViews"][json["images"][number]["bufferView"].get<std::size_t>()];
    return decode_png(bytes.substr(view["byteOffset"], view["byteLength"]), "the picture").image;
  }
  const Json& primitive(std::size_t k) const { return json["meshes"][0]["primitives"][k]; }
  const Json& material(std::size_t primitive_number) const {
    return json["materials"][primitive(primitive_number)["material"].get<std::size_t>()];
  }
};

glm::dmat4 matrix_of(const Json& node) {
  glm::dmat4 matrix(1);
  if (node.contains("translation")) {
    const Json& t = node["translation"];
    matrix = glm::translate(matrix, dvec3(t[0], t[1], t[2]));
  }
  if (node.contains("rotation")) {
    const Json& q = node["rotation"];
    matrix *= glm::mat4_cast(glm::dquat(q[3], q[0], q[1], q[2]));
  }
  if (node.contains("scale")) {
    const Json& s = node["scale"];
    matrix = glm::scale(matrix, dvec3(s[0], s[1], s[2]));
  }
  return matrix;
}

/// The ways from the root to each node with a mesh.
void collect(const Json& nodes, std::size_t number, const glm::dmat4& outer,
             std::vector<glm::dmat4>& found) {
  const Json& node = nodes[number];
  const glm::dmat4 matrix = outer * matrix_of(node);
  if (node.contains("mesh")) found.push_back(matrix);
  if (!node.contains("children")) return;
  for (const Json& child : node["children"]) collect(nodes, child, matrix, found);
}

std::vector<glm::dmat4> places_in(const Glb& glb) {
  std::vector<glm::dmat4> found;
  collect(glb.json["nodes"], 0, glm::dmat4(1), found);
  return found;
}

Glb glb_of(const Mesh& mesh, const Scene& scene = kSurfaceScene) {
  return Glb(bytes_of(write_glb, {{&mesh, 1}, scene}));
}

TEST(Glb, HasAPrimitiveOfOneSideForEachPartOfASolid) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].front.diffuse = {1, 0, 0};
  scene.surfaces[0].back.diffuse = {0, 0, 1};
  const Mesh mesh = thick_square();
  const Glb glb(bytes_of(write_glb, {{&mesh, 1}, scene}));
  ASSERT_EQ(glb.json["meshes"][0]["primitives"].size(), 3U);
  const std::size_t counts[] = {2, 2, 8};
  const dvec3 red_to_blue[] = {{1, 0, 0}, {0, 0, 1}, {0.21404, 0, 0.21404}};
  const auto position = glb.vectors(glb.primitive(0)["attributes"]["POSITION"]);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto corner = glb.indices(glb.primitive(k)["indices"]);
    EXPECT_EQ(corner.size(), 3 * counts[k]);
    EXPECT_EQ(glb.primitive(k)["attributes"], glb.primitive(0)["attributes"]);
    const Json& material = glb.material(k);
    EXPECT_FALSE(material.contains("doubleSided"));
    const Json& color = material["pbrMetallicRoughness"]["baseColorFactor"];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c].get<double>(), red_to_blue[k][c], 1e-4);
    // The box is around the origin: each triangle looks away from it.
    for (std::size_t i = 0; i < corner.size(); i += 3) {
      const dvec3 a = position[corner[i]];
      const dvec3 area = glm::cross(position[corner[i + 1]] - a, position[corner[i + 2]] - a);
      EXPECT_GT(glm::dot(area, a), 0) << k;
    }
  }
}

TEST(Glb, ColoursAllPartsOfASolidByNumbers) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].color = "u";
  const Mesh mesh = thick_square(true);
  const Glb glb(bytes_of(write_glb, {{&mesh, 1}, scene}));
  ASSERT_EQ(glb.json["meshes"][0]["primitives"].size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(glb.material(k)["pbrMetallicRoughness"].contains("baseColorTexture")) << k;
  }
}

TEST(Glb, HasTwoSheetsThatAreSeenFromOneSideEach) {
  const Glb glb = glb_of(open_square());
  ASSERT_EQ(glb.json["meshes"][0]["primitives"].size(), 2U);
  const auto front = glb.vectors(glb.primitive(0)["attributes"]["POSITION"]);
  const auto back = glb.vectors(glb.primitive(1)["attributes"]["POSITION"]);
  EXPECT_NEAR(front[0].z, 1e-5 * std::sqrt(2), 1e-9);
  EXPECT_NEAR(back[0].z, -1e-5 * std::sqrt(2), 1e-9);
  EXPECT_EQ(glb.vectors(glb.primitive(0)["attributes"]["NORMAL"])[0], dvec3(0, 0, 1));
  EXPECT_EQ(glb.vectors(glb.primitive(1)["attributes"]["NORMAL"])[0], dvec3(0, 0, -1));
  EXPECT_EQ(glb.indices(glb.primitive(0)["indices"]), (std::vector<std::size_t>{0, 1, 3, 0, 3, 2}));
  EXPECT_EQ(glb.indices(glb.primitive(1)["indices"]), (std::vector<std::size_t>{0, 3, 1, 0, 2, 3}));
  for (const std::size_t side : {0U, 1U}) EXPECT_FALSE(glb.material(side).contains("doubleSided"));
}

TEST(Glb, KeepsItsSheetsJoinedAtCreases) {
  const Mesh mesh = tetrahedron();  // each face has normals of its own
  const Glb glb = glb_of(mesh);
  ASSERT_GE(glb.json["meshes"][0]["primitives"].size(), 2U);
  const double gap = 1e-5 * std::sqrt(3);
  for (const std::size_t side : {0U, 1U}) {
    const auto position = glb.vectors(glb.primitive(side)["attributes"]["POSITION"]);
    for (std::size_t i = 0; i < position.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_EQ(mesh.point[i] == mesh.point[j], position[i] == position[j]);
      }
      // As far from the three faces at the origin, which the box has half of its size away.
      if (mesh.point[i] != 0) continue;
      const double off = side == 0 ? -gap : gap;
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(position[i][k], -0.5 + off, 1e-7);
    }
  }
}

TEST(Glb, HasOneSheetWhereSidesAreAlikeOrNoBackIsSeen) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].back = scene.surfaces[0].front;
  const Glb alike = glb_of(open_square(), scene);
  ASSERT_EQ(alike.json["meshes"][0]["primitives"].size(), 1U);
  EXPECT_EQ(alike.material(0)["doubleSided"], true);
  Mesh solid = tetrahedron();
  solid.lines.clear();
  const std::vector<dvec3> around = {{-1, -1, -1}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
  solid.bounds = {};
  for (std::size_t i = 0; i < solid.position.size(); ++i) {
    solid.position[i] = around[solid.point[i]];
    solid.bounds.add(solid.position[i]);
  }
  const Glb closed = glb_of(solid);
  ASSERT_EQ(closed.json["meshes"][0]["primitives"].size(), 1U);
  EXPECT_FALSE(closed.material(0).contains("doubleSided"));
}

TEST(Glb, HasLinearColours) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].front.diffuse = {1, 0.5, 0};
  const Json color = glb_of(open_square(), scene).material(0)["pbrMetallicRoughness"];
  EXPECT_EQ(color["baseColorFactor"][0], 1.0);
  EXPECT_NEAR(color["baseColorFactor"][1], 0.21404, 1e-5);  // of the sRGB standard
  EXPECT_EQ(color["baseColorFactor"][2], 0.0);
  EXPECT_EQ(color["metallicFactor"], 0.0);
}

TEST(Glb, BlendsWhatIsSeeThrough) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].opacity = 0.5;
  const Glb glb = glb_of(tetrahedron(), scene);
  EXPECT_EQ(glb.material(0)["alphaMode"], "BLEND");
  EXPECT_EQ(glb.material(0)["pbrMetallicRoughness"]["baseColorFactor"][3], 0.5);
  EXPECT_EQ(glb.json["meshes"][0]["primitives"].size(), 4U) << "backs are seen, and lines";
}

TEST(Glb, TurnsUpToYAndKeepsPlacesAsDoubles) {
  Scene scene = scene_of_surface();
  const Mesh mesh = tetrahedron({1e9, 0, 0});
  const Glb glb = glb_of(mesh, scene);
  const auto places = places_in(glb);
  ASSERT_EQ(places.size(), 1U);
  const auto points = glb.vectors(glb.primitive(0)["attributes"]["POSITION"]);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 p = places[0] * glm::dvec4(points[i], 1);
    const dvec3& q = mesh.position[i];
    EXPECT_NEAR(p.x, q.x, 1e-4);
    EXPECT_NEAR(p.y, q.z, 1e-4);
    EXPECT_NEAR(p.z, -q.y, 1e-4);
  }
}

TEST(Glb, HasOneMeshInAllOfItsNodes) {
  using Kind = Transform::Kind;
  Scene scene = scene_of_surface();
  // Scaling outside of a rotation shears: that takes two nodes of glTF.
  scene.nodes = {{"outer", "", {{Kind::Scale, dvec3(1, 3, 1), 0}}},
                 {"inner",
                  "outer",
                  {{Kind::Scale, dvec3(2, 1, 1), 0},
                   {Kind::Rotate, dvec3(0, 0, 2), 30},
                   {Kind::Translate, dvec3(1, 2, 3), 0}}}};
  scene.surfaces[0].in = {"outer", "inner"};
  const Mesh mesh = tetrahedron();
  const Glb glb = glb_of(mesh, scene);
  EXPECT_EQ(glb.json["meshes"].size(), 1U);
  const auto places = places_in(glb);
  ASSERT_EQ(places.size(), 2U);
  const glm::dmat4 outer = glm::scale(glm::dmat4(1), dvec3(1, 3, 1));
  glm::dmat4 inner = glm::scale(outer, dvec3(2, 1, 1));
  inner = glm::rotate(inner, glm::radians(30.0), dvec3(0, 0, 1));
  inner = glm::translate(inner, dvec3(1, 2, 3));
  for (const auto& [place, truth] : {std::pair{places[0], outer}, std::pair{places[1], inner}}) {
    const dvec3 p = dvec3(place * glm::dvec4(dvec3(0.1, 0.2, 0.3) - mesh.bounds.centre(), 1));
    const dvec3 q = dvec3(truth * glm::dvec4(0.1, 0.2, 0.3, 1));
    EXPECT_NEAR(p.x, q.x, 1e-12);
    EXPECT_NEAR(p.y, q.z, 1e-12);
    EXPECT_NEAR(p.z, -q.y, 1e-12);
  }
}

TEST(Glb, PutsLinesOffTheSurfaceWithoutLight) {
  const Glb glb = glb_of(tetrahedron());
  const Json& lines = glb.primitive(2);
  EXPECT_EQ(lines["mode"], 1);
  EXPECT_EQ(glb.indices(lines["indices"]), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(glb.material(2)["extensions"].contains("KHR_materials_unlit"));
  EXPECT_EQ(glb.json["extensionsUsed"], Json::array({"KHR_materials_unlit"}));
  const auto points = glb.vectors(lines["attributes"]["POSITION"]);
  EXPECT_NEAR(points[0].z, -0.5 - 1e-3 * std::sqrt(3), 1e-6);
}

TEST(Glb, ColoursByATextureAndUndefinedTrianglesGrey) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].color = "u";
  Mesh mesh = numbered_square();
  for (const std::uint32_t corner : {4U, 5U, 6U}) {
    mesh.position.push_back({corner == 5 ? 3 : 2, corner == 6 ? 1 : 0, 0});
    mesh.normal.push_back({0, 0, 1});
    mesh.uv.push_back({0, 0});
    mesh.point.push_back(std::uint32_t{corner});
    mesh.color.push_back(std::numeric_limits<double>::quiet_NaN());
    mesh.bounds.add(mesh.position.back());
  }
  mesh.point_count = 7;
  mesh.triangles.push_back({4, 5, 6});
  const Glb glb = glb_of(mesh, scene);
  const Json& look = glb.material(0)["pbrMetallicRoughness"];
  EXPECT_EQ(look["baseColorTexture"]["texCoord"], 0);
  EXPECT_EQ(glb.json["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(glb.indices(glb.primitive(1)["indices"]), (std::vector<std::size_t>{4, 5, 6}));
  const Json& grey = glb.material(1)["pbrMetallicRoughness"];
  EXPECT_FALSE(grey.contains("baseColorTexture"));
  EXPECT_NEAR(grey["baseColorFactor"][0], 0.21404, 1e-5);
  const Json& limits = glb.json["accessors"][glb.primitive(0)["attributes"]["POSITION"].get<int>()];
  EXPECT_EQ(limits["max"][0], 1.5);  // about the centre of 0 to 3
}

TEST(Glb, HasTheTextureOverTheRangesVFromAbove) {
  Image image(2, 1);
  image.rgba = {255, 0, 0, 255, 0, 0, 255, 255};
  std::ostringstream png;
  write_png(png, image);
  Scene scene = scene_of_surface();  // u and v: -1 to 1
  Texture& texture = scene.surfaces[0].texture;
  texture.picture = std::make_shared<TexturePicture>(TexturePicture{image, png.str()});
  texture.wrap = Texture::Wrap::Mirror;
  texture.filter = Texture::Filter::Nearest;
  texture.repeat = {4, 2};
  scene.surfaces[0].back = scene.surfaces[0].front;
  scene.surfaces[0].back.diffuse = {0, 1, 0};  // the picture is on both sides
  const Glb glb = glb_of(open_square(), scene);
  EXPECT_EQ(glb.json["meshes"][0]["primitives"].size(), 1U);
  EXPECT_EQ(glb.picture(0).rgba, image.rgba);
  EXPECT_EQ(glb.json["textures"], Json::parse(R"([{"sampler": 0, "source": 0}])"));
  EXPECT_EQ(glb.json["samplers"], Json::parse(R"([{"magFilter": 9728, "minFilter": 9728,
                                                   "wrapS": 33648, "wrapT": 33648}])"));
  const Json& look = glb.material(0)["pbrMetallicRoughness"];
  EXPECT_EQ(look["baseColorTexture"]["index"], 0);
  EXPECT_EQ(look["baseColorFactor"], Json::parse("[1.0, 1.0, 1.0, 1.0]"));
  // A corner's (u, v) is (0, 0), (1, 0), (0, 1), (1, 1).
  EXPECT_EQ(glb.pairs(glb.primitive(0)["attributes"]["TEXCOORD_0"]),
            (std::vector<dvec2>{{2, 0}, {4, 0}, {2, -1}, {4, -1}}));
}

TEST(Glb, HasAChequerboardOfEachSidesColour) {
  Scene scene = scene_of_surface();
  scene.surfaces[0].texture.name = kChecker;
  scene.surfaces[0].grid = GridSize{5, 5};  // 4 cells
  scene.surfaces[0].back.diffuse = {1, 0, 0};
  const Glb glb = glb_of(open_square(), scene);
  const Image back = glb.picture(glb.json["textures"][1]["source"]);
  const auto red_at = [&](int x, int y) { return back.pixel(x, y)[0]; };
  const int last = back.width - 1;
  EXPECT_EQ((std::array{red_at(0, 0), red_at(last, 0), red_at(0, last), red_at(last, last)}),
            (std::array<std::uint8_t, 4>{102, 255, 255, 102}));
  EXPECT_EQ(back.pixel(0, 0)[1], 0);
  EXPECT_EQ(glb.pairs(glb.primitive(0)["attributes"]["TEXCOORD_0"])[3], dvec2(2, -1));
}

TEST(Glb, HasThePicturesCamera) {
  Scene scene = scene_of_surface();
  scene.camera.fov = 40;
  const Json perspective = glb_of(tetrahedron(), scene).json["cameras"][0]["perspective"];
  EXPECT_NEAR(perspective["yfov"], glm::radians(40.0), 1e-12);
  EXPECT_NEAR(perspective["aspectRatio"], 4.0 / 3, 1e-12);
  scene.camera.ortho = true;
  EXPECT_EQ(glb_of(tetrahedron(), scene).json["cameras"][0]["type"], "orthographic");
}

TEST(Glb, RefusesWhatFloatsCannotHold) {
  EXPECT_THROW(glb_of(tetrahedron({1e39, 0, 0})), Error);
}

TEST(Glb, RefusesWhatIsNoGlb) {
  EXPECT_THROW(scene_in_glb("glTF", "a.glb"), Error);
  std::string file = bytes_of(write_glb, {{}, Scene()});
  EXPECT_TRUE(scene_in_glb(file, "a.glb"));
  file[20] = '?';
  EXPECT_THROW(scene_in_glb(file, "a.glb"), Error);
}

}  // namespace
}  // namespace saddle
