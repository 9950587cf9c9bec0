#include "view/window/viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/format.h"
#include "base/standard_streams.h"
#include "scene/options/command_text.h"
#include "scene/toml/scene_file.h"
#include "view/panel/fields.h"

namespace saddle {
namespace {

using Clock = Model::Clock;

/// At most, in pixels of the user's, and as a share of the window.
constexpr double kPanelWidth = 280;
constexpr double kPanelShare = 0.45;

/// How often the watched file is looked at.
constexpr std::chrono::milliseconds kLook{200};

/// Frames after the last event, in which the panel comes to rest.
constexpr int kSettlingFrames = 3;

constexpr std::chrono::seconds kMessageTime{4};

double seconds_until(Clock::time_point time) {
  return std::max(0.0, std::chrono::duration<double>(time - Clock::now()).count());
}

/// The least time there is for a file that is not there just now.
std::filesystem::file_time_type last_write(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto time = std::filesystem::last_write_time(path, ignored);
  return ignored ? std::filesystem::file_time_type::min() : time;
}

}  // namespace

Viewer::Viewer(ViewerSetup setup)
    : verbose_(setup.verbose),
      watched_(setup.watched),
      written_(last_write(watched_)),
      window_(setup.scene.title, setup.scene.picture.width + static_cast<int>(kPanelWidth),
              setup.scene.picture.height),
      panel_(setup.quiet),
      to_paint_(kSettlingFrames),
      saver_(tessellation_of(setup), Window::wake),
      model_(std::move(setup), Window::wake) {}

void Viewer::run() {
  while (!is_to_end()) step();
  if (verbose_) print_times();
}

void Viewer::step() {
  window_.wait(patience());
  const auto begin = Clock::now();
  try {
    react();
  } catch (...) {
    say(caught_error().what());
  }
  if (window_.take_damage()) touch();
  paint();
  busy_ += Clock::now() - begin;
}

/// To events, to meshes and pictures that are finished, to the time and to the watched file.
void Viewer::react() {
  for (const Event& event : window_.take_events()) {
    if (!is_taken_from_panel(event)) window_.tell_panel(event);
    handle(event);
  }
  if (model_.take_result()) {
    touch();
    drawing_.take_meshes(model_);
  }
  if (const auto news = model_.take_news()) say(*news);
  if (const auto news = saver_.pass()) say(*news);
  model_.pass(Clock::now());
  look_at_file();
}

/// A file that was asked for is waited for; who asks to end once more does not want to.
bool Viewer::is_to_end() {
  if (window_.take_close_request()) act(Action::Quit);
  return closing_ && (insisting_ || !saver_.is_busy());
}

bool Viewer::is_at_rest() const {
  return to_paint_ == 0 && !window_.has_events() && !model_.is_meshing() && !model_.next_pass() &&
         drawing_.is_at_rest() && !saver_.is_busy();
}

void Viewer::print_times() const {
  const auto ms = [](Clock::duration d) {
    return std::chrono::duration<double, std::milli>(d).count();
  };
  const std::size_t pictures = drawing_.figures().frames;
  const Spent all = spent();
  const double outside = ms(all.busy - all.drawing - all.showing);
  tell(formatted(
      "viewer: %zu pictures, %zu frames, %g ms in OpenGL for a picture, %g ms outside of it "
      "in all, %g %%",
      pictures, all.frames,
      ms(all.drawing) / static_cast<double>(std::max<std::size_t>(1, pictures)), outside,
      100 * outside / ms(all.busy)));
}

// --- what happens
// ----------------------------------------------------------------------------------

/// How long the loop may sleep; nothing: until something happens.
std::optional<double> Viewer::patience() const {
  if (to_paint_ > 0 || window_.has_events()) return 0.0;
  std::optional<double> seconds;
  const auto at_most = [&](Clock::time_point time) {
    seconds = std::min(seconds.value_or(1e9), seconds_until(time));
  };
  if (const auto next = model_.next_pass()) at_most(*next);
  if (const auto due = drawing_.due()) at_most(*due);
  if (!message_.empty()) at_most(message_end_);
  if (!watched_.empty()) at_most(looked_ + kLook);
  return seconds;
}

void Viewer::touch() {
  to_paint_ = kSettlingFrames;
}

void Viewer::change_picture() {
  drawing_.change();
  touch();
}

void Viewer::say(const std::string& text) {
  message_ = text;
  message_end_ = Clock::now() + kMessageTime;
  touch();
}

void Viewer::handle(const Event& event) {
  touch();
  switch (event.kind) {
    case Event::Kind::Press:
      return press(event);
    case Event::Kind::Release:
      return hand_.release(event.button);
    case Event::Kind::Move:
      if (hand_.move(model_, in_picture(event.place))) change_picture();
      return;
    case Event::Kind::Scroll:
      if (!is_over_picture(event)) return;
      hand_.scroll(model_, in_picture(event.place), event.notches);
      return change_picture();
    case Event::Kind::Character:
    case Event::Kind::KeyDown:
      return key(event.key);
    case Event::Kind::KeyUp:
      return;
  }
}

bool Viewer::is_over_picture(const Event& event) const {
  return event.place.x >= panel_width() && !is_popup_open();
}

void Viewer::press(const Event& event) {
  if (!is_over_picture(event)) return;
  leave_fields();
  is_typing_ = false;
  const dvec2 pixel = in_picture(event.place);
  if (!event.twice) return hand_.press(model_, pixel, event.button, event.shift);
  model_.pick(pixel);
  if (model_.picked()) print_lines(std::array{describe(*model_.picked())});
}

/// Escape closes the uppermost thing alone; a field keeps the keyboard after Return.
bool Viewer::is_taken_from_panel(const Event& event) const {
  if (event.kind != Event::Kind::KeyDown) return false;
  if (event.key == "Escape") return help_shown_ || is_popup_open();
  return event.key == "Return" && is_text_wanted() && !is_editing_number();
}

/// Letters are keys only while the picture has the keyboard.
void Viewer::key(const std::string& name) {
  const KeyBinding* const binding = find_key(name);
  if (is_text_wanted() || is_popup_open()) {
    is_typing_ = is_typing_ || is_text_wanted();
    if (name == "Return" && is_text_wanted() && !is_editing_number()) panel_.confirm(model_);
    if (binding == nullptr || !works_while_typing(binding->action)) return;
  }
  if (binding == nullptr) return;
  if (is_typing_ && types_character(*binding)) {
    return say("click into the picture, or press Escape, to use its keys");
  }
  act(binding->action);
  change_picture();
}

/// Closes the uppermost thing; the last is the field, which gives the keyboard to the picture.
void Viewer::dismiss() {
  if (is_popup_open()) {
    close_popups();
    is_typing_ = false;
  } else if (help_shown_) {
    help_shown_ = false;
  } else {
    is_typing_ = false;
    message_.clear();
  }
}

void Viewer::act(Action action) {
  try {
    if (model_.act(action)) return;
    switch (action) {
      case Action::SavePicture:
        return saver_.save_picture(model_.scene_to_save());
      case Action::SaveScene:
        return say("saved " + save_scene(model_.scene_to_save()).string());
      case Action::Panel:
        panel_shown_ = !panel_shown_;
        return;
      case Action::Help:
        help_shown_ = !help_shown_;
        return;
      case Action::Dismiss:
        return dismiss();
      case Action::Normals:
        return drawing_.show_normals(model_, !drawing_.has_normals());
      case Action::CopyCommand:
      case Action::CopyScene:
        return copy(action);
      case Action::Quit:
        insisting_ = closing_;
        closing_ = true;
        if (saver_.is_busy()) say("saving; quit again to leave without the picture");
        return;
      default:
        return;
    }
  } catch (...) {
    say(caught_error().what());
  }
}

void Viewer::copy(Action action) {
  const Scene scene = model_.scene_to_save();
  const auto text = action == Action::CopyScene ? write_scene(scene) : command_text(scene);
  if (!text) return say("only a scene file can say this: press C");
  window_.set_clipboard(*text);
  say(action == Action::CopyScene ? "copied the scene" : "copied the command");
}

/// Editors write a file in place or put another one there: its time tells of both.
void Viewer::look_at_file() {
  if (watched_.empty() || Clock::now() < looked_ + kLook) return;
  looked_ = Clock::now();
  const auto written = last_write(watched_);
  if (written == written_) return;
  written_ = written;
  model_.reload();
  touch();
}

// --- what is shown
// ---------------------------------------------------------------------------------

double Viewer::panel_width() const {
  if (!panel_shown_) return 0;
  return std::floor(
      std::min(kPanelWidth * window_.scale(), kPanelShare * window_.framebuffer_size().x));
}

/// The picture has what the panel leaves of the window.
void Viewer::fit_picture() {
  const dvec2 window = window_.framebuffer_size();
  const dvec2 size(std::max(1.0, window.x - panel_width()), window.y);
  if (size == model_.size()) return;
  model_.resize(size);
  change_picture();
}

void Viewer::paint() {
  const dvec2 window = window_.framebuffer_size();
  if (window.x < 1 || window.y < 1) {  // minimized
    to_paint_ = 0;
    return;
  }
  fit_picture();
  if (!message_.empty() && Clock::now() >= message_end_) {
    message_.clear();
    touch();
  }
  if (drawing_.is_due(Clock::now())) touch();
  if (to_paint_ == 0) return;
  --to_paint_;
  window_.begin_panel();
  if (panel_shown_) {
    panel_.show(model_, drawing_.figures(), panel_width(), window_.scale());
    if (panel_.take_change()) change_picture();
    if (const auto action = panel_.take_action()) act(*action);
  }
  show_overlay(overlay());
  draw();
  const auto begin = Clock::now();
  drawing_.show(static_cast<int>(panel_width()));
  window_.end_panel();
  window_.swap();
  showing_ += Clock::now() - begin;
  ++paints_;
}

/// A picture that cannot be drawn leaves the last one, with a message.
void Viewer::draw() {
  try {
    drawing_.draw(model_);
  } catch (...) {
    drawing_.give_up();
    say(caught_error().what());
  }
}

Overlay Viewer::overlay() {
  Overlay overlay;
  overlay.left = panel_width();
  overlay.message = message_;
  // An error that a field shows is not shown twice.
  if (model_.error() && !(panel_shown_ && panel_.has_shown_error())) {
    overlay.message = format_error(*model_.error());
  }
  if (help_shown_) overlay.help = key_help();
  const Grip grip = model_.grip();
  const auto& picked = model_.picked();
  if (picked) overlay.mark = pixel_of(grip.fitted, picked->world, grip.size);
  return overlay;
}

}  // namespace saddle
