// Points and meshes of gallery surfaces, for the tests about them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh_requests.h"
#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/model/prepare.h"

namespace saddle {

inline Scene scene_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const GalleryEntry* const entry = find_gallery_entry(name);
  if (entry == nullptr) {
    ADD_FAILURE() << "no surface is called " << name;
    return {};
  }
  Scene scene = gallery_scene(*entry);
  for (const std::string& text : overrides) override_assignment(scene, text);
  if (!scene.t.text.empty()) scene.t = std::stod(scene.t.text);
  return scene;
}

/// Its adaptive mesh within a share of the diagonal, clipped to the scene's box. `surface`: of
/// second order.
inline MeshResult mesh_of(const Surface& surface, const Scene& scene, double share) {
  MeshRequest options = within_share(share);
  options.clip = scene.clip.box;
  return try_mesh(surface, options).value();
}

inline std::vector<double> spread(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low + (high - low) * i / (count - 1));
  return values;
}

/// Points on a grid that includes the ends of both ranges; v outer.
struct Samples {
  std::vector<double> u;
  std::vector<double> v;
  std::vector<SurfacePoint> points;

  const SurfacePoint& at(std::size_t i, std::size_t j) const { return points[j * u.size() + i]; }
};

inline Samples sample(const Scene& scene, int count) {
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0)).surface;
  const Domain& d = surface.domain;
  Samples samples{spread(d.u0, d.u1, count), spread(d.v0, d.v1, count), {}};
  samples.points = evaluate_on_grid(surface, samples.u, samples.v);
  return samples;
}

}  // namespace saddle
