// Text in HTML and XML.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/model/scene.h"

namespace saddle {

/// Text that stands for itself between tags and in quotes.
std::string escaped_markup(std::string_view text);

/// The same on one line: Markdown ends a block of HTML at an empty one.
std::string escaped_line(std::string_view text);

/// The text between the first of both marks and the next other, as it was before it was escaped;
/// nothing without them.
std::optional<std::string> text_between(std::string_view markup, std::string_view begins,
                                        std::string_view ends);

/// The formulas of a scene's surfaces and curves, a line each, and its definitions in the last one:
/// what a picture shows, for those who do not see it.
std::string formulas_as_text(const Scene& scene);

}  // namespace saddle
