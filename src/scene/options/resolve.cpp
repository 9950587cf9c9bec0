// Replaces each expression of a scene by its number, by the tables of options and lights.
#include "scene/options/resolve.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/nearest.h"
#include "scene/model/choices.h"
#include "scene/model/resolver.h"
#include "scene/options/lights.h"
#include "scene/options/options.h"

namespace saddle {
namespace {

/// Deepest nesting of nodes: a robot has ten.
constexpr int kMaxNodeDepth = 256;

void resolve_node(Resolver& resolver, SceneNode& node) {
  const std::string prefix = node_prefix(node);
  for (Transform& step : node.transform) {
    switch (step.kind) {
      case Transform::Kind::Translate:
        resolver.vector(prefix + "translate", step.vector);
        break;
      case Transform::Kind::Rotate:
        resolver.number(prefix + "rotate", step.angle, kAny);
        resolver.direction(prefix + "rotate", step.vector);
        break;
      case Transform::Kind::Scale:
        resolver.vector(prefix + "scale", step.vector);
        break;
    }
  }
}

/// The value of a parameter is one of its choices.
void resolve_choice(Resolver& resolver, const std::vector<Definition>& definitions,
                    const Slider& slider) {
  const auto parameter = std::ranges::find(definitions, slider.name, &Definition::name);
  if (parameter == definitions.end()) return;  // an object took what it uses
  Number value(parameter->text);
  resolver.number(slider.name, value, kAny);
  check_choice(slider, value);
}

void resolve_sliders(Resolver& resolver, const std::string& prefix,
                     const std::vector<Definition>& definitions, std::vector<Slider>& sliders) {
  for (Slider& slider : sliders) {
    if (!slider.choices.empty()) {
      resolve_choice(resolver, definitions, slider);
      continue;
    }
    const std::string name = prefix + slider.name;
    resolver.number(name + ": min", slider.min, kAny);
    resolver.number(name + ": max", slider.max, kAny);
    resolver.number(name + ": step", slider.step, kNotNegative);
    if (slider.min < slider.max) continue;
    throw Error(Status::Input, "min must be less than max", {name + ": max", {}, {}});
  }
}

/// A colour map and a texture would both be the colour of a point.
void check_one_color(const SurfaceSpec& spec, const std::string& prefix) {
  if (spec.color.empty() || !spec.texture) return;
  throw Error(Status::Input, "a surface has a colour by a formula or a texture, not both",
              {prefix + "color", spec.color, {0, spec.color.size()}},
              "leave one of them out; --color off and --texture off do that for a file's");
}

/// One for the scene's numbers and those of most surfaces; surfaces with definitions of their own
/// have one each.
class Resolvers {
 public:
  explicit Resolvers(const Scene& scene) : shared_(scene), own_(scene.surfaces.size()) {
    for (std::size_t i = 0; i < own_.size(); ++i) {
      const SurfaceSpec& spec = scene.surfaces[i];
      if (!spec.definitions.empty()) own_[i] = std::make_unique<Resolver>(scene, &spec);
    }
  }

  Resolver& of_scene() { return shared_; }
  Resolver& of_surface(std::size_t index) { return own_[index] ? *own_[index] : shared_; }
  void set_time(double t) {
    shared_.set_time(t);
    for (const auto& resolver : own_) {
      if (resolver) resolver->set_time(t);
    }
  }
  bool have_used_time() const {
    return shared_.has_used_time() || std::ranges::any_of(own_, [](const auto& resolver) {
             return resolver && resolver->has_used_time();
           });
  }

 private:
  Resolver shared_;
  std::vector<std::unique_ptr<Resolver>> own_;
};

/// Everything but the moment itself.
void resolve_at(Resolvers& resolvers, Scene& scene) {
  resolvers.set_time(scene.t);
  Resolver& resolver = resolvers.of_scene();
  resolve_keys(resolver, Table::Scene, scene);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    SurfaceSpec& spec = scene.surfaces[i];
    resolve_keys(resolvers.of_surface(i), surface_prefix(i), spec);
    check_one_color(spec, surface_prefix(i));
    resolve_sliders(resolvers.of_surface(i), surface_prefix(i), spec.definitions, spec.sliders);
  }
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    resolve_keys(resolver, curve_prefix(i), scene.curves[i]);
  }
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    resolve_keys(resolver, point_prefix(i), scene.points[i]);
  }
  for (SceneNode& node : scene.nodes) resolve_node(resolver, node);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    resolve_light(resolver, light_prefix(i), scene.lights[i]);
  }
  resolve_keys(resolver, Table::Camera, scene);
  if (scene.camera.turntable && scene.animation) {
    const Animation& film = *scene.animation;
    scene.camera.turn = 2 * std::numbers::pi * (scene.t - film.from) / (film.to - film.from);
  }
  resolve_sliders(resolver, "", scene.definitions, scene.sliders);
}

/// Nodes by their names.
class NodeNames {
 public:
  explicit NodeNames(const std::vector<SceneNode>& nodes) {
    for (const SceneNode& node : nodes) {
      if (nodes_.emplace(node.name, &node).second) continue;
      throw Error(Status::Input, "a second node is called '" + node.name + "'",
                  {node_prefix(node) + "name", node.name, {0, node.name.size()}},
                  "give each its own name");
    }
    for (const SceneNode& node : nodes) check_chain(node);
  }

  /// Throws Error (Input) unless a node has the name; `also` are names that would do, too.
  void check(const std::string& place, const std::string& name,
             std::vector<std::string> also = {}) const {
    if (nodes_.contains(name)) return;
    for (const auto& [known, node] : nodes_) also.push_back(known);
    std::string hint = also.empty() ? "the scene has no [[node]]" : "known:";
    for (const std::string& known : also) hint += " " + known;
    if (const auto nearest = nearest_name(name, also)) hint += "; did you mean '" + *nearest + "'?";
    throw Error(Status::Input, "no node is called '" + name + "'", {place, name, {0, name.size()}},
                hint);
  }

 private:
  void check_chain(const SceneNode& start) const {
    std::string path = start.name;
    const Place place{node_prefix(start) + "in", start.in, {0, start.in.size()}};
    int depth = 0;
    for (const SceneNode* node = &start; !node->in.empty(); node = nodes_.at(node->in)) {
      check(node_prefix(*node) + "in", node->in);
      path += " -> " + node->in;
      if (node->in == start.name) {
        throw Error(Status::Input, "a node that is in itself: " + path, place, "break the circle");
      }
      if (++depth <= kMaxNodeDepth) continue;
      throw Error(Status::Input, "nodes in each other more than 256 deep", place);
    }
  }

  std::map<std::string, const SceneNode*> nodes_;
};

void check_nodes(const Scene& scene) {
  const NodeNames names(scene.nodes);
  const auto check_all = [&](const auto& things, const auto& prefix_of) {
    for (std::size_t i = 0; i < things.size(); ++i) {
      for (const std::string& name : things[i].in) names.check(prefix_of(i) + "in", name);
    }
  };
  check_all(scene.surfaces, surface_prefix);
  check_all(scene.curves, curve_prefix);
  check_all(scene.points, point_prefix);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const std::string& frame = scene.lights[i].frame;
    if (frame != "eye" && frame != "world") {
      names.check(light_prefix(i) + "frame", frame, {"eye", "world"});
    }
  }
}

}  // namespace

std::string surface_prefix(std::size_t index) {
  return "surface " + std::to_string(index + 1) + ": ";
}

std::string curve_prefix(std::size_t index) {
  return "curve " + std::to_string(index + 1) + ": ";
}

std::string point_prefix(std::size_t index) {
  return "point " + std::to_string(index + 1) + ": ";
}

std::string light_prefix(std::size_t index) {
  return "light " + std::to_string(index + 1) + ": ";
}

std::string node_prefix(const SceneNode& node) {
  return "node " + node.name + ": ";
}

struct Timeline::Parsed {
  Resolvers resolvers;

  explicit Parsed(const Scene& scene) : resolvers(scene) {}
};

Timeline::Timeline(Scene scene)
    : scene_(std::move(scene)), parsed_(std::make_unique<Parsed>(scene_)) {
  check_nodes(scene_);
  Resolver& resolver = parsed_->resolvers.of_scene();
  resolver.number("t", scene_.t, kAny);
  if (scene_.animation) resolve_keys(resolver, Table::Animation, scene_);
}

Timeline::~Timeline() = default;

Scene Timeline::at(double t) {
  Scene scene = scene_;
  scene.t = t;
  resolve_at(parsed_->resolvers, scene);
  return scene;
}

bool Timeline::moves() const {
  return parsed_->resolvers.have_used_time() || (scene_.camera.turntable && scene_.animation);
}

Scene resolve(Scene scene) {
  Timeline timeline(std::move(scene));
  Scene result = timeline.at(timeline.scene().t);
  result.t = timeline.scene().t;  // with its text
  return result;
}

}  // namespace saddle
