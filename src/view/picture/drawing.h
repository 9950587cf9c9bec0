// The picture in the window: what is on the GPU, when it is drawn anew, and how finely.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/picture/canvas.h"
#include "render/picture/renderer.h"
#include "view/model/model.h"

namespace saddle {

/// The cost of drawing.
struct Figures {
  std::size_t frames = 0;             ///< pictures drawn so far
  double frame_ms = 0;                ///< the last one, from scene to finished pixels
  std::vector<std::string> warnings;  ///< in which ways it is not what was asked for
};

/// Needs the window's context from the first to the last of its calls.
class Drawing {
 public:
  using Clock = std::chrono::steady_clock;

  /// Uploads those meshes that are not on the GPU yet.
  void take_meshes(const Model& model);

  void show_normals(const Model& model, bool shown);
  bool has_normals() const { return normals_; }

  /// The visible picture has changed.
  void change();

  /// A finer picture of what rests by now is due.
  bool is_due(Clock::time_point now) const { return coarse_ && now >= moved_ + kRest; }
  /// When it will be.
  std::optional<Clock::time_point> due() const;
  /// The picture is what it should be.
  bool is_at_rest() const { return !stale_ && !coarse_; }

  /// Draws the picture if it is not what it should be and its meshes are on the GPU.
  void draw(const Model& model);
  /// Keeps the picture that is there until another change.
  void give_up() { stale_ = coarse_ = false; }
  /// Copies it to the window, its left side at pixel x.
  void show(int x) const { canvas_.show(x, 0); }
  /// The picture's pixels.
  Image read() const { return canvas_.read(); }

  const Figures& figures() const { return figures_; }
  Clock::duration spent() const { return spent_; }  ///< on drawing

 private:
  /// While something moves, a picture that takes long is drawn with one sample per pixel; the finer
  /// one follows when it has rested for so long.
  static constexpr std::chrono::milliseconds kRest{120};

  void make_marks(const Model& model);

  Renderer renderer_;
  Canvas canvas_;
  std::vector<std::shared_ptr<const Tessellation>> uploaded_;
  bool exact_ = false;  ///< with what exact normals need
  bool normals_ = false;
  bool stale_ = true;    ///< the picture is not what is to be seen
  bool coarse_ = false;  ///< it has fewer samples than it should
  int per_side_ = 1;
  Clock::time_point moved_;
  Figures figures_;
  Clock::duration spent_{};
};

}  // namespace saddle
