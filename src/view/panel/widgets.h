// Parts that the panel is made of: texts, fields with labels, small buttons, errors with their
// places.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/model/scene.h"

namespace saddle {

enum class Tone { Plain, Quiet, Wrong, Warning };

/// Text in as many lines as the panel's width needs.
void show_wrapped(Tone tone, const std::string& text);

/// A field for a line of text with its label before it; what it was changed to. `hint`: shown while
/// there is no text. `wrong`: in Tone::Wrong.
std::optional<std::string> text_field(const std::string& label, const std::string& text,
                                      bool wrong = false, const std::string& hint = "");

/// The same without a label, of a width in letters; 0: all that there is. `id` tells it from
/// others.
std::optional<std::string> bare_field(const char* id, const std::string& text, float letters,
                                      bool wrong = false);

/// One of some words; what it was changed to. The hint stands for an empty one.
std::optional<std::string> word_field(const std::string& label, const std::string& word,
                                      const std::vector<std::string>& words,
                                      const std::string& hint = "");

/// A little square of a colour, which opens a picker; what it was changed to.
std::optional<Color> color_chip(const char* id, const Color& color);

enum class Icon { Eye, ClosedEye, Copy, Delete, Up, Play, Stop };

/// A button as large as a letter; true if it was pressed.
bool icon_button(Icon icon, const char* tip);
/// The width of `count` of them, side by side.
float icons_width(int count);

/// The name of what follows in its line: a long one is shortened, and its tip has all of it.
void show_name(const std::string& name);

/// A row that is folded by its name, and how many icons have room behind the beginning of that.
struct FoldRow {
  bool is_open = false;
  int icons = 0;
};

/// The caller adds the icons: at most as many as are wanted.
FoldRow fold_row(const std::string& name, int wanted_icons, bool is_open_at_first = false);

/// The wrong part of the error's text, the message and the hint. `owner`: the object that it is
/// about, where there are several.
void show_error(const Error& error, const std::string& owner = "");

/// All of an error as lines of text, in the words of a window: without the program's name, and
/// without hints that are commands.
std::string window_text(const Error& error);

/// A text, with "…" in place of what is wider than so many pixels.
std::string shortened(const std::string& text, float width);

/// A text that is wrapped, without what is beyond some screens full; "…" stands for it. The toolkit
/// ends the process above 16 000 letters.
std::string beginning_of(const std::string& text);

/// A sentence with the panel's fields in place of the command line's options: "clip off" for
/// "--clip off".
std::string for_panel(const std::string& sentence);

enum class TipPlace { AtPointer, BesideWindow };

/// The tooltip of the last thing, unless a hand is at work.
void show_tip(const std::string& text, TipPlace place = TipPlace::AtPointer);

}  // namespace saddle
