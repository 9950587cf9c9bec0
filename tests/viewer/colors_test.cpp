// Letters of the panel can be read wherever they stand.
#include "view/panel/colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace saddle {
namespace {

constexpr double kReadable = 4.5;  // WCAG 2.1, 1.4.3
constexpr double kVisible = 3;     // the same, of large letters and of parts that are no text

double luminance(const ImVec4& color) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.x) + 0.7152 * linear(color.y) + 0.0722 * linear(color.z);
}

double contrast(const ImVec4& a, const ImVec4& b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

ImVec4 over(const ImVec4& ink, const ImVec4& ground) {
  const auto mixed = [&](float a, float b) { return ink.w * a + (1 - ink.w) * b; };
  return {mixed(ink.x, ground.x), mixed(ink.y, ground.y), mixed(ink.z, ground.z), 1};
}

using Grounds = std::vector<std::pair<std::string, ImVec4>>;

const ImVec4& color(ImGuiCol number) {
  return ImGui::GetStyle().Colors[number];
}

void add(Grounds& grounds, const std::string& below, const ImVec4& ground,
         const std::vector<ImGuiCol>& colors) {
  for (const ImGuiCol each : colors) {
    grounds.emplace_back(below + " " + ImGui::GetStyleColorName(each), over(color(each), ground));
  }
}

/// Windows over pictures of any colour, without what stands in them.
Grounds windows() {
  Grounds grounds;
  for (const auto& [name, picture] : Grounds{{"black", {0, 0, 0, 1}}, {"white", {1, 1, 1, 1}}}) {
    add(grounds, name, picture, {ImGuiCol_WindowBg, ImGuiCol_PopupBg});
  }
  Grounds all = grounds;
  for (const auto& [name, window] : grounds) add(all, name, window, {ImGuiCol_MenuBarBg});
  return all;
}

/// All that texts of any tone may stand on.
Grounds grounds_of_text() {
  Grounds all = windows();
  for (const auto& [name, window] : windows()) {
    add(all, name, window,
        {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_Button,
         ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderHovered,
         ImGuiCol_HeaderActive});
    add(all, name + " field", over(color(ImGuiCol_FrameBg), window), {ImGuiCol_TextSelectedBg});
  }
  return all;
}

void expect_contrast(const std::string& what, const ImVec4& ink, const Grounds& grounds,
                     double least) {
  for (const auto& [name, ground] : grounds) {
    EXPECT_GE(contrast(over(ink, ground), ground), least) << what << " on " << name;
  }
}

void expect_readable_texts() {
  const Grounds grounds = grounds_of_text();
  EXPECT_GT(grounds.size(), 40U);
  expect_contrast("text", color(ImGuiCol_Text), grounds, kReadable);
  expect_contrast("hint", color(ImGuiCol_TextDisabled), grounds, kReadable);
  expect_contrast("mistake", inks().wrong, grounds, kReadable);
  expect_contrast("warning", inks().warning, grounds, kReadable);
  expect_contrast("fact", inks().quiet, grounds, kReadable);
  // What cannot be used is not below the pointer.
  for (const ImGuiCol text : {ImGuiCol_Text, ImGuiCol_TextDisabled}) {
    ImVec4 ink = color(text);
    ink.w *= ImGui::GetStyle().DisabledAlpha;
    expect_contrast("unusable", ink, windows(), kVisible);
  }
}

/// Handles of sliders can be seen, and their text can be read on them.
void expect_visible_handles() {
  for (const ImGuiCol handle : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) {
    for (const ImGuiCol frame :
         {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}) {
      const ImVec4 below = over(color(frame), color(ImGuiCol_WindowBg));
      const ImVec4 ground = over(color(handle), below);
      const std::string names =
          std::string(ImGui::GetStyleColorName(handle)) + " on " + ImGui::GetStyleColorName(frame);
      EXPECT_GE(contrast(color(ImGuiCol_Text), ground), kReadable) << names;
      EXPECT_GE(contrast(ground, below), 2) << names;
    }
  }
  const ImVec4 field = over(color(ImGuiCol_FrameBg), color(ImGuiCol_WindowBg));
  EXPECT_GE(contrast(color(ImGuiCol_CheckMark), field), kVisible);
}

/// Dear ImGui without a window.
class Colors : public ::testing::Test {
 protected:
  void SetUp() override { ImGui::CreateContext(); }
  void TearDown() override { ImGui::DestroyContext(); }
};

TEST_F(Colors, CanBeReadOnAllDarkGrounds) {
  use_dark_colors();
  expect_readable_texts();
  expect_visible_handles();
}

TEST_F(Colors, CanBeReadOnAllLightGrounds) {
  use_light_colors();
  expect_readable_texts();
  expect_visible_handles();
}

TEST_F(Colors, AreTheOthersAfterAChange) {
  use_dark_colors();
  const ImVec4 on_dark = inks().wrong;
  use_light_colors();
  EXPECT_LT(luminance(inks().wrong), luminance(on_dark));
}

}  // namespace
}  // namespace saddle
