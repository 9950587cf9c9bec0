// Surfaces with a thickness: closed, oriented, two-manifold, and of the right volume.
#include "mesh/solid/solid_facts.h"
#include "mesh/solid/thicken.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mesh/model/topology.h"
#include "mesh_checks.h"
#include "meshing/tessellate.h"
#include "scene/model/gallery.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

using Directed = std::pair<std::uint32_t, std::uint32_t>;

/// Why a mesh is no closed, oriented two-manifold by the given numbers of its points; empty: it is.
/// Each directed edge is there once, and so is its reverse; the triangles at a point are one ring.
std::string manifold_defect(const Mesh& mesh, const Array<std::uint32_t>& point) {
  std::map<Directed, std::uint32_t> apex;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Directed side = {point[t[k]], point[t[(k + 1) % 3]]};
      if (side.first == side.second) return "a triangle with two corners at one point";
      if (!apex.emplace(side, point[t[(k + 2) % 3]]).second) return "a directed edge twice";
    }
  }
  std::map<std::uint32_t, std::size_t> degree;
  for (const auto& [side, third] : apex) {
    if (!apex.contains({side.second, side.first})) return "an edge with one triangle";
    ++degree[side.first];
  }
  std::map<std::uint32_t, bool> is_walked;
  for (const auto& [side, third] : apex) {
    if (std::exchange(is_walked[side.first], true)) continue;
    std::size_t steps = 0;
    std::uint32_t to = side.second;
    do {
      to = apex.at({side.first, to});
      ++steps;
    } while (to != side.second);
    if (steps != degree[side.first]) return "a point with several rings of triangles";
  }
  return "";
}

Scene plain_scene(const std::string& name) {
  return gallery_scene(name);
}

}  // namespace
}  // namespace saddle
