// Animations as files that are played: GIF, MP4 and WebM, made by ffmpeg.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "base/child.h"
#include "base/image.h"
#include "base/temporary.h"

namespace saddle {

/// How much of a film's background is transparent.
enum class Alpha { None, Whole, Part };

/// A format of films. Pictures are flattened on black where it has a warning for their background.
struct VideoFormat {
  const char* name;
  /// The words that tell ffmpeg how to encode.
  std::vector<std::string> (*encoder)(Alpha alpha);
  /// All frames share a palette. The encoder's inputs are then the frames and the palette, which a
  /// first run of ffmpeg has made.
  bool has_palette = false;
  bool even_sides = false;  ///< an odd picture gets its last row or column once more
  /// Not set: the format keeps a background that is transparent.
  const char* whole_warning = nullptr;
  /// The same for a background that is half transparent.
  const char* part_warning = nullptr;
  double most_fps = std::numeric_limits<double>::infinity();  ///< frames per second
  const char* beyond_most_fps = "";  ///< what happens to a film with more of them
};

/// Repeats for ever; 256 colours for all frames. A GIF's unit of time
/// is a hundredth of a second, and players take a pause of one unit for ten: 50 frames per second.
extern const VideoFormat kGif;
/// H.264, yuv420p, which every player understands.
extern const VideoFormat kMp4;
/// VP9.
extern const VideoFormat kWebm;

struct VideoOptions {
  const VideoFormat* format = &kGif;
  int width = 0;  ///< pixels
  int height = 0;
  double fps = 30;  ///< frames per second
  Alpha alpha = Alpha::None;
};

/// A video that is being made, in a file without a name: nothing is left of it if it is not kept.
class Video {
 public:
  /// Starts ffmpeg. Throws Error (Machine) if it is missing.
  explicit Video(const VideoOptions& options);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// In which way it is not what was asked for.
  std::optional<std::string> warning() const;

  /// The next frame, of the video's size. Throws Error (Machine), with its last words, if ffmpeg
  /// has ended.
  void add(const Image& frame);

  /// No more frames: waits for ffmpeg. Throws Error (Machine), with its last words, if it fails or
  /// writes nothing.
  void finish();

  /// The whole file. After finish().
  void write(std::ostream& out) const { file_.copy_to(out); }

 private:
  struct Palette;

  VideoOptions options_;
  UnnamedFile file_;
  std::unique_ptr<Palette> palette_;  ///< with its frames, for formats that have one
  std::optional<Child> ffmpeg_;
};

}  // namespace saddle
