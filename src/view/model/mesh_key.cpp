#include "view/model/mesh_key.h"

#include <set>
#include <sstream>

#include "scene/model/assignments.h"
#include "scene/model/strokes.h"
#include "scene/options/options.h"
#include "scene/options/unused_definitions.h"

namespace saddle {
namespace {

/// The surface without what is looks alone.
std::string text_of(SurfaceSpec spec) {
  const SurfaceSpec standard;
  spec.front = standard.front;
  spec.back = standard.back;
  spec.colormap = standard.colormap;
  spec.opacity = standard.opacity;
  spec.line_color = standard.line_color;
  spec.line_width = standard.line_width;
  spec.visible = true;
  spec.texture = standard.texture;
  spec.shading.reset();
  spec.specular.reset();
  std::string text = write_keys(spec, Theme::Dark);
  for (const Definition& own : spec.definitions) text += own.name + "=" + own.text + "\n";
  return text;
}

/// The size of a pixel, and the part that is seen.
void add_camera(std::ostream& out, const Scene& scene) {
  const auto add = [&](const dvec3& v) { out << v.x << ' ' << v.y << ' ' << v.z << '\n'; };
  const Camera& camera = scene.camera;
  add(camera.view);
  add(camera.up);
  if (camera.target) add(*camera.target);
  if (camera.distance) out << double(*camera.distance);
  out << '\n' << double(camera.fov) << ' ' << double(camera.zoom) << ' ' << camera.ortho << ' ';
  out << camera.turn << ' ' << scene.picture.width << ' ' << scene.picture.height << '\n';
  add(scene.scale.factors);
}

/// Tolerances and boxes of the whole scene.
void add_settings(std::ostream& out, const Scene& scene) {
  const MeshSettings& mesh = scene.mesh;
  if (mesh.tolerance) out << mesh.tolerance->value << mesh.tolerance->pixels;
  out << '\n' << mesh.normal_tolerance << ' ' << mesh.max_triangles.value_or(0) << ' ';
  if (mesh.samples) out << mesh.samples->u << 'x' << mesh.samples->v;
  out << '\n' << scene.clip.automatic;
  if (scene.clip.box) {
    for (const dvec3& end : {scene.clip.box->low, scene.clip.box->high}) {
      out << ' ' << end.x << ' ' << end.y << ' ' << end.z;
    }
  }
  out << '\n';
}

/// Definitions that are used, be it through others; t, if it is.
void add_definitions(std::ostream& out, const Scene& scene, std::set<std::string> words, bool all) {
  take_used(scene.definitions, words);
  for (const Definition& definition : scene.definitions) {
    if (!all && !words.contains(definition.name)) continue;
    out << definition.name;
    for (const std::string& argument : definition.arguments) out << ' ' << argument;
    out << '=' << definition.text << '\n';
  }
  if (all || words.contains("t")) out << "t=" << double(scene.t) << '\n';
}

}  // namespace

std::string mesh_key(const Scene& scene, const SurfaceSpec& spec) {
  std::ostringstream out;
  out.precision(17);
  out << text_of(spec);
  add_camera(out, scene);
  add_settings(out, scene);
  // A curve or a point may be on any surface; a node may be moved by any definition.
  const bool depends_on_all = spec.is_stroke() || !spec.in.empty();
  add_definitions(out, scene, names_used_by(spec), depends_on_all);
  if (!depends_on_all) return out.str();
  for (const SurfaceSpec& other : scene.surfaces) {
    if (!other.is_stroke()) out << text_of(other);
  }
  if (spec.curve) out << write_keys(scene.curves[*spec.curve]);
  if (spec.point) out << write_keys(scene.points[*spec.point]);
  for (const SceneNode& node : scene.nodes) {
    out << node.name << " in " << node.in << '\n';
    for (const Transform& step : node.transform) {
      const dvec3 vector = step.vector;
      out << static_cast<int>(step.kind) << ' ' << vector.x << ' ' << vector.y << ' ' << vector.z
          << ' ' << double(step.angle) << '\n';
    }
  }
  return out.str();
}

}  // namespace saddle
