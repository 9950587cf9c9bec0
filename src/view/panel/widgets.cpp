#include "view/panel/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "view/panel/colors.h"

namespace saddle {
namespace {

/// Characters on each side of a wrong place that are shown of a long line.
constexpr std::size_t kAround = 12;

/// In place of what is left out.
const std::string kRest = "…";

ImVec4 color_of(Tone tone) {
  switch (tone) {
    case Tone::Quiet:
      return inks().quiet;
    case Tone::Wrong:
      return inks().wrong;
    case Tone::Warning:
      return inks().warning;
    case Tone::Plain:
      break;
  }
  return ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

/// Whether a byte of UTF-8 is behind the first one of its letter.
bool is_inside_letter(char byte) {
  constexpr unsigned kTopBits = 0xC0;
  return (static_cast<unsigned char>(byte) & kTopBits) == 0x80;
}

/// The line of a text that a place begins in, as if it were the text.
Place in_its_line(const Place& place) {
  const std::string& text = place.text;
  const std::size_t at = std::min(place.span.begin, text.size());
  const std::size_t before = at > 0 ? text.rfind('\n', at - 1) : std::string::npos;
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t end = std::min(text.find('\n', at), text.size());
  return {place.name,
          text.substr(begin, end - begin),
          {at - begin, std::clamp(place.span.end, at, end) - begin}};
}

/// The last letters before `end`.
std::string before_place(const std::string& text, std::size_t end) {
  std::size_t begin = end - std::min(end, kAround);
  while (begin > 0 && is_inside_letter(text[begin])) --begin;
  return (begin > 0 ? kRest : "") + text.substr(begin, end - begin);
}

/// The first letters from `begin` on.
std::string behind_place(const std::string& text, std::size_t begin) {
  std::size_t end = std::min(begin + kAround, text.size());
  while (end < text.size() && is_inside_letter(text[end])) ++end;
  return text.substr(begin, end - begin) + (end < text.size() ? kRest : "");
}

/// The part of the text that is wrong, underlined, with a little around it.
void show_place(const Place& in_all) {
  const Place place = in_its_line(in_all);
  const std::string& text = place.text;
  if (text.empty()) return;
  const std::size_t begin = std::min(place.span.begin, text.size());
  const std::size_t end = std::clamp(place.span.end, begin, text.size());
  ImGui::TextUnformatted(before_place(text, begin).c_str());
  constexpr float kShare = 0.5F;
  const std::string all = begin < end ? text.substr(begin, end - begin) : " ";
  const std::string wrong = shortened(all, kShare * ImGui::GetContentRegionAvail().x);
  ImGui::SameLine(0, 0);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Text, inks().wrong);
  ImGui::TextUnformatted(wrong.c_str());
  ImGui::PopStyleColor();
  const ImVec2 size = ImGui::CalcTextSize(wrong.c_str());
  ImGui::GetWindowDrawList()->AddLine({corner.x, corner.y + size.y},
                                      {corner.x + size.x, corner.y + size.y},
                                      ImGui::GetColorU32(inks().wrong), 1.5F);
  ImGui::SameLine(0, 0);
  ImGui::TextUnformatted(behind_place(text, end).c_str());
}

/// The field that follows stands behind it; behind names of one letter it stands at one place.
void show_name_as(const std::string& seen) {
  ImGui::AlignTextToFramePadding();
  const float begin = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(seen.c_str());
  const float end = begin + std::max(ImGui::CalcTextSize(seen.c_str()).x,
                                     ImGui::CalcTextSize("R").x);  // few letters are wider
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(end + ImGui::GetStyle().ItemSpacing.x);
}

void show_label(const std::string& label) {
  show_name_as(label);
  ImGui::SetNextItemWidth(-1);
}

/// Drawn in a square with its middle at `c` and half a side of `r`.
void draw_icon(ImDrawList& list, Icon icon, const ImVec2& c, float r, ImU32 color) {
  const float line = std::max(1.0F, r / 5);
  const auto at = [&](float x, float y) { return ImVec2{c.x + x * r, c.y + y * r}; };
  switch (icon) {
    case Icon::Eye:
      list.AddBezierQuadratic(at(-1, 0), at(0, -1.3F), at(1, 0), color, line);
      list.AddBezierQuadratic(at(-1, 0), at(0, 1.3F), at(1, 0), color, line);
      list.AddCircleFilled(c, 0.3F * r, color);
      return;
    case Icon::ClosedEye:
      list.AddBezierQuadratic(at(-1, 0), at(0, 1.3F), at(1, 0), color, line);
      return;
    case Icon::Copy:
      list.AddRect(at(-0.8F, -0.8F), at(0.3F, 0.3F), color, 0, 0, line);
      list.AddRectFilled(at(-0.3F, -0.3F), at(0.8F, 0.8F), color);
      return;
    case Icon::Delete:
      list.AddLine(at(-0.6F, -0.6F), at(0.6F, 0.6F), color, line);
      list.AddLine(at(-0.6F, 0.6F), at(0.6F, -0.6F), color, line);
      return;
    case Icon::Up:
      list.AddTriangleFilled(at(0, -0.6F), at(0.7F, 0.5F), at(-0.7F, 0.5F), color);
      return;
    case Icon::Play:
      list.AddTriangleFilled(at(-0.5F, -0.7F), at(0.8F, 0), at(-0.5F, 0.7F), color);
      return;
    case Icon::Stop:
      list.AddRectFilled(at(-0.6F, -0.6F), at(0.6F, 0.6F), color);
      return;
  }
}

/// Hints of an error but for commands, of which a window has none.
Hint hints_of(const Error& error) {
  Hint hints;
  for (const std::string& line : error.hint_lines()) {
    if (!line.starts_with("saddle ")) hints.add(line);
  }
  return hints;
}

float icon_side() {
  return ImGui::GetFontSize() + 2;
}

}  // namespace

void show_wrapped(Tone tone, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color_of(tone));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(beginning_of(text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

std::optional<std::string> text_field(const std::string& label, const std::string& text, bool wrong,
                                      const std::string& hint) {
  ImGui::PushID(label.c_str());
  show_label(label);
  std::string now = text;
  const float width = ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::BeginGroup();
  if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, inks().wrong);
  const std::string seen_hint = shortened(for_panel(hint), width);
  const bool changed = ImGui::InputTextWithHint("##text", seen_hint.c_str(), &now);
  if (wrong) ImGui::PopStyleColor();
  // One line shows a part of a long formula: all of it stands below while it is edited.
  const bool is_long = ImGui::CalcTextSize(now.c_str()).x > width;
  if (is_long && ImGui::IsItemActive()) {
    show_wrapped(Tone::Quiet, now);
  } else if (is_long) {
    show_tip(now);
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return changed ? std::optional(now) : std::nullopt;
}

std::optional<std::string> bare_field(const char* id, const std::string& text, float letters,
                                      bool wrong) {
  const float width = letters * ImGui::GetFontSize() / 2 + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(letters > 0 ? width : -1);
  std::string now = text;
  if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, inks().wrong);
  const bool changed = ImGui::InputText(id, &now);
  if (wrong) ImGui::PopStyleColor();
  return changed ? std::optional(now) : std::nullopt;
}

std::optional<std::string> word_field(const std::string& label, const std::string& word,
                                      const std::vector<std::string>& words,
                                      const std::string& hint) {
  std::optional<std::string> chosen;
  ImGui::PushID(label.c_str());
  show_label(label);
  if (word.empty()) ImGui::PushStyleColor(ImGuiCol_Text, inks().quiet);
  const bool is_open = ImGui::BeginCombo("##words", word.empty() ? hint.c_str() : word.c_str());
  if (word.empty()) ImGui::PopStyleColor();
  if (is_open) {
    for (const std::string& each : words) {
      const std::string& seen = each.empty() ? hint : each;
      if (ImGui::Selectable(seen.c_str(), each == word)) chosen = each;
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  return chosen;
}

std::optional<Color> color_chip(const char* id, const Color& color) {
  std::array<float, 3> rgb{static_cast<float>(color.r.value), static_cast<float>(color.g.value),
                           static_cast<float>(color.b.value)};
  constexpr ImGuiColorEditFlags kFlags = ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel;
  if (!ImGui::ColorEdit3(id, rgb.data(), kFlags)) return std::nullopt;
  constexpr double kSteps = 255;
  const auto channel = [](float value) { return std::round(kSteps * value) / kSteps; };
  return Color{channel(rgb[0]), channel(rgb[1]), channel(rgb[2]), color.a};
}

bool icon_button(Icon icon, const char* tip) {
  const float side = icon_side();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(icon));
  const bool pressed = ImGui::InvisibleButton("##icon", {side, ImGui::GetFrameHeight()});
  ImGui::PopID();
  const ImGuiCol tone = ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled;
  draw_icon(*ImGui::GetWindowDrawList(), icon,
            {corner.x + side / 2, corner.y + ImGui::GetFrameHeight() / 2}, 0.36F * side,
            ImGui::GetColorU32(tone));
  show_tip(tip);
  return pressed;
}

float icons_width(int count) {
  return static_cast<float>(count) * (icon_side() + ImGui::GetStyle().ItemSpacing.x);
}

void show_name(const std::string& name) {
  constexpr float kShare = 0.3F;
  const std::string seen = shortened(name, kShare * ImGui::GetWindowContentRegionMax().x);
  show_name_as(seen);
  if (seen != name) show_tip(name);
}

FoldRow fold_row(const std::string& name, int wanted_icons, bool is_open_at_first) {
  constexpr float kShortest = 2;  // of a name that is shortened, in heights of letters
  const float least =
      std::min(ImGui::CalcTextSize(name.c_str()).x, kShortest * ImGui::GetFontSize());
  const float begin = ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing();
  const auto end = [](int icons) {
    return ImGui::GetWindowContentRegionMax().x - icons_width(icons);
  };
  int icons = wanted_icons;
  while (icons > 0 && end(icons) - begin < least) --icons;
  const std::string seen = shortened(name, end(icons) - begin);
  ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_NoTreePushOnOpen |
                             ImGuiTreeNodeFlags_AllowItemOverlap |
                             ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_FramePadding;
  if (is_open_at_first) flags |= ImGuiTreeNodeFlags_DefaultOpen;
  const bool is_open = ImGui::TreeNodeEx("##row", flags, "%s", seen.c_str());
  if (seen != name) show_tip(name);
  if (icons > 0) ImGui::SameLine(end(icons));
  return {is_open, icons};
}

void show_error(const Error& error, const std::string& owner) {
  const Place& place = error.place();
  show_place(place);
  std::string about = place.where.empty() ? owner : place.where;
  // Where there is no text to show, the name tells what is wrong.
  if (place.text.empty() && !place.name.empty()) about += (about.empty() ? "" : " ") + place.name;
  show_wrapped(Tone::Wrong, (about.empty() ? "" : about + ": ") + error.what());
  for (const std::string& line : hints_of(error)) show_wrapped(Tone::Quiet, line);
}

std::string window_text(const Error& error) {
  const std::string text =
      format_error(Error(error.status(), error.what(), error.place(), hints_of(error)));
  constexpr std::string_view kProgram = "saddle: ";
  return text.starts_with(kProgram) ? text.substr(kProgram.size()) : text;
}

std::string shortened(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  const float room = std::max(0.0F, width - ImGui::CalcTextSize(kRest.c_str()).x);
  const char* end = text.data();
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), room, 0, text.data(),
                                  text.data() + text.size(), &end);
  return std::string(text.data(), end) + kRest;
}

std::string beginning_of(const std::string& text) {
  constexpr std::size_t kMostBytes = 4000;
  if (text.size() <= kMostBytes) return text;
  std::size_t end = kMostBytes;
  while (end > 0 && is_inside_letter(text[end])) --end;
  return text.substr(0, end) + kRest;
}

std::string for_panel(const std::string& sentence) {
  std::string text;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool begins = i == 0 || sentence[i - 1] == ' ';
    const bool is_dashes = begins && sentence.compare(i, 2, "--") == 0;
    if (is_dashes) {
      ++i;
    } else {
      text += sentence[i];
    }
  }
  return text;
}

void show_tip(const std::string& text, TipPlace place) {
  if (!ImGui::IsItemHovered() || ImGui::IsAnyItemActive()) return;
  if (place == TipPlace::BesideWindow) {
    ImGui::SetNextWindowPos(
        {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), ImGui::GetItemRectMin().y});
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(20 * ImGui::GetFontSize());
  ImGui::TextUnformatted(beginning_of(text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace saddle
