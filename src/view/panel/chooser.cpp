#include "view/panel/chooser.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "view/panel/fields.h"
#include "view/panel/widgets.h"

namespace saddle {
namespace {

constexpr const char* kName = "chooser";

/// In letters.
constexpr float kWidth = 34;
constexpr float kHeight = 24;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

}  // namespace

std::vector<Choice> matching(std::vector<Choice> choices, const std::string& query) {
  const std::string wanted = lower(query);
  std::erase_if(choices, [&](const Choice& choice) {
    const std::string text = lower(choice.name + " " + choice.detail);
    std::istringstream words(wanted);
    std::string word;
    while (words >> word) {
      if (text.find(word) == std::string::npos) return true;
    }
    return false;
  });
  std::stable_partition(choices.begin(), choices.end(), [&](const Choice& choice) {
    return lower(choice.name).starts_with(wanted);
  });
  return choices;
}

void Chooser::open(std::string hint, std::string query, Choices choices) {
  hint_ = std::move(hint);
  query_ = std::move(query);
  choices_ = std::move(choices);
  is_open_ = is_new_ = true;
}

void Chooser::move() {
  const std::size_t count = shown_.size();
  if (count == 0) return;
  has_moved_ = true;
  if (is_pressed(ImGuiKey_DownArrow)) {
    selected_ = std::min(selected_ + 1, count - 1);
  } else if (is_pressed(ImGuiKey_UpArrow)) {
    selected_ -= selected_ > 0 ? 1 : 0;
  } else {
    has_moved_ = false;
  }
}

/// True if it was pressed.
bool Chooser::show_choice(const Choice& choice, bool is_selected) const {
  const ImGuiSelectableFlags flags =
      ImGuiSelectableFlags_DontClosePopups |
      (choice.is_possible ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled);
  const bool pressed = ImGui::Selectable(choice.name.c_str(), is_selected, flags);
  if (is_selected && has_moved_) ImGui::SetScrollHereY();
  if (choice.detail.empty()) return pressed;
  ImGui::SameLine(std::max(ImGui::CalcTextSize(choice.name.c_str()).x + ImGui::GetFontSize(),
                           11 * ImGui::GetFontSize()));
  ImGui::TextDisabled("%s", shortened(choice.detail, ImGui::GetContentRegionAvail().x).c_str());
  return pressed;
}

/// The one that was pressed.
std::optional<Choice> Chooser::show_choices() {
  std::optional<Choice> pressed;
  ImGui::BeginChild("##choices");
  if (shown_.empty()) ImGui::TextDisabled("nothing has this name");
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (show_choice(shown_[i], i == selected_)) pressed = shown_[i];
    ImGui::PopID();
  }
  ImGui::EndChild();
  return pressed;
}

/// Goes on with its query, or closes the list and does it.
void Chooser::take(const Choice& choice) {
  if (choice.query) {
    query_ = *choice.query;
    is_new_ = true;  // the field takes its text anew
    return;
  }
  is_open_ = false;
  if (choice.take) choice.take();  // it may open another list
}

void Chooser::show(double left, bool is_confirmed) {
  if (!is_open_) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float letter = ImGui::GetFontSize();
  const float width = std::min(kWidth * letter, screen.x - 2 * letter);
  const float middle = (static_cast<float>(left) + screen.x) / 2;
  if (is_new_ && !ImGui::IsPopupOpen(kName)) ImGui::OpenPopup(kName);
  const float most = std::max(letter, screen.x - letter - width);  // within the window
  ImGui::SetNextWindowPos({std::clamp(middle - width / 2, letter, most), 2 * letter});
  ImGui::SetNextWindowSize({width, std::min(kHeight * letter, screen.y - 4 * letter)});
  is_open_ = ImGui::BeginPopup(kName, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
  if (!is_open_) return;
  if (is_new_) {
    leave_fields();
    ImGui::SetKeyboardFocusHere();
    selected_ = 0;
    shown_ = choices_(query_);
    listed_ = query_;
    is_new_ = false;
  }
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##query", hint_.c_str(), &query_);
  if (query_ != listed_) {
    shown_ = choices_(query_);
    listed_ = query_;
    selected_ = 0;
  }
  move();
  std::optional<Choice> chosen = show_choices();
  if (is_confirmed && selected_ < shown_.size()) chosen = shown_[selected_];
  if (chosen && !chosen->is_possible) chosen.reset();
  if (chosen && !chosen->query) {
    ImGui::CloseCurrentPopup();
    leave_fields();
  }
  ImGui::EndPopup();
  if (chosen) take(*chosen);
}

}  // namespace saddle
