// A display of its own for each test, with the viewer on it: real windows, real events.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/image.h"
#include "temporary_folder.h"

namespace saddle {

/// Starts Xvfb; skips the test where there is none.
class ViewerTest : public ::testing::Test {
 protected:
  static constexpr int kPanelWidth = 320;

  void SetUp() override;
  void TearDown() override;

  /// Starts saddle and waits until its window shows something.
  void open(std::vector<std::string> arguments);
  /// Starts saddle and waits for nothing.
  void start(std::vector<std::string> arguments);
  /// The title of the window.
  std::string title() const;
  /// Waits for the viewer's end: its exit status, or -1 if it does not end.
  int status();
  /// Runs saddle to its end, without a display, or on this one.
  int headless(const std::vector<std::string>& arguments) { return run(arguments, {}); }
  int run(const std::vector<std::string>& arguments, const std::string& display);
  /// Ends the display under the window.
  void end_display();
  /// What the display says of its dots per inch, for those who ask from now on.
  void set_dots_per_inch(int dots) const;

  /// Feeds words to xdotool: "key g", "mousemove 10 20 click 1".
  void act(const std::string& words) const;
  /// Moves and clicks at a pixel of the picture, which begins at the right of the panel.
  void click(int x, int y, const std::string& options = "");
  /// Moves with a button held down.
  void drag(int button, int x0, int y0, int x1, int y1);
  /// Clicks into the panel's n-th field that takes text (0: x) and goes to its end.
  void enter_field(int row) const;
  /// Clicks into the field for a new definition of a scene that has none, of one surface.
  void enter_new_definition() const;

  Image screenshot() const;
  /// The bottom of the panel, where it says what is wrong.
  Image error_strip() const;
  /// The picture at the right of the panel.
  Image picture() const;
  /// Whether it becomes true within some seconds.
  static bool eventually(const std::function<bool()>& condition);
  /// The picture once it does not change any more.
  Image settled_picture() const;

  /// Its name: ":7".
  const std::string& display() const { return display_; }

  std::string standard_output() const;
  std::string standard_error() const;
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();

 private:
  pid_t server_ = 0;
  pid_t viewer_ = 0;
  std::string display_;
};

/// The viewer in this process, on that display. The test's folder is the current one, and gets the
/// files that are saved.
class ViewerHere : public ViewerTest {
 protected:
  void SetUp() override;
  void TearDown() override;

 private:
  std::filesystem::path before_;
};

/// Pixels that are yellow, the colour of a front.
int yellow_pixels(const Image& image);

}  // namespace saddle
