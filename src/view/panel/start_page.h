// The first page: the gallery in pictures, recent files, and ways to begin.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "view/model/actions.h"

namespace saddle {

/// The page as it is shown, and what a hand asked it for.
struct StartPage {
  std::vector<std::filesystem::path> recent;
  bool has_work = false;                           ///< that was not saved the last time
  std::function<unsigned(std::size_t)> thumbnail;  ///< OpenGL's name of a picture, or 0
  double thumbnail_width = 0;                      ///< in pixels
  double thumbnail_height = 0;
  std::size_t selected = 0;  ///< entry of the gallery

  // Set by show_start_page().
  std::optional<std::size_t> entry = {};
  std::optional<std::filesystem::path> file = {};
  std::optional<Action> action = {};
};

/// Fills the window. Arrows select, Return (`is_confirmed`) takes what is selected.
void show_start_page(StartPage& page, bool is_confirmed);

}  // namespace saddle
