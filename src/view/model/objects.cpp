#include "view/model/objects.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "scene/model/theme.h"

namespace saddle {
namespace {

/// "torus" of "torus 2".
std::string stem_of(const std::string& name) {
  const std::size_t space = name.rfind(' ');
  if (space == std::string::npos || space + 1 == name.size()) return name;
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const bool is_number =
      std::all_of(name.begin() + static_cast<std::ptrdiff_t>(space) + 1, name.end(), is_digit);
  return is_number ? name.substr(0, space) : name;
}

bool is_taken(const Scene& scene, const std::string& name) {
  return std::ranges::find(scene.surfaces, name, &SurfaceSpec::name) != scene.surfaces.end() ||
         std::ranges::find(scene.curves, name, &CurveSpec::name) != scene.curves.end() ||
         std::ranges::find(scene.points, name, &PointSpec::name) != scene.points.end();
}

void draw_circle(CurveSpec& curve) {
  curve.x = "cos(2*pi*s)";
  curve.y = "sin(2*pi*s)";
  curve.z = "0";
  curve.s = CurveSpec{}.s;
}

/// Calls `change` for each name of a node that a list has.
void for_each_list(Scene& scene, const auto& change) {
  for (SurfaceSpec& spec : scene.surfaces) change(spec.in);
  for (CurveSpec& curve : scene.curves) change(curve.in);
  for (PointSpec& point : scene.points) change(point.in);
}

/// Objects, nodes and lights at one node are at another; `after` may be empty, the world.
void move_to_node(Scene& scene, const std::string& before, const std::string& after) {
  for_each_list(scene, [&](std::vector<std::string>& nodes) {
    std::ranges::replace(nodes, before, after);
    std::erase(nodes, "");
  });
  for (SceneNode& node : scene.nodes) {
    if (node.in == before) node.in = after;
  }
  for (Light& light : scene.lights) {
    if (light.frame == before) light.frame = after.empty() ? "world" : after;
  }
}

/// "(0+2*pi)/2"
std::string middle_of(const Range& range) {
  return "(" + range.min + "+" + range.max + ")/2";
}

}  // namespace

std::string free_name(const Scene& scene, const std::string& name) {
  const std::string stem = stem_of(name);
  std::string free = stem;
  for (int i = 2; is_taken(scene, free); ++i) free = stem + " " + std::to_string(i);
  return free;
}

Scene new_scene() {
  Scene scene;
  add_surface(scene);
  return scene;
}

void add_surface(Scene& scene) {
  SurfaceSpec spec = themed_surface(scene.theme);
  spec.name = free_name(scene, spec.name);
  spec.z = "u^2-v^2";
  scene.surfaces.push_back(std::move(spec));
}

void add_curve(Scene& scene) {
  CurveSpec curve;
  curve.name = free_name(scene, curve.name);
  draw_circle(curve);
  scene.curves.push_back(std::move(curve));
}

void add_point(Scene& scene) {
  PointSpec point;
  point.name = free_name(scene, point.name);
  point.at = Vector(0, 0, 1);
  scene.points.push_back(std::move(point));
}

bool is_on_surface(const StrokeSpec& stroke) {
  return !stroke.on.empty() || !stroke.u.empty() || !stroke.v.empty();
}

void put_on(const Scene& scene, CurveSpec& curve, const std::string& surface) {
  curve.on = curve.u = curve.v = curve.x = curve.y = curve.z = curve.xyz = "";
  const auto spec = std::ranges::find(scene.surfaces, surface, &SurfaceSpec::name);
  if (spec == scene.surfaces.end()) return draw_circle(curve);
  curve.on = surface;
  curve.u = "s";
  curve.v = middle_of(spec->v);
  curve.s = spec->u;
}

void put_on(const Scene& scene, PointSpec& point, const std::string& surface) {
  point.on = point.u = point.v = "";
  point.at.reset();
  const auto spec = std::ranges::find(scene.surfaces, surface, &SurfaceSpec::name);
  if (spec == scene.surfaces.end()) {
    point.at = Vector(0, 0, 1);
    return;
  }
  point.on = surface;
  point.u = middle_of(spec->u);
  point.v = middle_of(spec->v);
}

void add_node(Scene& scene) {
  SceneNode node;
  node.name = "node";
  for (int i = 2; std::ranges::count(scene.nodes, node.name, &SceneNode::name) > 0; ++i) {
    node.name = "node " + std::to_string(i);
  }
  scene.nodes.push_back(std::move(node));
}

void delete_node(Scene& scene, std::size_t index) {
  const SceneNode node = scene.nodes[index];
  scene.nodes.erase(scene.nodes.begin() + static_cast<std::ptrdiff_t>(index));
  move_to_node(scene, node.name, node.in);
}

/// A name that another node has is an error of the scene: it would have both.
void rename_node(Scene& scene, std::size_t index, const std::string& name) {
  const std::string before = std::exchange(scene.nodes[index].name, name);
  const bool is_other = std::ranges::count(scene.nodes, before, &SceneNode::name) == 0;
  if (is_other) move_to_node(scene, before, name);
}

void add_parameter(Scene& scene, const std::string& name) {
  if (std::ranges::find(scene.definitions, name, &Definition::name) != scene.definitions.end()) {
    return;
  }
  scene.definitions.push_back({name, "1"});
  scene.sliders.push_back({name, 0, 2});
}

}  // namespace saddle
