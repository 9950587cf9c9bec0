// The walk over a page's triangles, followed as payload.js follows it.
#include "export/page/page_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <utility>

namespace saddle {
namespace {

/// From its least corner on.
Triangle turned(Triangle t) {
  std::ranges::rotate(t, std::ranges::min_element(t));
  return t;
}

/// The triangles that the codes tell, in numbers of the walk. The border is kept by its sides.
std::vector<Triangle> followed(const PageTriangles& walk, std::size_t count) {
  std::map<std::uint32_t, std::uint32_t> after;
  std::map<std::uint32_t, std::uint32_t> before;
  std::vector<std::array<std::uint32_t, 3>> gates;
  std::vector<Triangle> triangles;
  auto code = walk.codes.begin();
  std::uint32_t next = 0;
  const auto corner = [&](std::uint32_t said, std::uint32_t a) {
    if (said == PageTriangles::kNew) return next++;
    if (said == PageTriangles::kBehind) return before.at(a);
    return next - (said - PageTriangles::kOld);
  };
  const auto take = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.push_back({a, b, c});
    std::vector<std::array<std::uint32_t, 3>> open;
    for (const auto& [x, y, z] : {std::array{a, b, c}, std::array{c, a, b}, std::array{b, c, a}}) {
      if (after.contains(y) && after[y] == x) {
        after.erase(y);
      } else {
        open.push_back({x, y, z});
      }
    }
    for (const auto& [x, y, z] : open) {
      after[x] = y;
      before[y] = x;
      gates.push_back({x, y, z});
    }
  };
  while (triangles.size() < count || !gates.empty()) {
    if (gates.empty()) {
      const std::uint32_t a = corner(*code++, 0);
      const std::uint32_t b = corner(*code++, 0);
      take(a, b, corner(*code++, 0));
      continue;
    }
    const auto [a, b, c] = gates.back();
    gates.pop_back();
    if (!after.contains(a) || after[a] != b) continue;
    const std::uint32_t said = *code++;
    if (said != PageTriangles::kNothing) take(b, a, corner(said, a));
  }
  EXPECT_EQ(code, walk.codes.end());
  return triangles;
}

Mesh mesh_of(std::size_t corners, std::vector<Triangle> triangles) {
  Mesh mesh;
  mesh.position.resize(corners);
  mesh.triangles.assign(triangles.begin(), triangles.end());
  return mesh;
}

void expect_all(const Mesh& mesh) {
  const PageTriangles walk = page_triangles(mesh);
  std::vector<Triangle> found;
  for (const Triangle& t : followed(walk, mesh.triangles.size())) {
    found.push_back(turned({walk.corners[t[0]], walk.corners[t[1]], walk.corners[t[2]]}));
  }
  std::vector<Triangle> wanted;
  for (const Triangle& t : mesh.triangles) wanted.push_back(turned(t));
  std::ranges::sort(found);
  std::ranges::sort(wanted);
  EXPECT_EQ(found, wanted);
}

Mesh grid(std::uint32_t n) {
  std::vector<Triangle> triangles;
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i;
      triangles.push_back({a, a + 1, a + n + 2});
      triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh_of(std::size_t{n + 1} * (n + 1), std::move(triangles));
}

TEST(PageTriangles, AreAllThereOfAGrid) {
  expect_all(grid(1));
  expect_all(grid(20));
}

TEST(PageTriangles, AreAllThereWhateverSidesTheyShare) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t corners = 4 + round % 20;
    std::vector<Triangle> triangles;
    for (int k = 0; k < 40; ++k) {
      const auto any = [&] { return static_cast<std::uint32_t>(random() % corners); };
      const Triangle t = {any(), any(), any()};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }
    expect_all(mesh_of(corners, std::move(triangles)));
  }
}

TEST(PageTriangles, AreToldByTheirNeighbours) {
  const Mesh mesh = grid(40);
  const PageTriangles walk = page_triangles(mesh);
  const auto old = std::ranges::count_if(
      walk.codes, [](std::uint32_t code) { return code >= PageTriangles::kOld; });
  EXPECT_LT(static_cast<double>(old), 0.05 * static_cast<double>(mesh.triangles.size()));
}

TEST(PageTriangles, LeaveCornersOfLinesForTheEnd) {
  Mesh mesh = mesh_of(5, {{4, 2, 1}});
  mesh.lines.push_back({0, 2, 3});
  const PageTriangles walk = page_triangles(mesh);
  EXPECT_EQ(walk.corners, (std::vector<std::uint32_t>{4, 2, 1, 0, 3}));
  EXPECT_EQ(walk.guesses.back(), (PageTriangles::Guess{3, 3, 3}));
}

}  // namespace
}  // namespace saddle
