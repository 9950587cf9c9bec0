#include "export/meshes/glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "export/meshes/glb_file.h"
#include "export/meshes/glb_meshes.h"
#include "export/meshes/placed_meshes.h"
#include "scene/model/camera.h"
#include "scene/model/texture.h"
#include "scene/model/theme.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

using Json = GlbFile::Json;

constexpr const char* kSceneKey = "saddle-scene";

Json json_of(const dvec3& v) {
  return {v.x, v.y, v.z};
}

Json json_of(const glm::dquat& q) {
  return {q.x, q.y, q.z, q.w};
}

/// Transforms of one node of glTF: a translation after a rotation after scaling.
struct NodeStep {
  Json json = Json::object();
  /// Steps are outermost first: a later one must be further inside.
  bool takes(Transform::Kind kind) const {
    switch (kind) {
      case Transform::Kind::Translate:
        return json.empty();
      case Transform::Kind::Rotate:
        return !json.contains("rotation") && !json.contains("scale");
      case Transform::Kind::Scale:
        return !json.contains("scale");
    }
    return false;
  }
  void take(const Transform& step) {
    const dvec3 vector = step.vector;
    switch (step.kind) {
      case Transform::Kind::Translate:
        json["translation"] = json_of(vector);
        break;
      case Transform::Kind::Rotate:
        json["rotation"] =
            json_of(glm::angleAxis(glm::radians(step.angle.value), glm::normalize(vector)));
        break;
      case Transform::Kind::Scale:
        json["scale"] = json_of(vector);
        break;
    }
  }
};

/// The steps of a node of the scene, outermost first; one at least.
std::vector<NodeStep> steps_of(const SceneNode& node) {
  std::vector<NodeStep> steps(1);
  for (const Transform& transform : node.transform) {
    if (!steps.back().takes(transform.kind)) steps.emplace_back();
    steps.back().take(transform);
  }
  return steps;
}

class GlbWriter {
 public:
  explicit GlbWriter(const MeshContent& content)
      : content_(content),
        scene_(content.scene),
        scales_(scales_of(scene_, content.meshes)),
        textures_(file_, content.threads) {}

  void write(std::ostream& out) {
    MeshContent own = content_;
    own.factor = 1;
    own.y_up = false;
    const std::vector<ExportedMesh> placed = placed_meshes(own);
    check_floats(placed, "GLB");
    Json& json = file_.json;
    json["asset"] = {{"version", "2.0"},
                     {"generator", "saddle"},
                     {"extras", {{kSceneKey, write_scene(scene_)}}}};
    json["scene"] = 0;
    json["scenes"] = {{{"name", scene_.title}, {"nodes", {0}}}};
    add_root();
    if (!scales_.empty()) colors_ = textures_.add_scales(scales_);
    for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) add_surface(i);
    add_camera(bounds_of(placed, true));
    file_.write(out);
  }

 private:
  Json& nodes() { return file_.json["nodes"]; }

  /// Adds a node below another one.
  std::size_t add_node(Json node, std::size_t parent) {
    const std::size_t number = nodes().size();
    nodes().push_back(std::move(node));
    nodes()[parent]["children"].push_back(number);
    return number;
  }

  void add_root() {
    Json root = {{"name", scene_.title}};
    const double half = std::sqrt(0.5);  // a quarter turn, from z up to y up
    root["rotation"] = {-half, 0.0, 0.0, half};
    const double f = content_.factor;
    if (f != 1) root["scale"] = {f, f, f};
    nodes().push_back(std::move(root));
  }

  void add_surface(std::size_t i) {
    const Mesh& mesh = content_.meshes[i];
    const SurfaceSpec& spec = scene_.surfaces[i];
    if (mesh.position.empty() || (mesh.triangles.empty() && !spec.is_stroke())) return;
    GlbSurface surface{mesh, spec, contour_color_of(spec, scene_.theme)};
    surface.unlit = shading_of(scene_, spec) == Shading::Unlit;
    if (!mesh.color.empty() && !scales_.empty()) {
      const ColorScale& scale = scale_of(spec, scales_);
      surface.scale = scale;
      surface.row = static_cast<std::size_t>(&scale - scales_.data());
      surface.rows = scales_.size();
      surface.colors = colors_;
    }
    if (spec.texture && !mesh.triangles.empty()) {
      surface.places = texture_places(scene_, spec, mesh.uv);
    }
    surfaces_.push_back(std::move(surface));
    const std::size_t number = add_mesh(surfaces_.back(), textures_, file_);
    const Json node = {
        {"name", spec.name}, {"mesh", number}, {"translation", json_of(mesh.bounds.centre())}};
    if (spec.in.empty()) add_node(node, 0);
    for (const std::string& name : spec.in) add_node(node, node_of(name));
  }

  /// The innermost node of a node of the scene.
  std::size_t node_of(const std::string& name) {
    if (const auto known = frames_.find(name); known != frames_.end()) return known->second;
    const SceneNode& node = *std::ranges::find(scene_.nodes, name, &SceneNode::name);
    std::size_t number = node.in.empty() ? 0 : node_of(node.in);
    for (const NodeStep& step : steps_of(node)) {
      Json json = {{"name", name}};
      json.update(step.json);
      number = add_node(std::move(json), number);
    }
    return frames_[name] = number;
  }

  void add_camera(const Bounds& bounds) {
    if (bounds.empty()) return;
    const double aspect = static_cast<double>(scene_.picture.width) / scene_.picture.height;
    const FittedCamera camera = fit_camera(scene_.camera, bounds, aspect);
    const glm::dmat4 to_world = glm::inverse(camera.world_to_eye);
    file_.json["cameras"] = {camera_json(camera, aspect)};
    add_node({{"name", "camera"},
              {"camera", 0},
              {"translation", json_of(dvec3(to_world[3]))},
              {"rotation", json_of(glm::normalize(glm::quat_cast(glm::dmat3(to_world))))}},
             0);
  }

  /// Lengths are in the file's units: a camera is not scaled by its nodes.
  Json camera_json(const FittedCamera& camera, double aspect) const {
    constexpr double kRoom = 10;  // around what is seen, for a camera that moves
    const double f = content_.factor;
    const double near = f * std::max(camera.near_plane, 1e-3 * camera.distance) / kRoom;
    const double far = f * camera.far_plane * kRoom;
    if (scene_.camera.ortho) {
      return {{"type", "orthographic"},
              {"orthographic",
               {{"xmag", f * camera.half_height * aspect},
                {"ymag", f * camera.half_height},
                {"znear", near},
                {"zfar", far}}}};
    }
    return {{"type", "perspective"},
            {"perspective",
             {{"aspectRatio", aspect},
              {"yfov", 2 * std::atan(camera.half_height / camera.distance)},
              {"znear", near},
              {"zfar", far}}}};
  }

  const MeshContent& content_;
  const Scene& scene_;
  std::vector<ColorScale> scales_;
  GlbFile file_;
  GlbTextures textures_;
  std::size_t colors_ = 0;                     ///< the texture of the scales
  std::deque<GlbSurface> surfaces_;            ///< the file refers to them
  std::map<std::string, std::size_t> frames_;  ///< nodes of the scene's nodes
};

}  // namespace

void write_glb(std::ostream& out, const MeshContent& content) {
  GlbWriter(content).write(out);
}

std::optional<std::string> scene_in_glb(const std::string& bytes, const std::string& name) {
  const Json json = json_of_glb(bytes, name);
  const Json::json_pointer place(std::string("/asset/extras/") + kSceneKey);
  if (!json.contains(place) || !json[place].is_string()) return std::nullopt;
  return json[place].get<std::string>();
}

}  // namespace saddle
