// A window with OpenGL 3.3 and a panel toolkit in it: GLFW and Dear ImGui, started and ended.
// Events of the window are collected between two frames.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "render/gl/context.h"
#include "render/gl/viewport.h"
#include "view/window/events.h"

struct GLFWwindow;

namespace saddle {

class Window {
 public:
  /// Size in pixels as the user means them: on a display with content scale 2 it gets twice as
  /// many. Throws Error (Machine) if there is no display or its OpenGL is too old.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits until something happens, or `seconds` have passed; nothing: for ever.
  void wait(std::optional<double> seconds);
  /// Makes wait() return; from any thread.
  static void wake();

  /// As if it had just happened at a place of the window: for GLFW, and for tests that play a hand.
  void receive(Event event);

  /// The events so far, in order, but no more than one frame of the panel can tell apart: it
  /// sees only what is down when it looks. The rest waits for the next frame. tell_panel() passes
  /// an event on.
  std::vector<Event> take_events();
  bool has_events() const { return !events_.empty(); }
  /// The panel's next frame takes part in what has happened.
  void tell_panel(const Event& event);
  /// The window is asked to close, since the last call.
  bool take_close_request();
  /// The window wants to be painted: it was uncovered or has another size.
  bool take_damage();

  dvec2 framebuffer_size() const;
  /// Pixels per unit of the user's.
  double scale() const { return scale_; }

  /// A context like the window's, without anything to see, which no thread has entered. This thread
  /// ends it, before the window. Throws Error (Machine).
  static std::unique_ptr<Context> make_context();

  void set_title(const std::string& title);
  /// The whole screen, or a window again.
  void toggle_full_screen();
  void set_clipboard(const std::string& text);

  /// The panel is light, with dark letters, or dark.
  void set_light(bool is_light);

  /// Around what Dear ImGui is told to show.
  void begin_panel();
  /// Before end_panel(): that is other than the last end_panel() drew.
  bool is_panel_new();
  /// The parts of the window that have something of it.
  std::vector<PixelRect> end_panel();
  /// Shows the drawn frame on the screen.
  void swap();

 private:
  void make_window(const std::string& title, int width, int height);
  void listen();
  void start_panel();
  void listen_to_keys();
  void receive_here(Event event);

  GLFWwindow* window_ = nullptr;
  double scale_ = 1;
  bool is_light_ = false;
  std::deque<Event> events_;
  dvec2 pointer_{0, 0};  ///< where events have brought it; GLFW tells where it is by now
  bool is_inside_ = false;
  bool is_repeated_ = false;       ///< the last key, which is held down
  std::array<int, 4> windowed_{};  ///< place and size, while the window is the screen
  bool damaged_ = true;
  std::string drawn_panel_;  ///< what end_panel() has drawn, as bytes
  // The state that the panel was told.
  dvec2 shown_pointer_{0, 0};
  std::array<bool, 3> shown_buttons_{};
  double last_press_time_ = -1;
  dvec2 last_press_{0, 0};
};

}  // namespace saddle
