#include "meshing/solids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/format.h"
#include "mesh/model/tolerances.h"
#include "mesh/solid/fans.h"
#include "mesh/solid/solid_facts.h"
#include "mesh/solid/thicken.h"
#include "meshing/findings.h"
#include "meshing/place_groups.h"
#include "meshing/thickness.h"
#include "scene/model/instances.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

std::string told(double value) {
  return rounded(value, kToldDigits);
}

bool is_printed_in_millimetres(const Scene& scene) {
  return std::ranges::any_of(scene.surfaces, [&](const SurfaceSpec& spec) {
    const auto thickness = thickness_of(scene, spec);
    return thickness && thickness->millimetres;
  });
}

Error at_thickness(const SurfaceSpec& spec, const Thickness& thickness, const std::string& message,
                   const std::string& hint) {
  const std::string text = format_number(thickness.value);
  return {Status::Input, message, {spec.name + ": thickness", text, {0, text.size()}}, hint};
}

Mesh solid_of(const SurfaceSpec& spec, const Thickness& thickness, const Mesh& sheet, double unit) {
  const Thickening thickening = thickening_of(thickness, unit);
  const double largest =
      largest_of(glm::max(glm::abs(sheet.bounds.low), glm::abs(sheet.bounds.high)));
  if (!(thickening.total() > kRoundingOfSums * largest)) {
    throw at_thickness(spec, thickness, "so thin a solid is lost in the rounding of positions",
                       "for example --thickness " + told(sheet.bounds.diagonal() / 100));
  }
  if (!std::isfinite(thickening.total() * kLongestMitre + largest)) {
    throw at_thickness(spec, thickness, "so thick a solid exceeds the range of numbers",
                       "for example --thickness " + told(sheet.bounds.diagonal() / 100));
  }
  try {
    return thicken(sheet, thickening);
  } catch (const Error& error) {
    throw at_thickness(spec, thickness, error.what(),
                       "leave the side out: half of it then goes to each");
  }
}

/// The longest side of the box around all that is printed.
double longest_side(const Scene& scene, std::span<Tessellation* const> made, double unit) {
  Bounds all;
  for (const Instance& instance : instances(scene, World::True)) {
    const Tessellation* const surface = made[instance.surface];
    if (surface == nullptr) continue;
    const SurfaceSpec& spec = scene.surfaces[instance.surface];
    const auto thickness = thickness_of(scene, spec);
    const bool is_thick = thickness && (unit > 0 || !thickness->millimetres);
    const Mesh solid = is_thick ? solid_of(spec, *thickness, surface->mesh, unit) : surface->mesh;
    for (const dvec3& p : solid.position) all.add(dvec3(instance.to_world * glm::dvec4(p, 1)));
  }
  return all.empty() ? 0 : largest_of(all.size());
}

double unit_of(const Scene& scene, std::span<Tessellation* const> made) {
  if (!scene.mesh.print_size || !is_printed_in_millimetres(scene)) return 1;
  return units_per_millimetre(double(*scene.mesh.print_size),
                              [&](double unit) { return longest_side(scene, made, unit); });
}

void add_findings(const SolidReport& solid, const Domain& domain, std::vector<Finding>& findings) {
  if (solid.thickness > solid.largest_thickness && solid.at) {
    const dvec2& at = *solid.at;
    findings.push_back({Finding::Kind::TooThick,
                        "a thickness of " + told(solid.thickness) +
                            " folds the solid where the surface bends most, at " + domain.names[0] +
                            " = " + told(at.x) + ", " + domain.names[1] + " = " + told(at.y) +
                            "; the largest that does not is " + told(solid.largest_thickness),
                        true, solid.largest_thickness, "length", Finding::Place{at, at}});
  }
  const auto& [count, are_all] = solid.facts.crossings;
  if (count == 0) return;
  const std::string least = are_all ? "" : "at least ";
  const std::string pairs = count == 1 ? "1 pair" : std::to_string(count) + " pairs";
  findings.push_back({Finding::Kind::SolidCrosses,
                      "the solid goes through itself: " + least + pairs +
                          " of triangles cross; slicers fill what is enclosed twice",
                      true, static_cast<double>(count), "triangles"});
}

}  // namespace

void thicken_scene(const Scene& scene, std::span<Tessellation* const> made, bool measured,
                   unsigned threads) {
  const double unit = unit_of(scene, made);
  for (std::size_t i = 0; i < made.size(); ++i) {
    const SurfaceSpec& spec = scene.surfaces[i];
    const auto thickness = thickness_of(scene, spec);
    if (made[i] == nullptr || !thickness || made[i]->mesh.triangles.empty()) continue;
    Tessellation& surface = *made[i];
    surface.mesh = solid_of(spec, *thickness, surface.mesh, unit);
    if (!measured) continue;
    surface.solid = solid_report(solid_facts(surface.mesh, threads),
                                 thickening_of(*thickness, unit), surface.bends.value());
    add_findings(*surface.solid, surface.domain, surface.findings);
    surface.warnings = warnings_of(spec.name, surface.findings);
  }
}

}  // namespace saddle
