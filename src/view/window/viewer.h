// The viewer: a window that shows a scene, and a hand, a keyboard and a panel that change it. It
// waits, takes what happened, changes the model and draws what has changed; nothing is drawn while
// nothing happens.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "view/model/hand.h"
#include "view/model/model.h"
#include "view/model/session.h"
#include "view/panel/chooser.h"
#include "view/panel/overlay.h"
#include "view/panel/panel.h"
#include "view/panel/start_page.h"
#include "view/picture/drawing.h"
#include "view/picture/exporter.h"
#include "view/picture/thumbnails.h"
#include "view/window/window.h"

namespace saddle {

/// The time that a viewer has spent, by task.
struct Spent {
  std::chrono::steady_clock::duration busy{};     ///< from what happened to the screen
  std::chrono::steady_clock::duration drawing{};  ///< of that, pictures
  std::chrono::steady_clock::duration showing{};  ///< copying them to the window, with the panel
  std::size_t frames = 0;
};

class Viewer {
 public:
  /// Opens a window. Throws Error (Machine) without a display or OpenGL 3.3.
  explicit Viewer(ViewerSetup setup);

  /// Returns when the window is closed. Errors of the scene and of drawing are shown in it.
  void run();

  /// One round: waits until something happens, does it and draws.
  void step();
  /// The window is to close, and nothing that it waits for goes on.
  bool is_to_end();

  /// A hand or a keyboard does something: for tests.
  void receive(const Event& event) { window_.receive(event); }
  bool has_events() const { return window_.has_events(); }
  /// Nothing has happened that is not shown yet, and nothing goes on.
  bool is_at_rest() const;
  /// It has rested for so long that the memory it does not need has gone back.
  bool is_tidy() const { return is_at_rest() && !tidy_at_; }
  const Model& model() const { return model_; }
  Spent spent() const { return {busy_, drawing_.spent(), showing_, paints_}; }
  const Drawing& drawing() const { return drawing_; }
  /// It is shown over the picture; empty: there is none.
  const std::string& message() const { return message_; }

 private:
  using Clock = Model::Clock;

  /// Work is kept when nothing has changed for so long.
  static constexpr std::chrono::seconds kKeep{1};
  /// Memory that is free goes back to the system after so long a rest.
  static constexpr std::chrono::seconds kTidy{1};

  std::optional<double> patience() const;
  void print_times() const;
  void touch();
  void change_picture();
  void say(const std::string& text);
  void handle(const Event& event);
  void press(const Event& event);
  bool is_taken_from_panel(const Event& event) const;
  void key(const std::string& name);
  bool can(Action action) const;
  void act(Action action);
  bool act_on_window(Action action);
  bool act_on_files(Action action);
  void dismiss();
  void copy(Action action);
  void list_actions();
  void list_gallery();
  void list_files();
  void list_exports();
  void write_file(const Export& file);
  void show_scene(Scene scene, std::function<Scene()> reload, std::filesystem::path file = {});
  void open(const std::filesystem::path& path);
  void restore_work();
  void keep_work(bool now);
  void tidy();
  bool may_lose_work();
  void tell_display_gone();
  void look_at_file();
  dvec2 in_picture(const dvec2& place) const { return {place.x - panel_width(), place.y}; }
  bool is_over_picture(const Event& event) const;
  double panel_width() const;
  bool fit_picture();
  void take_events();
  void react();
  void paint();
  bool go_on_with_picture();
  void show_panels();
  bool show_frame();
  void begin_thumbnails();
  bool go_on_with_thumbnails();
  void show_start();
  bool draw();
  Overlay overlay();

  bool verbose_;
  std::filesystem::path watched_;
  std::filesystem::file_time_type written_;  ///< when that file was, as far as is known
  bool was_gone_ = false;                    ///< it was not there at the last look
  Clock::time_point looked_;
  std::function<void()> display_gone_;  ///< outlives the window
  Window window_;
  Drawing drawing_;
  Hand hand_;
  Panel panel_;
  Chooser chooser_;
  std::optional<Thumbnails> thumbnails_;  ///< once the start page was shown
  StartPage start_page_;
  Session session_;
  bool has_work_ = false;  ///< another window has left some
  // Versions of the history.
  static constexpr std::size_t kNever = -1;
  std::size_t seen_ = 0;   ///< in the last step
  std::size_t kept_ = 0;   ///< whose scene is kept as work
  std::size_t saved_ = 0;  ///< whose scene is in a file
  Clock::time_point changed_;
  std::string not_kept_;       ///< why work is not kept; empty: it is
  bool is_loss_told_ = false;  ///< quitting has said so
  std::string title_;          ///< the window's
  std::size_t paints_ = 0;
  Clock::duration busy_{};     ///< from what happened to the screen
  Clock::duration showing_{};  ///< of that, copying pictures to the window, with the panel
  bool closing_ = false;
  bool insisting_ = false;  ///< not even files that are being written are waited for
  bool help_shown_ = false;
  bool start_shown_;
  bool is_typing_ = false;  ///< the last key went to a field, and the picture was not pressed since
  int to_enter_ = 0;        ///< frames in which a field may still get the keyboard: events wait
  int to_paint_;            ///< frames that the window still needs
  bool has_key_ = false;    ///< that is answered by the panel, in its next frame
  bool was_panel_first_ = false;              ///< in the last step
  bool is_panel_behind_ = false;              ///< it has been told what its next frame must see
  bool is_damaged_ = true;                    ///< the screen does not have the last frame any more
  bool is_copying_ = false;                   ///< the window does not have all of the picture yet
  std::optional<Clock::time_point> tidy_at_;  ///< at rest, with memory that may be free
  std::string message_;
  Clock::time_point message_end_;
  // The last members: their threads wake the window.
  Exporter exporter_;
  Model model_;
};

}  // namespace saddle
