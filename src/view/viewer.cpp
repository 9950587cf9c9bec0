// The loop: wait, take what happened, change the model, draw what has changed. Nothing is drawn
// while nothing happens.
#include "view/viewer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/image_png.h"
#include "render/canvas.h"
#include "render/picture_in_tiles.h"
#include "scene/command_text.h"
#include "scene/scene_file.h"
#include "view/axes.h"
#include "view/marks.h"
#include "view/overlay.h"
#include "view/panel.h"
#include "view/window.h"

namespace saddle {
namespace {

using Clock = Model::Clock;

/// At most, in pixels of the user's, and as a share of the window.
constexpr double kPanelWidth = 280;
constexpr double kPanelShare = 0.45;

/// While something moves, a picture that takes longer than this is drawn with one sample per pixel;
/// the finer one follows when it has rested for so long.
constexpr double kSmoothMs = 20;
constexpr std::chrono::milliseconds kRest{120};

/// How often the watched file is looked at.
constexpr std::chrono::milliseconds kLook{200};

/// Frames after the last event, in which the panel comes to rest.
constexpr int kSettlingFrames = 3;

constexpr std::chrono::seconds kMessageTime{4};

/// Of the normals that are shown, as a share of the surface's size.
constexpr double kNormalLength = 0.03;

double seconds_until(Clock::time_point time) {
  return std::max(0.0, std::chrono::duration<double>(time - Clock::now()).count());
}

/// The least time there is for a file that is not there just now.
std::filesystem::file_time_type last_write(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto time = std::filesystem::last_write_time(path, ignored);
  return ignored ? std::filesystem::file_time_type::min() : time;
}

/// "torus.png", or the first of "torus-2.png" ... that does not exist.
std::filesystem::path free_name(const std::string& title, const std::string& extension) {
  std::string stem;
  for (const char c : title) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    stem += plain ? c : '-';
  }
  if (stem.empty()) stem = "saddle";
  std::filesystem::path path = stem + extension;
  for (int i = 2; std::filesystem::exists(path); ++i) {
    path = stem + "-" + std::to_string(i) + extension;
  }
  return path;
}

/// What the left or the right button holds.
struct Drag {
  enum class Kind { Turn, Move };
  Kind kind = Kind::Turn;
  int button = 0;
  Grip grip;
  dvec2 from{0, 0};
  dvec3 held{0, 0, 0};
};

class Viewer {
 public:
  explicit Viewer(ViewerSetup setup)
      : verbose_(setup.verbose),
        watched_(setup.watched),
        written_(last_write(watched_)),
        window_(setup.scene.title, setup.scene.picture.width + static_cast<int>(kPanelWidth),
                setup.scene.picture.height),
        model_(std::move(setup), Window::wake) {}

  void run() {
    while (!closing_ && !window_.is_to_close()) {
      window_.wait(patience());
      const auto begin = Clock::now();
      for (const Event& event : window_.take_events()) handle(event);
      if (model_.take_result()) take_meshes();
      model_.pass(Clock::now());
      look_at_file();
      if (window_.take_damage()) touch();
      paint();
      busy_ += Clock::now() - begin;
    }
    if (verbose_) say_what_it_took();
  }

 private:
  void say_what_it_took() const {
    const auto ms = [](Clock::duration d) {
      return std::chrono::duration<double, std::milli>(d).count();
    };
    std::cerr << "viewer: " << figures_.frames << " pictures, " << paints_ << " frames, "
              << ms(drawing_) / static_cast<double>(std::max<std::size_t>(1, figures_.frames))
              << " ms in OpenGL for a picture, " << ms(busy_ - drawing_ - showing_)
              << " ms outside of it in all, " << 100 * ms(busy_ - drawing_ - showing_) / ms(busy_)
              << " %\n";
  }

  // --- what happens ------------------------------------------------------------------------------

  /// How long the loop may sleep; nothing: until something happens.
  std::optional<double> patience() const {
    if (to_paint_ > 0 || window_.has_events()) return 0.0;
    std::optional<double> seconds;
    const auto at_most = [&](Clock::time_point time) {
      seconds = std::min(seconds.value_or(1e9), seconds_until(time));
    };
    if (const auto next = model_.next_pass()) at_most(*next);
    if (coarse_) at_most(moved_ + kRest);
    if (!message_.empty()) at_most(message_end_);
    if (!watched_.empty()) at_most(looked_ + kLook);
    return seconds;
  }

  void touch() { to_paint_ = kSettlingFrames; }

  void change_picture() {
    stale_ = true;
    moved_ = Clock::now();
    touch();
  }

  void say(const std::string& text) {
    message_ = text;
    message_end_ = Clock::now() + kMessageTime;
    touch();
  }

  void handle(const Event& event) {
    touch();
    switch (event.kind) {
      case Event::Kind::Press:
        return press(event);
      case Event::Kind::Release:
        if (drag_ && drag_->button == event.button) drag_.reset();
        return;
      case Event::Kind::Move:
        return move(event);
      case Event::Kind::Scroll:
        return scroll(event);
      case Event::Kind::Character:
      case Event::Kind::KeyDown:
        return key(event.key);
      case Event::Kind::KeyUp:
        return;
    }
  }

  dvec2 in_picture(const dvec2& place) const { return {place.x - panel_width(), place.y}; }

  bool is_over_picture(const Event& event) const {
    return event.place.x >= panel_width() && !is_popup_open();
  }

  void press(const Event& event) {
    if (!is_over_picture(event)) return;
    leave_fields();
    if (event.twice) return pick(in_picture(event.place));
    Drag drag;
    drag.kind = event.button == 0 && !event.shift ? Drag::Kind::Turn : Drag::Kind::Move;
    drag.button = event.button;
    drag.grip = model_.grip();
    drag.from = in_picture(event.place);
    if (drag.kind == Drag::Kind::Move) drag.held = model_.under(drag.from);
    drag_ = drag;
  }

  void move(const Event& event) {
    if (!drag_) return;
    const dvec2 to = in_picture(event.place);
    const Drag& d = *drag_;
    if (d.kind == Drag::Kind::Move) {
      model_.look_through(moved(d.grip, d.held, d.from, to));
    } else if (model_.turntable) {
      model_.look_through(turned_on_table(d.grip, model_.table_up, d.from, to));
    } else {
      model_.look_through(turned_on_ball(d.grip, d.from, to));
    }
    change_picture();
  }

  void scroll(const Event& event) {
    if (!is_over_picture(event)) return;
    const dvec3 fixed = model_.under(in_picture(event.place));
    model_.look_through(
        zoomed(model_.grip(), fixed, zoom_factor(event.notches), model_.surface_size()));
    drag_.reset();  // it holds a camera from before
    change_picture();
  }

  void pick(const dvec2& pixel) {
    model_.pick(pixel);
    if (model_.picked()) std::cout << describe(*model_.picked()) << std::endl;
  }

  void key(const std::string& name) {
    const bool in_field = is_text_wanted();
    const KeyBinding* const binding = find_key(name);
    if (binding == nullptr || in_field || is_popup_open()) return;
    try {
      act(binding->action);
    } catch (const Error& error) {
      say(error.what());
    }
    change_picture();
  }

  void act(Action action) {
    if (model_.act(action)) return;
    switch (action) {
      case Action::SavePicture:
        return save_picture();
      case Action::SaveScene:
        return save_scene();
      case Action::Panel:
        panel_shown_ = !panel_shown_;
        return;
      case Action::Help:
        help_shown_ = !help_shown_;
        return;
      case Action::Normals:
        normals_ = !normals_;
        return make_marks();
      case Action::Axes:
        axes_ = !axes_;
        return make_marks();
      case Action::CopyCommand: {
        const auto text = command_text(model_.scene_to_save());
        if (text) window_.set_clipboard(*text);
        return say(text ? "copied the command" : "only a scene file can say this: press C");
      }
      case Action::CopyScene:
        window_.set_clipboard(write_scene(model_.scene_to_save()));
        return say("copied the scene");
      case Action::Quit:
        closing_ = true;
        return;
      default:
        return;
    }
  }

  void save_picture() {
    const Scene scene = model_.scene_to_save();
    model_.mesh_now(scene);
    take_meshes();
    const Grip grip = model_.grip();
    renderer_.remove_marks();  // the scene's picture, nothing else
    const Image image = draw_image(
        renderer_, scene, grip.fitted,
        {static_cast<int>(grip.size.x), static_cast<int>(grip.size.y), scene.picture.antialias});
    make_marks();
    const auto path = free_name(scene.title, ".png");
    write_file_whole(path, [&](std::ostream& out) {
      write_png(out, image, {{kSceneKeyword, write_scene(scene)}});
    });
    say("saved " + path.string());
  }

  void save_scene() {
    const auto path = free_name(model_.scene().title, ".toml");
    const std::string text = write_scene(model_.scene_to_save());
    write_file_whole(path, [&](std::ostream& out) { out << text; });
    say("saved " + path.string());
  }

  /// Uploads those meshes that are not on the GPU yet.
  void take_meshes() {
    const auto& meshes = model_.meshes();
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (i < uploaded_.size() && uploaded_[i] == meshes[i]) continue;
      renderer_.set_mesh(i, meshes[i]->mesh);
    }
    renderer_.keep_meshes(meshes.size());
    uploaded_ = meshes;
    make_marks();
    change_picture();
  }

  /// Normals and axes, if they are wanted.
  void make_marks() {
    renderer_.remove_marks();
    labels_.clear();
    if (!normals_ && !axes_) return;
    Mesh marks;
    if (normals_) {
      for (const auto& surface : model_.meshes()) {
        append_normal_marks(surface->mesh, kNormalLength * model_.surface_size(), marks);
      }
    }
    if (axes_) labels_ = append_axes(model_.bounds(), marks);
    if (!marks.lines.empty()) renderer_.set_marks(marks);
  }

  /// Editors write a file in place or put another one there: its time tells of both.
  void look_at_file() {
    if (watched_.empty() || Clock::now() < looked_ + kLook) return;
    looked_ = Clock::now();
    const auto written = last_write(watched_);
    if (written == written_) return;
    written_ = written;
    model_.reload();
    touch();
  }

  // --- what is shown -----------------------------------------------------------------------------

  double panel_width() const {
    if (!panel_shown_) return 0;
    return std::floor(
        std::min(kPanelWidth * window_.scale(), kPanelShare * window_.framebuffer_size().x));
  }

  void paint() {
    const dvec2 window = window_.framebuffer_size();
    if (window.x < 1 || window.y < 1) return;  // minimized
    const dvec2 size(std::max(1.0, window.x - panel_width()), window.y);
    if (size != model_.size()) {
      model_.resize(size);
      change_picture();
    }
    if (coarse_ && Clock::now() >= moved_ + kRest) change_picture_to_fine();
    if (to_paint_ == 0) return;
    --to_paint_;
    window_.begin_panel();
    if (panel_shown_) {
      panel_.show(model_, figures_, panel_width(), window_.scale());
      if (panel_.take_change()) change_picture();
    }
    show_overlay(overlay());
    if (stale_) draw();
    const auto begin = Clock::now();
    canvas_.show(static_cast<int>(panel_width()), 0);
    window_.end_panel();
    window_.swap();
    showing_ += Clock::now() - begin;
    ++paints_;
  }

  void change_picture_to_fine() {
    stale_ = true;
    rested_ = true;
    touch();
  }

  void draw() {
    const auto begin = Clock::now();
    const bool fast_enough = figures_.frame_ms * (per_side_ == 1 ? 4 : 1) <= kSmoothMs;
    const int most = std::min(2, model_.scene().picture.antialias);
    per_side_ = rested_ || fast_enough ? most : 1;
    coarse_ = per_side_ < most;
    PictureSettings picture = model_.scene().picture;
    picture.antialias = per_side_;
    canvas_.draw(renderer_, model_.drawn_scene(), model_.grip().fitted,
                 {.lines = model_.grid, .wireframe = model_.wireframe}, picture);
    const auto passed = Clock::now() - begin;
    drawing_ += passed;
    figures_.frame_ms = std::chrono::duration<double, std::milli>(passed).count();
    ++figures_.frames;
    stale_ = false;
    rested_ = false;
  }

  Overlay overlay() {
    if (!message_.empty() && Clock::now() >= message_end_) message_.clear();
    Overlay overlay;
    overlay.left = panel_width();
    overlay.message = message_;
    // What a field shows is not said twice.
    if (model_.error() && !(panel_shown_ && panel_.has_shown_error())) {
      overlay.message = format_error(*model_.error());
    }
    if (help_shown_) overlay.help = key_help();
    const Grip grip = model_.grip();
    for (const AxisLabel& label : labels_) {
      if (is_in_front(grip, label.place)) {
        overlay.labels.push_back({pixel_of(grip, label.place), label.text});
      }
    }
    const auto& picked = model_.picked();
    if (picked && is_in_front(grip, picked->world)) {
      overlay.mark = pixel_of(grip, picked->world);
    }
    return overlay;
  }

  bool verbose_;
  std::filesystem::path watched_;
  std::filesystem::file_time_type written_;  ///< when that file was, as far as is known
  Clock::time_point looked_;
  Window window_;
  Renderer renderer_;
  Canvas canvas_;
  Panel panel_;
  Figures figures_;
  std::size_t paints_ = 0;
  Clock::duration busy_{};     ///< from what happened to the screen
  Clock::duration drawing_{};  ///< of that, pictures
  Clock::duration showing_{};  ///< and copying them to the window, with the panel
  std::optional<Drag> drag_;
  std::vector<std::shared_ptr<const SurfaceMesh>> uploaded_;
  bool closing_ = false;
  bool panel_shown_ = true;
  bool help_shown_ = false;
  bool normals_ = false;
  bool axes_ = false;
  std::vector<AxisLabel> labels_;
  int to_paint_ = kSettlingFrames;  ///< frames that the window still needs
  bool stale_ = true;               ///< the picture is not what is to be seen
  bool rested_ = false;             ///< the next picture may take its time
  bool coarse_ = false;             ///< the picture has fewer samples than it should
  int per_side_ = 1;
  Clock::time_point moved_;
  std::string message_;
  Clock::time_point message_end_;
  Model model_;  // the last member: its worker wakes the window
};

}  // namespace

void run_viewer(ViewerSetup setup) {
  Viewer(std::move(setup)).run();
}

}  // namespace saddle
