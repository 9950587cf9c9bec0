#include "view/panel/widgets.h"

#include <algorithm>
#include <cstddef>

#include <imgui.h>
#include <imgui_stdlib.h>

namespace saddle {
namespace {

const ImVec4 kWrong{1.0F, 0.45F, 0.4F, 1};
const ImVec4 kQuiet{0.65F, 0.65F, 0.7F, 1};

/// Characters on each side of a wrong place that are shown of a long line.
constexpr std::size_t kAround = 12;

ImVec4 color_of(Tone tone) {
  if (tone == Tone::Plain) return ImGui::GetStyleColorVec4(ImGuiCol_Text);
  return tone == Tone::Quiet ? kQuiet : kWrong;
}

/// The part of the text that is wrong, underlined, with a little around it.
void show_place(const Place& place) {
  const std::string& text = place.text;
  if (text.empty()) return;
  const std::size_t begin = std::min(place.span.begin, text.size());
  const std::size_t end = std::clamp(place.span.end, begin, text.size());
  const std::string before =
      text.substr(begin - std::min(begin, kAround), std::min(begin, kAround));
  const std::string wrong = begin < end ? text.substr(begin, end - begin) : " ";
  ImGui::TextUnformatted(before.c_str());
  ImGui::SameLine(0, 0);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Text, kWrong);
  ImGui::TextUnformatted(wrong.c_str());
  ImGui::PopStyleColor();
  const ImVec2 size = ImGui::CalcTextSize(wrong.c_str());
  ImGui::GetWindowDrawList()->AddLine({corner.x, corner.y + size.y},
                                      {corner.x + size.x, corner.y + size.y},
                                      ImGui::GetColorU32(kWrong), 1.5F);
  ImGui::SameLine(0, 0);
  ImGui::TextUnformatted(text.substr(end, kAround).c_str());
}

}  // namespace

void show_wrapped(Tone tone, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color_of(tone));
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

bool text_field(const std::string& label, std::string& text, bool wrong) {
  ImGui::PushID(label.c_str());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label.c_str());
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, kWrong);
  const bool changed = ImGui::InputText("##text", &text);
  if (wrong) ImGui::PopStyleColor();
  ImGui::PopID();
  return changed;
}

void show_error(const Error& error) {
  show_place(error.place());
  show_wrapped(Tone::Wrong, error.what());
  if (!error.hint().empty()) show_wrapped(Tone::Quiet, error.hint());
}

void show_tip(Action action) {
  if (!ImGui::IsItemHovered()) return;
  const auto key = std::ranges::find(key_table(), action, &KeyBinding::action);
  ImGui::SetTooltip("%s (%s)", key->help, key->name);
}

}  // namespace saddle
