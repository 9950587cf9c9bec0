#include "view/panel/panel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "formula/syntax.h"
#include "scene/model/assignments.h"
#include "view/model/objects.h"
#include "view/panel/facts.h"
#include "view/panel/fields.h"
#include "view/panel/light_rows.h"
#include "view/panel/menus.h"
#include "view/panel/node_rows.h"
#include "view/panel/number_fields.h"
#include "view/panel/object_rows.h"
#include "view/panel/option_fields.h"
#include "view/panel/parameter_rows.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

/// The height of the strip that says what is wrong.
constexpr float kErrorLines = 8;

bool is_on(const Model& model, Action action) {
  switch (action) {
    case Action::Grid:
      return model.view().grid;
    case Action::Wireframe:
      return model.view().wireframe;
    case Action::Normals:
      return model.view().normals;
    case Action::Turntable:
      return model.view().turntable;
    case Action::Axes:
      return model.scene().axes;
    case Action::Orthographic:
      return model.scene().camera.ortho;
    case Action::Play:
      return model.view().playing;
    case Action::Panel:
      return model.view().panel;
    case Action::ShadeVertices:
      return model.scene().picture.shading == Shading::Vertex;
    case Action::ShadePixels:
      return model.scene().picture.shading == Shading::Pixel;
    case Action::ShadeExactly:
      return model.scene().picture.shading == Shading::Exact;
    default:
      return false;
  }
}

bool header(const char* title, bool open = false) {
  return ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void add_buttons(Desk& desk) {
  struct Button {
    const char* text;
    Action action;
  };
  constexpr std::array kButtons{Button{"+ surface", Action::AddSurface},
                                Button{"+ curve", Action::AddCurve},
                                Button{"+ point", Action::AddPoint}};
  for (const auto& [text, action] : kButtons) {
    if (action != kButtons.front().action) ImGui::SameLine();
    if (ImGui::SmallButton(text)) desk.action = action;
    show_tip(row_of(action).help);
  }
}

/// The object that has the scene's error, where there are several.
std::string owner_of_error(const Model& model) {
  const Scene& scene = model.scene();
  const bool is_alone = scene.surfaces.size() + scene.curves.size() + scene.points.size() == 1;
  return model.faulty() && !is_alone ? model.faulty()->name : "";
}

}  // namespace

/// Tells the mistake, and the definition that would mend it.
void Panel::show_errors(Desk& desk) const {
  const std::optional<Error>& error = desk.refused ? desk.refused : desk.model.error();
  if (!error) return;
  const float height = errors_height(desk);
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - height);
  ImGui::Separator();
  ImGui::BeginChild("##errors", {0, 0});
  const auto name = undefined_name(*error);
  if (name && ImGui::SmallButton(("make a slider for " + *name).c_str())) {
    desk.edit("", [&](Scene& scene) { add_parameter(scene, *name); });
  }
  show_error(*error, desk.refused ? "" : owner_of_error(desk.model));
  ImGui::EndChild();
}

/// Fields never move because of a mistake: there is always as much room for it.
float Panel::errors_height(const Desk& desk) const {
  const bool any = desk.refused || desk.model.error() || was_refused_;
  return any ? kErrorLines * ImGui::GetTextLineHeightWithSpacing() : 0;
}

void Panel::show_new_definition(Desk& desk) {
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##new", "new: name = formula", &new_definition_)) refused_.reset();
  if (is_confirmed_ && ImGui::IsItemActive()) {
    Scene scene = desk.scene();
    refused_.reset();
    try {
      const std::size_t end = new_definition_.size();
      if (new_definition_.find('=') == std::string::npos) {
        throw Error(Status::Input, "the = is missing", {"", new_definition_, {end, end}},
                    "for example k = 2, or f(s) = s^2");
      }
      assign(scene, new_definition_);
      desk.model.edit(std::move(scene), "");
      new_definition_.clear();
      clear_text();
    } catch (const Error& error) {
      refused_ = error;
    }
  }
  if (refused_ && !desk.refused) desk.refused = refused_;
}

/// The moment, if anything depends on it; where it begins and ends.
void Panel::show_time(Desk& desk) const {
  Model& model = desk.model;
  if (!model.moves() && !desk.scene().animation) return;
  const Animation animation = desk.scene().animation.value_or(Animation{});
  const double low = animation.from;
  const double high = animation.to;
  ImGui::PushID("time");
  show_name("t");
  if (icon_button(model.view().playing ? Icon::Stop : Icon::Play, row_of(Action::Play).help)) {
    desk.action = Action::Play;
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  double t = desk.scene().t;
  if (ImGui::SliderScalar("##t", ImGuiDataType_Double, &t, &low, &high, "%.3f")) model.set_time(t);
  constexpr double kSlowest = 0.01;
  constexpr double kFastest = 100;
  ViewState view = model.view();
  show_name("speed");
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderScalar("##speed", ImGuiDataType_Double, &view.speed, &kSlowest, &kFastest,
                          "%.2f", ImGuiSliderFlags_Logarithmic)) {
    model.change_view(view, "speed");
  }
  if (desk.scene().animation) {
    const auto end = [](Number Animation::*number) {
      return [number](Scene& scene) -> Number& { return scene.animation.value().*number; };
    };
    number_field(desk, "from", "animation: t: from", end(&Animation::from));
    number_field(desk, "to", "animation: t: to", end(&Animation::to));
  }
  ImGui::PopID();
}

/// The facts of the picked point; scrolled to once, where the list is longer than the window.
void Panel::show_point(const Model& model) {
  if (!model.picked()) return;
  ImGui::BeginGroup();
  show_picked(model);
  ImGui::EndGroup();
  if (std::exchange(reveals_picked_, false)) {
    ImGui::ScrollToItem(ImGuiScrollFlags_KeepVisibleEdgeY);
  }
}

void Panel::show_list(Desk& desk, const Figures& figures) {
  if (std::exchange(enters_, false)) enter_next_field();
  show_surfaces(desk);
  show_curves(desk);
  show_points(desk);
  add_buttons(desk);
  ImGui::Separator();
  show_parameters(desk);
  show_new_definition(desk);
  show_time(desk);
  show_point(desk.model);
  if (header("Lights")) {
    show_lights(desk);
    if (ImGui::SmallButton("+ light")) desk.action = Action::AddLight;
  }
  if (header("Nodes")) show_nodes(desk);
  if (header("Camera")) camera_fields(desk);
  if (header("Scene")) scene_fields(desk);
  if (!quiet_) show_warnings(desk.model, figures);
  if (header("Mesh", true)) show_figures(desk.model, figures);
}

void Panel::confirm(Model& model) {
  confirm_text();
  model.end_edit();
  is_confirmed_ = true;
}

void Panel::show(Model& model, const Figures& figures, double width) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(width), ImGui::GetIO().DisplaySize.y});
  constexpr ImGuiWindowFlags kFixed =
      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_MenuBar |
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const std::size_t version = model.history().version();
  const double t = model.scene().t;
  Desk desk{model, is_confirmed_, std::nullopt, std::nullopt, can_};
  ImGui::Begin("panel", nullptr, kFixed);
  action_ = show_menus(can_, [&](Action action) { return is_on(model, action); });
  const float height = ImGui::GetContentRegionAvail().y - errors_height(desk);
  ImGui::BeginChild("##list", {0, std::max(1.0F, height)}, false,
                    ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_AlwaysVerticalScrollbar);
  show_list(desk, figures);
  ImGui::EndChild();
  show_errors(desk);
  ImGui::End();
  was_refused_ = desk.refused.has_value();
  if (desk.action) action_ = desk.action;
  // A click into the picture takes the keyboard from a field before the field is shown again.
  const unsigned active = ImGui::GetCurrentContext()->ActiveId;
  const bool is_edited = ImGui::GetCurrentContext()->ActiveIdHasBeenEditedThisFrame;
  // A press on a slider changes it already: the drag goes on with that change.
  const bool begins_with_edit = active != 0 && is_edited;
  if (active != active_ && !begins_with_edit) model.end_edit();
  active_ = active;
  // A field whose text is no value, or not as that is written, tells of an edit in each frame.
  changed_ |= is_edited && (model.history().version() != version || model.scene().t != t);
}

}  // namespace saddle
