#include "scene/model/shader_normal.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "formula/glsl.h"
#include "formula/hoist.h"
#include "formula/scope.h"
#include "scene/model/prepare.h"
#include "surface/forms.h"

namespace saddle {
namespace {

/// Statements of a shader; compilers take a second for so many.
constexpr std::ptrdiff_t kLongestCode = 4000;

constexpr std::array<std::string_view, 6> kNames = {"r_u.x", "r_u.y", "r_u.z",
                                                    "r_v.x", "r_v.y", "r_v.z"};

std::vector<NodeId> derivatives(Graph& graph, const Scope& scope) {
  const Tangents tangents = tangents_of(graph, {scope.node("x"), scope.node("y"), scope.node("z")});
  std::vector<NodeId> roots(tangents.r_u.begin(), tangents.r_u.end());
  roots.insert(roots.end(), tangents.r_v.begin(), tangents.r_v.end());
  return roots;
}

}  // namespace

ShaderNormal shader_normal(const Scene& scene, const SurfaceSpec& spec) {
  ShaderNormal result;
  result.flip = bind_surface(scene, spec).flip;
  Graph graph;
  Scope scope(graph, surface_definitions(scene, spec), surface_view(scene, spec));
  const std::vector<NodeId> roots = derivatives(graph, scope);
  const auto values = [&](std::span<const NodeId> nodes) {
    std::vector<double> numbers;
    for (const NodeId node : scope.bind(nodes, scene.t)) numbers.push_back(graph[node].value);
    return numbers;
  };
  Hoisted hoisted = hoist(graph, roots, values);
  if (hoisted.values.size() > kMostConstants) hoisted = {scope.bind(roots, scene.t), {}, {}};
  const auto code = print_glsl(graph, hoisted.roots, kNames, hoisted.symbols);
  if (!code) {
    result.obstacle = "a function in it has no float version";
  } else if (std::ranges::count(*code, '\n') > kLongestCode) {
    result.obstacle = "its derivatives are too long for a shader";
  } else {
    result.code = *code;
    result.constants = std::move(hoisted.values);
  }
  return result;
}

}  // namespace saddle
