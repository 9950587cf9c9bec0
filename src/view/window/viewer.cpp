#include "view/window/viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/format.h"
#include "base/standard_streams.h"
#include "view/panel/fields.h"
#include "view/panel/widgets.h"
#include "view/window/display_end.h"

namespace saddle {
namespace {

using Clock = Model::Clock;

/// At most, in pixels of the user's, and as a share of the window.
constexpr double kPanelWidth = 320;
constexpr double kPanelShare = 0.45;

/// How often the watched file is looked at.
constexpr std::chrono::milliseconds kLook{200};

/// Frames after the last event, in which the panel comes to rest.
constexpr int kSettlingFrames = 3;
/// Frames until a field that is to get the keyboard has it: that of the key, and those in which the
/// toolkit finds the field and enters it.
constexpr int kFramesToEnter = 4;

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
      panel_(setup.quiet, [this](Action action) { return can(action); }),
      start_shown_(setup.start),
      to_paint_(kSettlingFrames),
      exporter_(setup.program, setup.threads, Window::wake),
      model_(std::move(setup), Window::wake) {
  if (start_shown_) begin_thumbnails();
  has_work_ = session_.left_work().has_value();
  if (has_work_ && !start_shown_) say("the last time ended with unsaved work: File, Unsaved work");
}

void Viewer::run() {
  display_gone_ = [this] { tell_display_gone(); };
  call_when_display_goes(display_gone_);
  while (!is_to_end()) step();
  keep_work(true);
  if (verbose_) print_times();
}

/// Keeps work, as the process ends now.
void Viewer::tell_display_gone() {
  std::string text = "the display has gone";
  try {
    keep_work(true);
    if (!not_kept_.empty()) text += ", and unsaved work is lost: " + not_kept_;
  } catch (...) {
    text += ", and unsaved work is lost";
  }
  tell(Error(Status::Machine, text));
}

void Viewer::step() {
  window_.wait(patience());
  const auto begin = Clock::now();
  try {
    react();
  } catch (...) {
    say(caught_error().what());
  }
  if (window_.take_damage()) {
    is_damaged_ = true;
    touch();
  }
  if (model_.meshing_seconds()) touch();
  keep_work(false);
  paint();
  tidy();
  busy_ += Clock::now() - begin;
}

/// To events, to meshes and pictures that are finished, to the time and to the watched file.
void Viewer::react() {
  take_events();
  if (model_.take_result()) {
    touch();
    drawing_.take_meshes(model_);
  }
  if (const auto news = model_.take_news()) say(*news);
  if (const auto news = exporter_.pass()) say(*news);
  model_.pass(Clock::now());
  look_at_file();
}

/// Letters behind the key that opens a list are the list's: they wait for its field.
void Viewer::take_events() {
  if (is_text_wanted()) to_enter_ = 0;
  if (is_panel_behind_ || to_enter_ > 0) {
    if (window_.has_events()) to_paint_ = std::max(to_paint_, 1);
    return;
  }
  for (const Event& event : window_.take_events()) {
    const bool was_stale = drawing_.is_stale();
    if (!is_taken_from_panel(event)) window_.tell_panel(event);
    handle(event);
    if (event.kind == Event::Kind::Move || event.kind == Event::Kind::Scroll) continue;
    is_panel_behind_ = true;
    // A key that changes the picture is answered there.
    has_key_ |= event.kind != Event::Kind::KeyUp && (was_stale || !drawing_.is_stale());
  }
  is_panel_behind_ |= window_.has_events();  // those that do not fit into the same frame
}

/// A file that was asked for is waited for; who asks to end once more does not want to.
bool Viewer::is_to_end() {
  if (window_.take_close_request()) act(Action::Quit);
  return closing_ && (insisting_ || !exporter_.is_busy());
}

bool Viewer::is_at_rest() const {
  return to_paint_ == 0 && !window_.has_events() && !model_.is_meshing() && !model_.next_pass() &&
         (start_shown_ ? !thumbnails_ || thumbnails_->are_all_taken() : drawing_.is_at_rest()) &&
         !exporter_.is_busy();
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
  if (tidy_at_ && is_at_rest()) at_most(*tidy_at_);
  if (kept_ != model_.history().version()) at_most(changed_ + kKeep);
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
      return hand_.release(model_, event.button);
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
    case Event::Kind::Drop:
      return open(event.key);
  }
}

bool Viewer::is_over_picture(const Event& event) const {
  return event.place.x >= panel_width() && !is_popup_open() && !start_shown_;
}

void Viewer::press(const Event& event) {
  if (!is_over_picture(event)) return;
  leave_fields();
  is_typing_ = false;
  const dvec2 pixel = in_picture(event.place);
  if (!event.twice) return hand_.press(model_, pixel, event.button, event.shift);
  model_.pick(pixel);
  if (!model_.picked()) return;
  panel_.reveal_picked();
  print_lines(std::array{describe(*model_.picked())});
}

/// Escape closes the uppermost thing alone; a field keeps the keyboard after Return.
bool Viewer::is_taken_from_panel(const Event& event) const {
  if (event.kind != Event::Kind::KeyDown) return false;
  if (event.key == "Escape") return help_shown_ || is_popup_open();
  return event.key == "Return" && is_text_wanted() && !is_editing_number();
}

/// Letters are keys only while the picture has the keyboard.
void Viewer::key(const std::string& name) {
  const ActionRow* const row = find_key(name);
  const bool is_in_picture = !is_text_wanted() && !is_popup_open() && !start_shown_;
  if (!is_in_picture) {
    is_typing_ = is_typing_ || is_text_wanted();
    if (name == "Return" && !is_editing_number()) panel_.confirm(model_);
    if (row == nullptr || !works_while_typing(row->action)) return;
  }
  if (name == "Tab" && model_.view().panel) {
    panel_.enter();
    to_enter_ = kFramesToEnter;
  }
  if (row == nullptr) return;
  if (is_typing_ && types_character(*row)) {
    return say("click into the picture, or press Escape, to use its keys");
  }
  act(row->action);
  if (chooser_.is_open()) to_enter_ = kFramesToEnter;
}

/// Editors write a file in place or put another one there: its time tells of both.
void Viewer::look_at_file() {
  if (watched_.empty() || Clock::now() < looked_ + kLook) return;
  looked_ = Clock::now();
  const auto written = last_write(watched_);
  // An editor that puts another file in its place may have removed it a moment ago.
  const bool is_gone = written == std::filesystem::file_time_type::min();
  const bool was_gone = std::exchange(was_gone_, is_gone);
  if (written == written_ || (is_gone && !was_gone)) return;
  written_ = written;
  model_.reload();
  touch();
}

// --- what is shown
// ---------------------------------------------------------------------------------

double Viewer::panel_width() const {
  if (!model_.view().panel || start_shown_) return 0;
  return std::floor(
      std::min(kPanelWidth * window_.scale(), kPanelShare * window_.framebuffer_size().x));
}

/// The picture has what the panel leaves of the window. True: that is another size.
bool Viewer::fit_picture() {
  const dvec2 window = window_.framebuffer_size();
  const dvec2 size(std::max(1.0, window.x - panel_width()), window.y);
  if (size == model_.size()) return false;
  model_.resize(size);
  change_picture();
  return true;
}

void Viewer::paint() {
  const dvec2 window = window_.framebuffer_size();
  if (window.x < 1 || window.y < 1) {  // minimized
    to_paint_ = to_enter_ = 0;
    is_panel_behind_ = has_key_ = false;
    return;
  }
  if (!start_shown_ && fit_picture()) has_key_ = false;
  if (!start_shown_ && thumbnails_) thumbnails_->pause();
  if (!message_.empty() && Clock::now() >= message_end_) {
    message_.clear();
    touch();
  }
  if (!(start_shown_ ? go_on_with_thumbnails() : go_on_with_picture())) return;
  --to_paint_;
  // The toolkit shows a list or a help in its second frame: the first finds out how large it is.
  if (const bool answers_key = has_key_; !show_frame() && answers_key) show_frame();
}

/// False: the screen has it. The panel needs some frames to come to rest.
bool Viewer::show_frame() {
  if (std::exchange(title_, model_.scene().title) != title_) window_.set_title(title_);
  window_.set_light(!start_shown_ && model_.scene().theme != Theme::Dark);
  window_.begin_panel();
  is_panel_behind_ = has_key_ = false;
  if (to_enter_ > 0) --to_enter_;
  show_panels();
  show_overlay(overlay());
  const bool is_new = window_.is_panel_new() || drawing_.has_news() || is_damaged_;
  if (!is_new) return false;
  is_damaged_ = false;
  const auto begin = Clock::now();
  drawing_.end_frame(window_.end_panel());
  window_.swap();
  showing_ += Clock::now() - begin;
  ++paints_;
  return true;
}

/// Draws it and copies it to the window. True: a frame is to be shown. A key is answered first,
/// over what is there of the picture, but not twice in a row: a key that is held down does not stop
/// it.
bool Viewer::go_on_with_picture() {
  const auto begin = Clock::now();
  const bool is_behind = is_copying_ || drawing_.is_due(begin);
  was_panel_first_ = has_key_ && is_behind && !was_panel_first_;
  if (!was_panel_first_ && !is_copying_ && draw()) to_paint_ = std::max(to_paint_, 1);
  if (to_paint_ == 0) return false;
  const auto drawn = Clock::now();
  const dvec2 window = window_.framebuffer_size();
  is_copying_ = !drawing_.show(static_cast<int>(window.x), static_cast<int>(window.y),
                               static_cast<int>(panel_width()), begin + kTurn);
  showing_ += Clock::now() - drawn;
  if (is_copying_ && has_key_) to_paint_ = std::max(to_paint_, 2);  // this frame, and it
  return has_key_ || !is_copying_;
}

/// All that a hand asked of them is done after all of them are shown.
void Viewer::show_panels() {
  if (start_shown_) {
    show_start();
  } else if (model_.view().panel) {
    panel_.show(model_, drawing_.figures(), panel_width());
    if (panel_.take_change()) {
      drawing_.change_with_meshes();
      touch();
    }
  }
  chooser_.show(panel_width(), panel_.is_confirmed());
  panel_.end_frame();
  if (const auto action = panel_.take_action()) act(*action);
}

/// Goes on with the picture; true if it is another. One that cannot be drawn leaves the last one,
/// with a message.
bool Viewer::draw() {
  try {
    return drawing_.draw(model_);
  } catch (...) {
    drawing_.give_up();
    say(caught_error().what());
    return true;
  }
}

Overlay Viewer::overlay() {
  Overlay overlay;
  overlay.left = panel_width();
  overlay.message = message_;
  // An error that the panel shows is not shown twice.
  if (model_.error() && !model_.view().panel) overlay.message = window_text(*model_.error());
  if (help_shown_) overlay.help = key_help();
  const auto& picked = model_.picked();
  if (!picked || start_shown_) return overlay;
  const Grip grip = model_.grip();
  overlay.mark = pixel_of(grip.fitted, picked->world, grip.size);
  overlay.is_mark_hidden = model_.is_picked_hidden();
  return overlay;
}

}  // namespace saddle
