#include "scene/options/scene_limits.h"

#include <cstddef>
#include <string>

#include "base/error.h"
#include "formula/graph.h"
#include "scene/model/bind_stroke.h"
#include "scene/model/prepare.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

/// Most surfaces, curves and points of a scene: so many points take half a minute.
constexpr std::size_t kMostObjects = 20'000;
/// Most surfaces of a scene: one that its limit of triangles stops takes a hundredth of a second.
constexpr std::size_t kMostSurfaces = 2'000;
/// Most operations of all formulas of a scene together: a surface is sampled at some ten thousand
/// places before there is a mesh, and so many operations take some ten seconds there.
constexpr std::size_t kMostOperations = 1'000'000;
/// Most crossings of grid lines, of all surfaces together: 20,000 grids of 16x16 have 5 million.
constexpr std::size_t kMostCrossings = 6'000'000;
/// Most objects times definitions: each sees all definitions. So many take some seconds.
constexpr std::size_t kMostSeen = 2'000'000;

[[noreturn]] void refuse(const std::string& message, const std::string& hint) {
  throw Error(Status::Input, message, {}, hint);
}

}  // namespace

void check_counts(const Scene& scene) {
  const std::size_t objects = scene.surfaces.size() + scene.curves.size() + scene.points.size();
  if (objects > kMostObjects) {
    refuse(std::to_string(objects) + " surfaces, curves and points are too many",
           "at most " + std::to_string(kMostObjects) + "; nodes draw one surface in many places");
  }
  if (scene.surfaces.size() > kMostSurfaces) {
    refuse(std::to_string(scene.surfaces.size()) + " surfaces are too many",
           "at most " + std::to_string(kMostSurfaces) + "; nodes draw one surface in many places");
  }
  std::size_t crossings = 0;
  for (const SurfaceSpec& spec : scene.surfaces) {
    const GridSize lines = spec.grid_lines();
    crossings += static_cast<std::size_t>(lines.u) * static_cast<std::size_t>(lines.v);
  }
  if (crossings > kMostCrossings) {
    refuse("the grids of the surfaces have too many lines",
           "lines of u times lines of v, of all surfaces together, are at "
           "most " +
               std::to_string(kMostCrossings));
  }
  const std::size_t definitions = scene.definitions.size();
  if (definitions == 0 || objects <= kMostSeen / definitions) return;
  refuse(std::to_string(objects) + " surfaces, curves and points with " +
             std::to_string(definitions) + " definitions are too many",
         "at most 2 million, the one times the other");
}

void check_formulas(const Scene& resolved, const BindObject& bind) {
  std::size_t operations = 0;
  const auto count = [&](const Graph& graph) {
    operations += graph.size();
    if (operations <= kMostOperations) return;
    refuse("the formulas of the scene are too long together",
           "they have at most " + std::to_string(kMostOperations) +
               " operations, after definitions are put in");
  };
  for (std::size_t i = 0; i < resolved.surfaces.size(); ++i) {
    bind(surface_prefix(i), [&] { count(bind_surface(resolved, resolved.surfaces[i]).graph); });
  }
  for (std::size_t i = 0; i < resolved.curves.size(); ++i) {
    bind(curve_prefix(i), [&] { count(bind_curve(resolved, resolved.curves[i]).graph); });
  }
  for (std::size_t i = 0; i < resolved.points.size(); ++i) {
    bind(point_prefix(i), [&] { count(bind_point(resolved, resolved.points[i]).graph); });
  }
}

}  // namespace saddle
