#include "view/panel/node_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <imgui.h>

#include "scene/options/resolve.h"
#include "view/model/objects.h"
#include "view/panel/number_fields.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

constexpr const char* kWorld = "world";

constexpr std::array kKinds{"translate", "rotate", "scale"};

/// A step of a node, by their places in their lists.
struct StepPlace {
  std::size_t node;
  std::size_t step;

  Transform& in(Scene& scene) const { return scene.nodes[node].transform[step]; }
};

/// A step that moves nothing, of this kind.
Transform still_step(Transform::Kind kind) {
  Transform step;
  step.kind = kind;
  if (kind == Transform::Kind::Rotate) step.vector = {0, 0, 1};
  if (kind == Transform::Kind::Scale) step.vector = {1, 1, 1};
  return step;
}

/// True if the step is still there.
bool show_step(Desk& desk, const StepPlace& place) {
  const SceneNode node = desk.scene().nodes[place.node];
  const Transform& step = node.transform[place.step];
  const std::string what = node_prefix(node) + kKinds[static_cast<std::size_t>(step.kind)];
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(kKinds[static_cast<std::size_t>(step.kind)]);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - icons_width(1));
  if (icon_button(Icon::Delete, "delete this step (Ctrl-Z brings it back)")) {
    desk.edit("", [&](Scene& scene) {
      auto& steps = scene.nodes[place.node].transform;
      steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(place.step));
    });
    return false;
  }
  const bool is_rotation = step.kind == Transform::Kind::Rotate;
  if (is_rotation) {
    number_field(desk, "degrees", what,
                 [&](Scene& scene) -> Number& { return place.in(scene).angle; });
  }
  vector_field(desk, is_rotation ? "around" : "by", what,
               [&](Scene& scene) -> Vector& { return place.in(scene).vector; });
  return true;
}

void add_step_buttons(const Desk& desk, std::size_t index) {
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    if (kind > 0) ImGui::SameLine();
    if (!ImGui::SmallButton((std::string("+ ") + kKinds[kind]).c_str())) continue;
    desk.edit("", [&](Scene& scene) {
      scene.nodes[index].transform.push_back(still_step(static_cast<Transform::Kind>(kind)));
    });
  }
}

/// The nodes that this one can be in: not those that are in it.
std::vector<std::string> places_of(const Scene& scene, const SceneNode& node) {
  std::vector<std::string> places{kWorld};
  const auto is_inside = [&](const SceneNode* other) {
    for (std::size_t depth = 0; depth <= scene.nodes.size(); ++depth) {
      if (other->name == node.name) return true;
      const auto around = std::ranges::find(scene.nodes, other->in, &SceneNode::name);
      if (around == scene.nodes.end()) return false;
      other = &*around;
    }
    return true;
  };
  for (const SceneNode& other : scene.nodes) {
    if (!is_inside(&other)) places.push_back(other.name);
  }
  return places;
}

void show_node(Desk& desk, std::size_t index) {
  const SceneNode node = desk.scene().nodes[index];
  const std::string what = node_prefix(node);
  const auto name = text_field("name", node.name, desk.is_wrong(what + "name"));
  if (name && !name->empty()) {
    return desk.edit("name of a node", [&](Scene& scene) { rename_node(scene, index, *name); });
  }
  const auto place =
      word_field("in", node.in.empty() ? kWorld : node.in, places_of(desk.scene(), node));
  if (place) {
    return desk.edit("",
                     [&](Scene& scene) { scene.nodes[index].in = *place == kWorld ? "" : *place; });
  }
  for (std::size_t step = 0; step < node.transform.size(); ++step) {
    ImGui::PushID(static_cast<int>(step));
    const bool is_there = show_step(desk, {index, step});
    ImGui::PopID();
    if (!is_there) return;
  }
  add_step_buttons(desk, index);
}

/// Its name and a button; true if it is unfolded and still there.
bool show_node_row(const Desk& desk, std::size_t index) {
  const auto [is_open, icons] = fold_row(desk.scene().nodes[index].name, 1);
  constexpr const char* kTip = "delete it: what is in it goes to the node around it";
  if (icons > 0 && icon_button(Icon::Delete, kTip)) {
    desk.edit("", [&](Scene& scene) { delete_node(scene, index); });
    return false;
  }
  return is_open;
}

}  // namespace

void show_nodes(Desk& desk) {
  for (std::size_t i = 0; i < desk.scene().nodes.size(); ++i) {
    ImGui::PushID("node");
    ImGui::PushID(static_cast<int>(i));
    if (show_node_row(desk, i)) show_node(desk, i);
    ImGui::PopID();
    ImGui::PopID();
  }
  if (ImGui::SmallButton("+ node")) desk.edit("", [](Scene& scene) { add_node(scene); });
  show_tip("a frame that moves what is in it: objects choose it below more");
}

void nodes_field(Desk& desk, const std::string& what,
                 const std::function<std::vector<std::string>&(Scene&)>& nodes_in) {
  if (desk.scene().nodes.empty()) return;
  Scene scene = desk.scene();
  std::vector<std::string>& chosen = nodes_in(scene);
  std::string all;
  for (const std::string& each : chosen) all += (all.empty() ? "" : ", ") + each;
  bool changed = false;
  ImGui::PushID("in");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("in");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##nodes", all.empty() ? kWorld : all.c_str())) {
    for (const SceneNode& node : desk.scene().nodes) {
      const auto place = std::ranges::find(chosen, node.name);
      const bool is_in = place != chosen.end();
      if (!ImGui::Selectable(node.name.c_str(), is_in, ImGuiSelectableFlags_DontClosePopups)) {
        continue;
      }
      if (is_in) {
        chosen.erase(place);
      } else {
        chosen.push_back(node.name);
      }
      changed = true;
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  if (changed) desk.model.edit(std::move(scene), what);
}

}  // namespace saddle
