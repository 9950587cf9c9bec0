// The picture in the window: what is on the GPU, when it is drawn anew, and how finely. Nothing
// here takes long: what moves is drawn as coarsely as it must be, what rests part by part.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/picture/canvas.h"
#include "render/picture/renderer.h"
#include "view/model/model.h"
#include "view/picture/window_buffer.h"

namespace saddle {

/// A step of drawing a picture, and of copying it to the window: a key may wait for it. Both count
/// from where the step begins, which has one turn for them together.
inline constexpr std::chrono::milliseconds kTurn{8};

/// The cost of drawing.
struct Figures {
  std::size_t frames = 0;             ///< pictures drawn so far
  std::optional<double> moving_ms;    ///< of the last one that was drawn while something moved
  std::vector<std::string> warnings;  ///< in which ways it is not what was asked for
};

/// Needs the window's context from the first to the last of its calls.
class Drawing {
 public:
  using Clock = std::chrono::steady_clock;

  Drawing();

  /// Uploads those meshes that are not on the GPU yet.
  void take_meshes(const Model& model);

  /// The visible picture has changed.
  void change();
  /// By an edit: it is drawn with the meshes of that, unless these take long.
  void change_with_meshes();

  /// The picture is not what it should be, and draw() can go on at once.
  bool is_due(Clock::time_point now) const;
  /// When it will be able to, if that is later.
  std::optional<Clock::time_point> due() const;
  /// The picture is what it should be.
  bool is_at_rest() const { return stage_ == Stage::Done; }
  /// It is another picture that should be seen.
  bool is_stale() const { return stage_ == Stage::Stale; }
  /// Parts of it are.
  bool is_refining() const { return stage_ == Stage::Refining; }

  /// Goes on for some hundredths of a second; true if there is something new to show.
  bool draw(const Model& model);
  /// Keeps the picture that is there until another change.
  void give_up() { stage_ = Stage::Done; }
  /// Copies to a window of this size, at the right of `left`, what that does not have yet, until
  /// `end`; true: it has all of it.
  bool show(int width, int height, int left, Clock::time_point end);
  /// The window's frame is drawn, with something over the picture in `covered`, and is shown.
  void end_frame(std::span<const PixelRect> covered) { buffer_.end_frame(covered); }
  /// The window has something of the picture that the screen has not.
  bool has_news() const { return buffer_.has_news(); }
  /// The window has something else in place of the picture.
  void forget_window() { buffer_.damage_all(); }
  /// The picture's pixels.
  Image read() const { return canvas_.read(); }

  const Figures& figures() const { return figures_; }
  Clock::duration spent() const { return spent_; }  ///< on drawing

 private:
  /// A picture that is coarse becomes fine once nothing has moved for so long.
  static constexpr std::chrono::milliseconds kRest{120};
  /// Meshes of an edit that take longer are not waited for. Until then the last picture is as good
  /// as another one of the last meshes, and the processors are the mesher's.
  static constexpr std::chrono::milliseconds kMeshesSoon{150};

  enum class Stage {
    Stale,     ///< the picture is not what is to be seen
    Coarse,    ///< it has fewer samples than it should
    Refining,  ///< parts of it, from the top, have as many
    Done
  };

  /// The next part of the picture to be refined is at (x, y).
  struct Cursor {
    int x = 0, y = 0;
    bool is_begun = false;  ///< it has some of its see-through layers
    double slowest_ms = 0;  ///< of the turns of its row so far
  };

  void make_marks(const Model& model);
  void draw_whole(const Model& model);
  void adapt(double milliseconds);
  bool refine(const Model& model);
  PixelRect next_part(const PictureSettings& picture) const;
  void advance(const PixelRect& part, const PictureSettings& picture);
  int finest(const Model& model) const;

  Renderer renderer_;
  Canvas canvas_;
  WindowBuffer buffer_;
  std::vector<std::shared_ptr<const SightedMesh>> uploaded_;
  bool exact_ = false;  ///< with what exact normals need
  bool has_marks_ = false;
  bool is_new_ = true;  ///< shaders may have to be compiled
  Stage stage_ = Stage::Stale;
  double per_side_ = 0;  ///< samples of what moves, per pixel and side; 0: none was drawn yet
  double pixels_ = 0;    ///< of the last picture that was drawn at once
  Cursor cursor_;
  int part_side_;  ///< of a part, which is a square unless the picture ends, in pixels
  Clock::time_point moved_;
  Clock::time_point not_before_;  ///< a stale picture is not drawn
  Clock::time_point shown_;       ///< when draw() has last had something to show
  Figures figures_;
  Clock::duration spent_{};
};

}  // namespace saddle
