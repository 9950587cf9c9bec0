#include "view/panel/fields.h"

#include <algorithm>

#include <imgui.h>
#include <imgui_internal.h>

namespace saddle {

bool is_text_wanted() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.ActiveId != 0 && context.ActiveId == context.InputTextState.ID;
}

bool is_popup_open() {
  return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool is_editing_number() {
  return is_text_wanted() && ImGui::TempInputIsActive(ImGui::GetActiveID());
}

void confirm_text() {
  if (!is_text_wanted()) return;
  ImGuiInputTextState& state = ImGui::GetCurrentContext()->InputTextState;
  if (!state.TextAIsValid) return;  // nothing was typed
  state.InitialTextA.resize(state.CurLenA + 1);
  std::copy_n(state.TextA.Data, state.InitialTextA.Size, state.InitialTextA.Data);
}

void clear_text() {
  if (!is_text_wanted()) return;
  ImGuiInputTextState& state = ImGui::GetCurrentContext()->InputTextState;
  state.ClearText();
  state.InitialTextA.resize(1);
  state.InitialTextA[0] = 0;
  // Steps of undo are about places that are no more.
  state.Stb.undostate.undo_point = 0;
  state.Stb.undostate.undo_char_point = 0;
  state.Stb.undostate.redo_point = STB_TEXTEDIT_UNDOSTATECOUNT;
  state.Stb.undostate.redo_char_point = STB_TEXTEDIT_UNDOCHARCOUNT;
}

void enter_next_field() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGui::FocusWindow(ImGui::GetCurrentWindow());
  ImGui::NavMoveRequestSubmit(ImGuiDir_None, ImGuiDir_Down, ImGuiNavMoveFlags_Tabbing,
                              ImGuiScrollFlags_KeepVisibleEdgeY);
  context.NavTabbingDir = 1;
  context.NavTabbingCounter = 1;
}

void leave_fields() {
  ImGui::ClearActiveID();
}

void close_popups() {
  leave_fields();
  if (is_popup_open()) ImGui::ClosePopupToLevel(0, true);
}

}  // namespace saddle
