#include "view/panel/object_rows.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "scene/model/prepare.h"
#include "scene/model/values.h"
#include "view/model/objects.h"
#include "view/panel/node_rows.h"
#include "view/panel/number_fields.h"
#include "view/panel/option_fields.h"
#include "view/panel/parameter_rows.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

/// Where the objects of a kind are, and their colour.
struct Surfaces {
  static auto& in(auto& scene) { return scene.surfaces; }
  static auto& color(auto& spec) { return spec.front.diffuse; }
};
struct Curves {
  static auto& in(auto& scene) { return scene.curves; }
  static auto& color(auto& curve) { return curve.color; }
};
struct Points {
  static auto& in(auto& scene) { return scene.points; }
  static auto& color(auto& point) { return point.color; }
};

/// Buttons at the right end of a row, the last so many of these: above the one before, once more,
/// gone. True if the object is still there.
template <typename Kind>
bool show_row_buttons(Desk& desk, std::size_t i, const std::string& name, int count) {
  if (count > 2) {
    if (icon_button(Icon::Up, "one place up")) {
      desk.edit("", [&](Scene& scene) { std::swap(Kind::in(scene)[i - 1], Kind::in(scene)[i]); });
      return false;
    }
    ImGui::SameLine();
  }
  if (count > 1) {
    if (icon_button(Icon::Copy, "a copy of it")) {
      desk.edit("", [&](Scene& scene) {
        auto copy = Kind::in(scene)[i];
        copy.name = free_name(scene, name);
        Kind::in(scene).push_back(std::move(copy));
      });
      return false;
    }
    ImGui::SameLine();
  }
  if (count > 0 && icon_button(Icon::Delete, "delete it (Ctrl-Z brings it back)")) {
    desk.edit("", [&](Scene& scene) {
      Kind::in(scene).erase(Kind::in(scene).begin() + static_cast<std::ptrdiff_t>(i));
    });
    return false;
  }
  return true;
}

/// Colour, eye, name, buttons; true if the row is unfolded and its object still there.
template <typename Kind>
bool show_row(Desk& desk, std::size_t i) {
  const auto& object = Kind::in(desk.scene())[i];
  const std::string name = object.name;
  if (const auto color = color_chip("##color", Kind::color(object))) {
    desk.edit("color of " + name, [&](Scene& scene) { Kind::color(Kind::in(scene)[i]) = *color; });
  }
  ImGui::SameLine();
  if (icon_button(object.visible ? Icon::Eye : Icon::ClosedEye, "show or hide it")) {
    desk.edit("", [&](Scene& scene) { Kind::in(scene)[i].visible = !Kind::in(scene)[i].visible; });
  }
  ImGui::SameLine();
  constexpr std::size_t kFewObjects = 2;
  const FoldRow row = fold_row(name, i > 0 ? 3 : 2, Kind::in(desk.scene()).size() <= kFewObjects);
  return show_row_buttons<Kind>(desk, i, name, row.icons) && row.is_open;
}

/// All rows of a kind, each with what `show` shows below it.
template <typename Kind, typename Show>
void show_rows(Desk& desk, const char* kind, const Show& show) {
  for (std::size_t i = 0; i < Kind::in(desk.scene()).size(); ++i) {
    ImGui::PushID(kind);
    ImGui::PushID(static_cast<int>(i));
    if (show_row<Kind>(desk, i)) show(i);
    ImGui::PopID();
    ImGui::PopID();
  }
}

/// Unfolds the keys that are seldom needed.
bool more() {
  return ImGui::TreeNodeEx("more", ImGuiTreeNodeFlags_NoTreePushOnOpen);
}

/// `u -1 to 1`
void range_field(Desk& desk, const std::string& name, const std::string& what, bool wrong,
                 const Range& range, const std::function<Range&(Scene&)>& range_in) {
  ImGui::PushID(name.c_str());
  show_name(name);
  const float half = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetFontSize()) / 2;
  const float padding = 2 * ImGui::GetStyle().FramePadding.x;
  const auto min =
      bare_field("##min", range.min, 2 * (half - padding) / ImGui::GetFontSize(), wrong);
  ImGui::SameLine();
  ImGui::TextUnformatted("to");
  ImGui::SameLine();
  const auto max = bare_field("##max", range.max, 0, wrong);
  ImGui::PopID();
  if (!min && !max) return;
  desk.edit(what, [&](Scene& scene) {
    range_in(scene) = {min.value_or(range.min), max.value_or(range.max)};
  });
}

void show_surface(Desk& desk, std::size_t i) {
  const SurfaceSpec spec = desk.scene().surfaces[i];
  const auto formula = [&](const std::string& name, std::string SurfaceSpec::*text) {
    if (is_parameter(spec, name)) return;
    const auto changed = text_field(name, spec.*text, desk.is_wrong(name, i));
    if (!changed) return;
    desk.edit(spec.name + name, [&](Scene& scene) { scene.surfaces[i].*text = *changed; });
  };
  if (!spec.xyz.empty()) {
    formula("xyz", &SurfaceSpec::xyz);
  } else {
    formula("x", &SurfaceSpec::x);
    formula("y", &SurfaceSpec::y);
    formula("z", &SurfaceSpec::z);
  }
  const auto range = [&](const std::string& name, Range SurfaceSpec::*ends) {
    range_field(desk, name, spec.name + name, desk.is_wrong(name, i), spec.*ends,
                [i, ends](Scene& scene) -> Range& { return scene.surfaces[i].*ends; });
  };
  range(spec.parameters[0], &SurfaceSpec::u);
  range(spec.parameters[1], &SurfaceSpec::v);
  show_parameters(desk, i);
  if (!more()) return;
  nodes_field(
      desk, spec.name + "in", [i](Scene & scene) -> auto& { return scene.surfaces[i].in; });
  surface_fields(desk, i);
}

constexpr const char* kInSpace = "in space";

/// The choice between space and the surfaces; the name of what was chosen.
std::optional<std::string> place_field(const Desk& desk, const StrokeSpec& stroke) {
  std::vector<std::string> places{kInSpace};
  for (const SurfaceSpec& spec : desk.scene().surfaces) places.push_back(spec.name);
  std::string now = kInSpace;
  if (is_on_surface(stroke)) now = stroke.on.empty() && places.size() > 1 ? places[1] : stroke.on;
  const auto chosen = word_field("on", now, places);
  return chosen && *chosen != now ? chosen : std::nullopt;
}

std::string surface_of(const std::string& place) {
  return place == kInSpace ? "" : place;
}

void show_curve(Desk& desk, std::size_t i) {
  const CurveSpec curve = desk.scene().curves[i];
  const std::size_t place = desk.scene().surfaces.size() + i;
  const auto formula = [&](const char* name, auto text) {
    const auto changed = text_field(name, curve.*text, desk.is_wrong(name, place));
    if (!changed) return;
    desk.edit(curve.name + name, [&](Scene& scene) { scene.curves[i].*text = *changed; });
  };
  if (const auto on = place_field(desk, curve)) {
    return desk.edit("", [&](Scene& scene) { put_on(scene, scene.curves[i], surface_of(*on)); });
  }
  if (is_on_surface(curve)) {
    formula("u", &CurveSpec::u);
    formula("v", &CurveSpec::v);
  } else if (!curve.xyz.empty()) {
    formula("xyz", &CurveSpec::xyz);
  } else {
    formula("x", &CurveSpec::x);
    formula("y", &CurveSpec::y);
    formula("z", &CurveSpec::z);
  }
  range_field(desk, "s", curve.name + "s", desk.is_wrong("s", place), curve.s,
              [i](Scene& scene) -> Range& { return scene.curves[i].s; });
  if (!more()) return;
  nodes_field(
      desk, curve.name + "in", [i](Scene & scene) -> auto& { return scene.curves[i].in; });
  curve_fields(desk, i);
}

void show_point(Desk& desk, std::size_t i) {
  const PointSpec point = desk.scene().points[i];
  const std::size_t place = desk.scene().surfaces.size() + desk.scene().curves.size() + i;
  const auto on_surface = [&](const char* name, std::string PointSpec::*text) {
    const auto changed = text_field(name, point.*text, desk.is_wrong(name, place));
    if (!changed) return;
    desk.edit(point.name + name, [&](Scene& scene) { scene.points[i].*text = *changed; });
  };
  if (const auto on = place_field(desk, point)) {
    return desk.edit("", [&](Scene& scene) { put_on(scene, scene.points[i], surface_of(*on)); });
  }
  if (is_on_surface(point)) {
    on_surface("u", &PointSpec::u);
    on_surface("v", &PointSpec::v);
  }
  if (point.at) {
    const auto at = [i](Scene& scene) -> Vector& { return *scene.points[i].at; };
    vector_field(desk, "at", point.name + "at", at);
  }
  if (!more()) return;
  nodes_field(
      desk, point.name + "in", [i](Scene & scene) -> auto& { return scene.points[i].in; });
  point_fields(desk, i);
}

}  // namespace

void show_surfaces(Desk& desk) {
  show_rows<Surfaces>(desk, "surface", [&](std::size_t i) { show_surface(desk, i); });
}

void show_curves(Desk& desk) {
  show_rows<Curves>(desk, "curve", [&](std::size_t i) { show_curve(desk, i); });
}

void show_points(Desk& desk) {
  show_rows<Points>(desk, "point", [&](std::size_t i) { show_point(desk, i); });
}

}  // namespace saddle
