// Parts that the panel is made of: texts, fields with labels, errors with their places.
#pragma once

#include <string>

#include "base/error.h"
#include "view/model/keys.h"

namespace saddle {

enum class Tone { Plain, Quiet, Wrong };

/// Text in as many lines as the panel's width needs.
void show_wrapped(Tone tone, const std::string& text);

/// A line of text with its label before it; true if it was changed. `wrong`: in Tone::Wrong.
bool text_field(const std::string& label, std::string& text, bool wrong);

/// The wrong part of the error's text, the message and the hint.
void show_error(const Error& error);

/// The tooltip of the last button, which does what a key does.
void show_tip(Action action);

}  // namespace saddle
