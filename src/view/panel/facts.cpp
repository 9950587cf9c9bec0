#include "view/panel/facts.h"

#include <algorithm>
#include <memory>

#include <imgui.h>

#include "base/format.h"
#include "mesh/model/mesh_report.h"
#include "view/panel/widgets.h"

namespace saddle {

void show_picked(const Model& model) {
  if (!model.picked()) return;
  const SurfacePlace& place = model.picked()->place;
  ImGui::Separator();
  const auto& [u, v] = model.picked()->names;
  ImGui::TextUnformatted(
      (u + formatted(" %.6g  ", place.uv.x) + v + formatted(" %.6g", place.uv.y)).c_str());
  const dvec3& p = place.position;
  show_wrapped(Tone::Plain, formatted("x %.6g  y %.6g  z %.6g", p.x, p.y, p.z));
  if (place.normal) {
    const dvec3& n = *place.normal;
    show_wrapped(Tone::Quiet, formatted("normal %.4f %.4f %.4f", n.x, n.y, n.z));
  } else {
    show_wrapped(Tone::Quiet, "no normal: a singular point");
  }
  const Curvature& c = place.curvature;
  show_wrapped(Tone::Quiet, formatted("Gauss %.5g  mean %.5g", c.gauss, c.mean));
  show_wrapped(Tone::Quiet, formatted("principal %.5g and %.5g", c.largest, c.smallest));
}

namespace {

bool has_triangles(const std::shared_ptr<const SightedMesh>& surface) {
  return !surface->mesh.triangles.empty();
}

}  // namespace

void show_figures(const Model& model, const Figures& figures) {
  const auto& surfaces = model.last_good().scene.surfaces;
  const bool are_named = std::ranges::count_if(model.meshes(), has_triangles) > 1;
  for (std::size_t i = 0; i < model.meshes().size(); ++i) {
    const auto& surface = model.meshes()[i];
    if (!has_triangles(surface)) continue;  // a line or a dot
    const MeshReport& report = surface->report;
    if (are_named) show_wrapped(Tone::Plain, surfaces[i].name);
    show_wrapped(Tone::Quiet, formatted("%zu triangles, %zu evaluations",
                                        surface->mesh.triangles.size(), report.evaluations));
    if (report.tolerance) {
      show_wrapped(Tone::Quiet,
                   formatted("error %.2g, tolerance %.2g", report.max_error, *report.tolerance));
    }
  }
  if (std::ranges::any_of(model.meshes(), has_triangles)) {
    show_wrapped(Tone::Quiet, formatted("meshed in %.1f ms", model.last_good().milliseconds));
  }
  if (figures.moving_ms) {
    show_wrapped(Tone::Quiet, formatted("drawn in %.1f ms while it moves", *figures.moving_ms));
  }
  if (const auto seconds = model.meshing_seconds()) {
    show_wrapped(Tone::Plain, formatted("meshing: %.0f s", *seconds));
  }
}

void show_warnings(const Model& model, const Figures& figures) {
  const auto show = [](const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) show_wrapped(Tone::Warning, for_panel(warning));
  };
  for (const auto& surface : model.meshes()) show(surface->warnings);
  show(figures.warnings);
}

}  // namespace saddle
