// The panel's fields and lists: which of them has the keyboard, and how they let go of it.
#pragma once

namespace saddle {

/// Keys go into a field.
bool is_text_wanted();
/// A list or menu is open, wherever it reaches.
bool is_popup_open();
/// The field that keys go into stands in for a slider.
bool is_editing_number();
/// Escape goes back to the text that the field has now.
void confirm_text();
/// Empties the field that has the keyboard, and forgets its steps of undo.
void clear_text();
/// Takes the keyboard from any field.
void leave_fields();
/// Gives the keyboard to the first field that this window shows from here on, as Tab does: buttons
/// before it are passed by.
void enter_next_field();
/// Closes lists and menus.
void close_popups();

}  // namespace saddle
