// The files of src/export/page/: the script and the style of exported pages.
#pragma once

#include <string_view>

namespace saddle {

/// The text of a file by its name, "main.js"; empty if there is none.
std::string_view page_source(std::string_view name);

}  // namespace saddle
