#include "export/ply.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace saddle {
namespace {

/// What a PLY file holds, read by its header alone.
struct Ply {
  std::vector<std::string> vertex_properties;  ///< "float x" ...
  std::vector<std::map<std::string, double>> vertices;
  std::vector<std::vector<std::int32_t>> faces;
  std::size_t rest = 0;  ///< bytes after the last face
};

template <typename Number>
Number take(const std::string& bytes, std::size_t& at) {
  std::uint64_t bits = 0;  // put together byte by byte: whatever the machine's order
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    bits |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes.at(at++))) << 8 * i;
  }
  Number number;
  if constexpr (sizeof(Number) == 4) {
    const auto low = static_cast<std::uint32_t>(bits);
    std::memcpy(&number, &low, 4);
  } else {
    std::memcpy(&number, &bits, 8);
  }
  return number;
}

Ply read_ply(const std::string& bytes) {
  Ply ply;
  std::istringstream in(bytes);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "ply");
  std::getline(in, line);
  EXPECT_EQ(line, "format binary_little_endian 1.0");
  std::map<std::string, std::size_t> counts;
  std::string element;
  std::string list;
  while (std::getline(in, line) && line != "end_header") {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "element") {
      words >> element >> counts[element];
    } else if (word == "property" && element == "vertex") {
      ply.vertex_properties.push_back(line.substr(9));
    } else if (word == "property") {
      list = line;
    }
  }
  EXPECT_EQ(list, "property list uchar int vertex_indices");
  auto at = static_cast<std::size_t>(in.tellg());
  for (std::size_t i = 0; i < counts["vertex"]; ++i) {
    auto& vertex = ply.vertices.emplace_back();
    for (const std::string& property : ply.vertex_properties) {
      const std::size_t space = property.find(' ');
      const bool is_double = property.substr(0, space) == "double";
      vertex[property.substr(space + 1)] =
          is_double ? take<double>(bytes, at) : take<float>(bytes, at);
    }
  }
  for (std::size_t i = 0; i < counts["face"]; ++i) {
    auto& face = ply.faces.emplace_back(static_cast<std::uint8_t>(bytes.at(at++)));
    for (std::int32_t& index : face) index = take<std::int32_t>(bytes, at);
  }
  ply.rest = bytes.size() - at;
  return ply;
}

std::string written(const std::vector<Mesh>& meshes) {
  std::ostringstream out;
  std::vector<ExportedMesh> placed;
  for (const Mesh& mesh : meshes) placed.push_back({&mesh});
  write_ply(out, placed);
  return out.str();
}

/// A unit square of two triangles; its corners are `offset` away from floats that are exact.
Mesh square(double offset = 0) {
  Mesh mesh;
  for (int i = 0; i < 4; ++i) {
    const double u = i % 2;
    const double v = i / 2;
    mesh.position.push_back({u + offset, v + offset, offset});
    mesh.normal.push_back({0, 0, 1});
    mesh.uv.push_back({u + 0.1, v + 0.2});
    mesh.point.push_back(static_cast<std::uint32_t>(i));
    mesh.bounds.add(mesh.position.back());
  }
  mesh.point_count = 4;
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
  return mesh;
}

/// A grid of `side` x `side` corners, for files larger than a buffer.
Mesh grid(std::uint32_t side) {
  Mesh mesh;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      const double u = static_cast<double>(i) / side;
      const double v = static_cast<double>(j) / side;
      mesh.position.push_back({u, v, std::sin(u * v)});
      mesh.normal.push_back(glm::normalize(dvec3{u, v, 1}));
      mesh.uv.push_back({u, v});
      mesh.point.push_back(j * side + i);
      mesh.bounds.add(mesh.position.back());
      if (i == 0 || j == 0) continue;
      const std::uint32_t corner = j * side + i;
      mesh.triangles.push_back({corner - side - 1, corner - side, corner});
      mesh.triangles.push_back({corner - side - 1, corner, corner - 1});
    }
  }
  mesh.point_count = side * side;
  return mesh;
}

using Properties = std::vector<std::string>;
const Properties kFloats = {"float x",  "float y",  "float z",  "float nx",
                            "float ny", "float nz", "double u", "double v"};
const Properties kDoubles = {"double x",  "double y",  "double z", "double nx",
                             "double ny", "double nz", "double u", "double v"};

TEST(Ply, HoldsEveryCornerAndTriangle) {
  const Mesh mesh = grid(100);
  const Ply ply = read_ply(written({mesh}));
  EXPECT_EQ(ply.vertex_properties, kFloats);
  EXPECT_EQ(ply.rest, 0u);
  ASSERT_EQ(ply.vertices.size(), mesh.position.size());
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    const auto& vertex = ply.vertices[i];
    EXPECT_EQ(vertex.at("x"), static_cast<float>(mesh.position[i].x));
    EXPECT_EQ(vertex.at("y"), static_cast<float>(mesh.position[i].y));
    EXPECT_EQ(vertex.at("z"), static_cast<float>(mesh.position[i].z));
    EXPECT_EQ(vertex.at("nx"), static_cast<float>(mesh.normal[i].x));
    EXPECT_EQ(vertex.at("ny"), static_cast<float>(mesh.normal[i].y));
    EXPECT_EQ(vertex.at("nz"), static_cast<float>(mesh.normal[i].z));
    EXPECT_EQ(vertex.at("u"), mesh.uv[i].x);
    EXPECT_EQ(vertex.at("v"), mesh.uv[i].y);
  }
  ASSERT_EQ(ply.faces.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::vector<std::int32_t> expected(mesh.triangles[i].begin(), mesh.triangles[i].end());
    EXPECT_EQ(ply.faces[i], expected);
  }
}

TEST(Ply, WritesDoublesWhereFloatsWouldRound) {
  // Near 1000 floats are 6.1e-5 apart; they may round by 1e-7 of the square's diagonal, 1.4e-7.
  const Mesh mesh = square(1000.00001);
  const Ply ply = read_ply(written({mesh}));
  EXPECT_EQ(ply.vertex_properties, kDoubles);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(ply.vertices[i].at("x"), mesh.position[i].x);
    EXPECT_EQ(ply.vertices[i].at("z"), mesh.position[i].z);
    EXPECT_EQ(ply.vertices[i].at("nz"), mesh.normal[i].z);
  }
}

TEST(Ply, WritesFloatsWhereTheyAreExactEvenFarAway) {
  EXPECT_EQ(read_ply(written({square(4096)})).vertex_properties, kFloats);
}

TEST(Ply, ComparesTheRoundingWithTheDiagonal) {
  // Only the first corner rounds; a float near 0.5 (apart 2^-24) rounds 0.5 + e to 0.5 for
  // e < 2^-25 = 3e-8. The flat mesh's diagonal is the distance of its ends.
  const double rounding = 2e-8;
  for (const double share : {0.9, 1.1}) {
    Mesh mesh = square();
    for (dvec3& p : mesh.position) p = {0.5, 0, 0};
    mesh.position[0].x += rounding;
    mesh.position[3].x += rounding / (share * kFloatRounding);
    mesh.position[3].x = static_cast<float>(mesh.position[3].x);
    EXPECT_EQ(read_ply(written({mesh})).vertex_properties, share < 1 ? kFloats : kDoubles) << share;
  }
}

TEST(Ply, JoinsMeshesWithOneKindOfNumberForAll) {
  const Ply exact = read_ply(written({square(), square(2)}));
  EXPECT_EQ(exact.vertex_properties, kFloats);
  ASSERT_EQ(exact.vertices.size(), 8u);
  EXPECT_EQ(exact.vertices[7].at("x"), 3);
  const std::vector<std::vector<std::int32_t>> faces = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}};
  EXPECT_EQ(exact.faces, faces);
  EXPECT_EQ(read_ply(written({square(1000), square(1000.00001)})).vertex_properties, kDoubles);
  // A larger scene around it, and the same rounding is a smaller share of the diagonal.
  EXPECT_EQ(read_ply(written({square(1000.00001), square(-1 << 20)})).vertex_properties, kFloats);
}

TEST(Ply, WritesDoublesBeyondTheRangeOfFloats) {
  for (const double scale : {1e-170, 1e-41, 1e39, 1e200, 1.7e308}) {
    Mesh mesh = square();
    for (dvec3& p : mesh.position) p *= scale;
    const Ply ply = read_ply(written({mesh}));
    EXPECT_EQ(ply.vertex_properties, kDoubles) << scale;
    EXPECT_EQ(ply.vertices[3].at("x"), scale);
  }
}

TEST(Ply, HoldsNothingForNoMeshes) {
  for (const std::vector<Mesh>& meshes : {std::vector<Mesh>{}, std::vector<Mesh>(2)}) {
    const Ply ply = read_ply(written(meshes));
    EXPECT_EQ(ply.vertices.size(), 0u);
    EXPECT_EQ(ply.faces.size(), 0u);
    EXPECT_EQ(ply.rest, 0u);
  }
}

TEST(Ply, IsTheSameFileEveryTime) {
  EXPECT_EQ(written({grid(20)}), written({grid(20)}));
}

}  // namespace
}  // namespace saddle
