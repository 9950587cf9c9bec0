#include "view/model/meshed_scene.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "render/overlay/annotations.h"
#include "scene/model/color_scale.h"
#include "scene/model/prepare.h"

namespace saddle {

Bounds bounds_of(const Meshed& meshed) {
  Bounds bounds;
  for (const Instance& instance : instances(meshed.scene)) {
    bounds.add(transformed(meshed.surfaces[instance.surface]->mesh.bounds, instance.to_world));
  }
  return bounds;
}

ViewPyramid pyramid_beside_annotations(const Scene& scene,
                                       std::span<const std::shared_ptr<const SightedMesh>> surfaces,
                                       const Bounds& bounds, const dvec2& size) {
  std::vector<std::optional<ColorRange>> ranges;
  for (const auto& surface : surfaces) ranges.push_back(color_range_of(surface->mesh));
  return pyramid_beside_annotations(scene, scene.camera, bounds, color_scales(scene, ranges), size);
}

void add_meshes(const Meshed& meshed, ViewPyramid& seen) {
  for (const Instance& instance : instances(meshed.scene)) {
    const Mesh& mesh = meshed.surfaces[instance.surface]->mesh;
    add_points(mesh.position, mesh.bounds, instance.to_world, seen);
  }
}

FittedCamera fit_to(const Meshed& meshed, const PictureSettings& picture) {
  Bounds bounds = bounds_of(meshed);
  if (bounds.empty()) bounds.add(dvec3(0));
  const dvec2 size(picture.width, picture.height);
  ViewPyramid seen = pyramid_beside_annotations(meshed.scene, meshed.surfaces, bounds, size);
  add_meshes(meshed, seen);
  return fit_camera(drawn_camera(meshed.scene), bounds, size.x / size.y, &seen);
}

std::optional<SightedPoint> look_along(const Meshed& meshed, const Ray& ray) {
  std::optional<SightedPoint> nearest;
  for (const Instance& instance : instances(meshed.scene)) {
    const glm::dmat4 to_surface = glm::inverse(instance.to_world);
    const Ray own{dvec3(to_surface * glm::dvec4(ray.origin, 1)),
                  glm::dmat3(to_surface) * ray.direction};
    const SightedMesh& part = *meshed.surfaces[instance.surface];
    const auto hit = first_hit(part.mesh, part.boxes, own);
    if (hit && (!nearest || hit->distance < nearest->hit.distance)) nearest = {instance, own, *hit};
  }
  return nearest;
}

std::optional<PickedPoint> pick(const Meshed& meshed, const Ray& ray) {
  const auto sight = look_along(meshed, ray);
  if (!sight) return std::nullopt;
  const Instance& instance = sight->instance;
  const SurfaceSpec& spec = meshed.scene.surfaces[instance.surface];
  if (spec.curve) return std::nullopt;  // a tube has no u and v
  const Surface surface = prepare_surface(meshed.scene, spec, Order::Second).surface;
  const SurfacePlace place = place_on_surface(surface, sight->ray, sight->hit);
  const dvec3 world(instance.to_world * glm::dvec4(place.position, 1));
  const auto copies = places(meshed.scene, spec);
  const auto copy = std::ranges::find(copies, instance.to_world) - copies.begin();
  return PickedPoint{spec.name, instance.surface, static_cast<std::size_t>(copy), place,
                     world,     spec.parameters};
}

PickedPoint pick_again(const Meshed& meshed, const PickedPoint& picked) {
  const auto& surfaces = meshed.scene.surfaces;
  const auto gone = [&](const std::string& why) {
    return Error(Status::Input, "the picked point is gone: " + why);
  };
  std::size_t index = picked.index;
  if (index >= surfaces.size() || surfaces[index].name != picked.surface) {
    const auto found = std::ranges::find(surfaces, picked.surface, &SurfaceSpec::name);
    if (found == surfaces.end()) throw gone("there is no surface '" + picked.surface + "'");
    index = static_cast<std::size_t>(found - surfaces.begin());
  }
  const SurfaceSpec& spec = surfaces[index];
  const auto copies = places(meshed.scene, spec);
  if (picked.copy >= copies.size()) throw gone("its surface is in fewer nodes");
  const auto place =
      place_at(prepare_surface(meshed.scene, spec, Order::Second).surface, picked.place.uv);
  if (!place)
    throw gone("its " + spec.parameters[0] + " and " + spec.parameters[1] + " are not on '" +
               spec.name + "'");
  const dvec3 world(copies[picked.copy] * glm::dvec4(place->position, 1));
  return {spec.name, index, picked.copy, *place, world, spec.parameters};
}

std::string describe(const PickedPoint& picked) {
  const SurfacePlace& p = picked.place;
  std::ostringstream text;
  text.precision(9);
  text << picked.surface << ": " << picked.names[0] << ' ' << p.uv.x << ' ' << picked.names[1]
       << ' ' << p.uv.y << " x " << p.position.x << " y " << p.position.y << " z " << p.position.z;
  if (p.normal) {
    text << " normal " << p.normal->x << ' ' << p.normal->y << ' ' << p.normal->z;
  }
  text << " gauss " << p.curvature.gauss << " mean " << p.curvature.mean;
  return text.str();
}

}  // namespace saddle
