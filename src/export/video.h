// Animations as files that are played: GIF, MP4 and WebM, made by ffmpeg.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "base/child.h"
#include "base/image.h"
#include "base/temporary.h"

namespace saddle {

enum class VideoFormat {
  Gif,  ///< repeats for ever; 256 colours for all frames, which ffmpeg keeps in memory
  Mp4,  ///< H.264, yuv420p, which every player understands; no transparency
  Webm  ///< VP9
};

/// Of a film's background: WebM keeps it, GIF all or nothing of it, MP4 nothing.
enum class Alpha { None, Whole, Part };

struct VideoOptions {
  VideoFormat format = VideoFormat::Gif;
  int width = 0;    ///< pixels; an odd picture gets its last row or column once more
  int height = 0;   ///< in MP4 and WebM, which know even ones alone
  double fps = 30;  ///< frames per second
  Alpha alpha = Alpha::None;
  unsigned threads = 0;  ///< 0: all
};

/// A GIF shows no more frames per second: its unit of time is a hundredth of a second, and players
/// take a pause of one unit for ten.
inline constexpr double kMostGifFps = 50;

/// A video that is being made, in a file without a name: nothing is left of it if it is not kept.
class Video {
 public:
  /// Starts ffmpeg. Throws Error (Machine) if it is missing.
  explicit Video(const VideoOptions& options);

  /// In which way it is not what was asked for.
  std::optional<std::string> warning() const;

  /// The next frame, of the video's size. Throws Error (Machine), with its last words, if ffmpeg
  /// has ended.
  void add(const Image& frame);

  /// No more frames: waits for ffmpeg. Throws Error (Machine), with its last words, if it fails.
  void finish();

  /// The whole file. After finish().
  void write(std::ostream& out) const { file_.copy_to(out); }

 private:
  bool hides_transparency() const;

  VideoOptions options_;
  UnnamedFile file_;
  Child ffmpeg_;
};

}  // namespace saddle
