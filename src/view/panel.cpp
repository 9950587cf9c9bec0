#include "view/panel.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "base/format.h"
#include "mesh/model/mesh_report.h"
#include "scene/model/assignments.h"
#include "scene/model/colormap.h"
#include "scene/model/gallery.h"
#include "scene/model/values.h"
#include "view/fields.h"
#include "view/widgets.h"

namespace saddle {
namespace {

/// A plain number and nothing else.
std::optional<double> plain_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Whether the error is that of the thing with this name: "x", "u", or "f" of "f(s)".
bool is_about(const std::optional<Error>& error, const std::string& name) {
  return error && error->place().name == name;
}

/// Whatever the case of the letters.
bool contains(std::string_view text, std::string_view word) {
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  return word.empty() ||
         std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

}  // namespace

/// Below the field of this name, if the error is about it.
void Panel::show_error_of(const Model& model, const std::string& name) {
  if (!is_about(model.error(), name)) return;
  show_error(*model.error());
  has_shown_error_ = true;
}

void Panel::show_surface(Model& model, std::size_t index) {
  Scene scene = model.scene();
  SurfaceSpec& spec = scene.surfaces[index];
  ImGui::PushID(static_cast<int>(index));
  if (scene.surfaces.size() > 1) ImGui::TextUnformatted(spec.name.c_str());
  const bool is_faulty = index == model.faulty_surface();
  const auto formula = [&](const char* name, std::string& text) {
    const bool wrong = is_faulty && is_about(model.error(), name);
    if (text_field(name, text, wrong)) model.edit(scene, spec.name + name);
    if (is_faulty) show_error_of(model, name);
  };
  const bool is_whole = !spec.xyz.empty();
  if (is_whole) formula("xyz", spec.xyz);
  if (!is_whole && !is_parameter(spec, "x")) formula("x", spec.x);
  if (!is_whole && !is_parameter(spec, "y")) formula("y", spec.y);
  if (!is_whole && !is_parameter(spec, "z")) formula("z", spec.z);
  const auto range = [&](const std::string& name, Range& ends) {
    const float half = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetFontSize()) / 2;
    ImGui::PushID(name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(half);
    bool changed = ImGui::InputText("##min", &ends.min);
    ImGui::SameLine();
    ImGui::TextUnformatted("to");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    changed |= ImGui::InputText("##max", &ends.max);
    ImGui::PopID();
    if (changed) model.edit(scene, spec.name + name);
    if (is_faulty) show_error_of(model, name);
  };
  range(spec.parameters[0], spec.u);
  range(spec.parameters[1], spec.v);
  formula("color", spec.color);
  if (!spec.color.empty()) show_colormaps(model, scene, spec);
  for (std::size_t i = 0; i < spec.definitions.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    show_parameter(model, scene, {spec.definitions[i], spec.sliders, spec.name, is_faulty});
    ImGui::PopID();
  }
  ImGui::PopID();
}

void Panel::show_colormaps(Model& model, const Scene& scene, SurfaceSpec& spec) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##colormap", spec.colormap.c_str())) return;
  for (const std::string& name : colormap_names()) {
    if (!ImGui::Selectable(name.c_str(), name == spec.colormap)) continue;
    spec.colormap = name;
    model.change_look(scene);
  }
  ImGui::EndCombo();
}

/// A definition: a slider if it is a number, its formula otherwise.
void Panel::show_parameter(Model& model, const Scene& scene, const Parameter& parameter) {
  Definition& definition = parameter.definition;
  const std::string name = display_name(definition);
  const auto number = definition.is_function ? std::nullopt : plain_number(definition.text);
  const bool wrong = parameter.may_be_wrong &&
                     (is_about(model.error(), name) || is_about(model.error(), definition.name));
  if (text_field(name, definition.text, wrong)) model.edit(scene, parameter.owner + name);
  if (number) show_slider(model, scene, parameter, *number);
  if (!parameter.may_be_wrong) return;
  show_error_of(model, name);
  if (name != definition.name) show_error_of(model, definition.name);
}

void Panel::show_slider(Model& model, const Scene& scene, const Parameter& parameter,
                        double number) {
  Definition& definition = parameter.definition;
  const auto slider = std::ranges::find(parameter.sliders, definition.name, &Slider::name);
  const bool has_ends = slider != parameter.sliders.end();
  // Without ends of its own, to twice the value on both sides of 0.
  const double reach = std::max(1.0, 2 * std::abs(number));
  const double low = has_ends ? double(slider->min) : -reach;
  const double high = has_ends ? double(slider->max) : reach;
  double value = number;
  ImGui::SetNextItemWidth(-1);
  if (has_ends) {
    if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &low, &high, "")) {
      definition.text = format_number(value);
      model.edit(scene, parameter.owner + display_name(definition));
    }
  } else if (ImGui::DragScalar("##slider", ImGuiDataType_Double, &value,
                               static_cast<float>(reach / 500), nullptr, nullptr, "drag")) {
    definition.text = format_number(std::round(value * 1e6) / 1e6);
    model.edit(scene, parameter.owner + display_name(definition));
  }
}

void Panel::show_definitions(Model& model) {
  for (std::size_t i = 0; i < model.scene().definitions.size(); ++i) {
    Scene scene = model.scene();
    ImGui::PushID(static_cast<int>(i));
    show_parameter(model, scene, {scene.definitions[i], scene.sliders, "", true});
    ImGui::PopID();
  }
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##new", "new: name = formula", &new_definition_);
  if (is_confirmed_ && ImGui::IsItemActive()) {
    Scene scene = model.scene();
    refused_.clear();
    try {
      assign(scene, new_definition_);
      model.edit(std::move(scene), "");
      new_definition_.clear();
      clear_text();
    } catch (const Error& error) {
      refused_ = error.what();
    }
  }
  if (!refused_.empty()) show_wrapped(Tone::Wrong, refused_);
}

void Panel::show_buttons() {
  struct Button {
    const char* text;
    Action action;
  };
  constexpr std::array kButtons{Button{"undo", Action::Undo}, Button{"redo", Action::Redo},
                                Button{"PNG", Action::SavePicture},
                                Button{"copy", Action::CopyCommand},
                                Button{"as scene", Action::CopyScene}};
  for (const auto& [text, action] : kButtons) {
    if (action != kButtons.front().action) ImGui::SameLine();
    if (ImGui::SmallButton(text)) action_ = action;
    show_tip(action);
  }
}

void Panel::show_gallery(Model& model) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##gallery", "gallery ...", ImGuiComboFlags_HeightLarge)) return;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##search", "search", &search_);
  bool take_first = is_confirmed_ && ImGui::IsItemActive();
  for (const GalleryEntry& entry : gallery()) {
    if (!contains(entry.name, search_) && !contains(entry.description, search_)) continue;
    if (ImGui::Selectable(std::string(entry.name).c_str()) || take_first) {
      model.open(gallery_scene(entry));
      ImGui::CloseCurrentPopup();
      changed_ = true;
      take_first = false;
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", std::string(entry.description).c_str());
    }
  }
  ImGui::EndCombo();
}

void Panel::show_time(Model& model) {
  const Animation animation = model.scene().animation.value_or(Animation{});
  const double low = animation.from;
  const double high = animation.to;
  double t = model.scene().t;
  if (ImGui::Button(model.playing ? "stop" : "play")) model.act(Action::Play);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderScalar("##t", ImGuiDataType_Double, &t, &low, &high, "t = %.3f")) {
    model.set_time(t);
  }
  constexpr double kSlowest = 0.01;
  constexpr double kFastest = 100;
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderScalar("##speed", ImGuiDataType_Double, &model.speed, &kSlowest, &kFastest,
                      "speed %.2f", ImGuiSliderFlags_Logarithmic);
}

void Panel::show_look(Model& model) {
  ImGui::Checkbox("grid", &model.grid);
  ImGui::SameLine();
  ImGui::Checkbox("wires", &model.wireframe);
  ImGui::SameLine();
  bool axes = model.scene().axes;
  if (ImGui::Checkbox("axes", &axes)) model.act(Action::Axes);
  bool ortho = model.scene().camera.ortho;
  if (ImGui::Checkbox("ortho", &ortho)) model.act(Action::Orthographic);
  ImGui::SameLine();
  ImGui::Checkbox("turntable", &model.turntable);
  show_shading(model);
  show_lights(model);
  show_tolerance(model);
}

void Panel::show_shading(const Model& model) {
  struct Choice {
    Shading shading;
    const char* text;
    Action action;
  };
  constexpr std::array kChoices{Choice{Shading::Vertex, "vertex", Action::ShadeVertices},
                                Choice{Shading::Pixel, "pixel", Action::ShadePixels},
                                Choice{Shading::Exact, "exact", Action::ShadeExactly}};
  for (const auto& [shading, text, action] : kChoices) {
    if (action != kChoices.front().action) ImGui::SameLine();
    if (ImGui::RadioButton(text, model.scene().picture.shading == shading)) action_ = action;
    show_tip(action);
  }
}

void Panel::show_lights(Model& model) {
  for (std::size_t i = 0; i < model.scene().lights.size(); ++i) {
    if (i % 3 != 0) ImGui::SameLine();
    bool on = double(model.scene().lights[i].enabled) != 0;
    if (ImGui::Checkbox(formatted("light %d", static_cast<int>(i + 1)).c_str(), &on)) {
      Scene scene = model.scene();
      scene.lights[i].enabled = on ? 1 : 0;
      model.change_look(std::move(scene));
    }
  }
}

/// In pixels, or the share of the size that the scene says.
void Panel::show_tolerance(Model& model) {
  ToleranceValue tolerance = model.tolerance();
  const double low = tolerance.pixels ? 0.05 : 1e-6;
  const double high = tolerance.pixels ? 20 : 0.1;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderScalar("##tolerance", ImGuiDataType_Double, &tolerance.value, &low, &high,
                          tolerance.pixels ? "tolerance %.2f px" : "tolerance %.1e",
                          ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat)) {
    Scene scene = model.scene();
    scene.mesh.tolerance = tolerance;
    model.edit(std::move(scene), "tolerance");
  }
}

void Panel::show_picked(const Model& model) {
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

void Panel::show_warnings(const std::vector<std::string>& warnings) const {
  if (quiet_) return;
  for (const std::string& warning : warnings) show_wrapped(Tone::Quiet, warning);
}

void Panel::show_figures(const Model& model, const Figures& figures) {
  ImGui::Separator();
  for (const auto& surface : model.meshes()) {
    const MeshReport& report = surface->report;
    show_wrapped(Tone::Quiet, formatted("%zu triangles, %zu evaluations",
                                        surface->mesh.triangles.size(), report.evaluations));
    if (report.tolerance) {
      show_wrapped(Tone::Quiet,
                   formatted("off by %.2g of %.2g", report.max_error, *report.tolerance));
    }
    show_warnings(surface->warnings);
  }
  show_warnings(figures.warnings);
  show_wrapped(Tone::Quiet,
               formatted("%.1f ms a frame, mesh %.1f ms%s", figures.frame_ms,
                         model.last_good().milliseconds, model.is_meshing() ? " ..." : ""));
}

void Panel::confirm(Model& model) {
  confirm_text();
  model.end_edit();
  is_confirmed_ = true;
}

void Panel::show(Model& model, const Figures& figures, double width, double scale) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(width), ImGui::GetIO().DisplaySize.y});
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                                      ImGuiWindowFlags_NoNav;
  ImGui::Begin("panel", nullptr, kFixed);
  ImGui::PushItemWidth(static_cast<float>(100 * scale));
  has_shown_error_ = false;
  show_gallery(model);
  show_buttons();
  for (std::size_t i = 0; i < model.scene().surfaces.size(); ++i) show_surface(model, i);
  show_definitions(model);
  ImGui::Separator();
  show_time(model);
  ImGui::Separator();
  show_look(model);
  show_picked(model);
  show_figures(model, figures);
  ImGui::PopItemWidth();
  ImGui::End();
  // A click into the picture takes the keyboard from a field before the field is shown again.
  const unsigned active = ImGui::GetCurrentContext()->ActiveId;
  if (active != active_) model.end_edit();
  active_ = active;
  changed_ |= ImGui::GetCurrentContext()->ActiveIdHasBeenEditedThisFrame;
  is_confirmed_ = false;
}

}  // namespace saddle
