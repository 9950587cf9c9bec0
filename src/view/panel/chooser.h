// A list in the middle of the window that is searched by typing: of actions, surfaces of the
// gallery, files.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace saddle {

/// A line of the list.
struct Choice {
  std::string name;
  std::string detail = {};                ///< at the right, or below
  bool is_possible = true;                ///< else it is shown, but cannot be chosen
  std::function<void()> take = {};        ///< chosen; closes the list
  std::optional<std::string> query = {};  ///< chosen: this is searched for, in place of `take`
};

class Chooser {
 public:
  /// The lines for what was typed, the best first.
  using Choices = std::function<std::vector<Choice>(const std::string& query)>;

  /// Shows a list from the next frame on. `hint`: what to type.
  void open(std::string hint, std::string query, Choices choices);
  bool is_open() const { return is_open_; }

  /// Between Window::begin_panel() and end_panel(). `left`: where the picture begins, in pixels;
  /// `is_confirmed`: Return was pressed.
  void show(double left, bool is_confirmed);

 private:
  void move();
  bool show_choice(const Choice& choice, bool is_selected) const;
  std::optional<Choice> show_choices();
  void take(const Choice& choice);

  std::string hint_;
  std::string query_;
  Choices choices_;
  std::string listed_;  ///< the query that `shown_` is for
  std::vector<Choice> shown_;
  std::size_t selected_ = 0;
  bool is_open_ = false;
  bool is_new_ = false;  ///< opened since the last frame
  bool has_moved_ = false;
};

/// The choices whose names or details have all the words of the query, those first whose names
/// begin with it; whatever the case of the letters.
std::vector<Choice> matching(std::vector<Choice> choices, const std::string& query);

}  // namespace saddle
