#include "view/panel/number_fields.h"

#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include <imgui.h>

#include "scene/model/values.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

Number number_of(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_plain = error == std::errc() && end == text.data() + text.size();
  return is_plain ? Number(value) : Number(text);
}

/// False: it is the same number. While "1.0" is in a field, that tells of a change in each frame.
bool take(const std::string& text, Number& number) {
  if (text.empty()) return false;
  Number other = number_of(text);
  if (expression_of(other) == expression_of(number)) return false;
  number = std::move(other);
  return true;
}

}  // namespace

void number_field(Desk& desk, const std::string& label, const std::string& what,
                  const std::function<Number&(Scene&)>& number_in) {
  Scene scene = desk.scene();
  const auto text = text_field(label, expression_of(number_in(scene)), desk.is_wrong(what));
  if (text && take(*text, number_in(scene))) desk.model.edit(std::move(scene), what);
}

void vector_field(Desk& desk, const std::string& label, const std::string& what,
                  const std::function<Vector&(Scene&)>& vector_in) {
  Scene scene = desk.scene();
  Vector& vector = vector_in(scene);
  ImGui::PushID(label.c_str());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label.c_str());
  const float space = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SameLine();
  const float third = (ImGui::GetContentRegionAvail().x - 2 * space) / 3;
  const float letters = 2 * (third - 2 * ImGui::GetStyle().FramePadding.x) / ImGui::GetFontSize();
  bool changed = false;
  for (Number* const number : {&vector.x, &vector.y, &vector.z}) {
    ImGui::PushID(number == &vector.x ? 0 : number == &vector.y ? 1 : 2);
    if (number != &vector.x) ImGui::SameLine();
    const auto text = bare_field("##number", expression_of(*number), letters, desk.is_wrong(what));
    changed |= text && take(*text, *number);
    ImGui::PopID();
  }
  ImGui::PopID();
  if (changed) desk.model.edit(std::move(scene), what);
}

}  // namespace saddle
