// Frames go to ffmpeg as raw pixels. Colours are converted by the matrix of ITU-R BT.709,
// "Parameter values for the HDTV standards", 2015, and the file says so: players that are left to
// guess shift them.
#include "export/pictures/video.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>

#include "base/error.h"
#include "base/format.h"

namespace saddle {
namespace {

constexpr const char* kName = "ffmpeg";
constexpr const char* kPackage = "ffmpeg";

/// Constant quality on the scale of x264 (0 to 51, least is best) and of VP9 (0 to 63): what is
/// called visually lossless. Smooth shading shows bands long before a camera's picture would.
constexpr const char* kMp4Quality = "18";
constexpr const char* kWebmQuality = "24";

/// Threads of ffmpeg's filters and encoders. Constant, because the encoders' bytes depend on it.
/// With drawing beside them, 48 frames of 800x600 take 3.0 s with one thread, 2.5 s with two
/// and 2.8 s with four as MP4; as WebM 5.4 s, 3.3 s and 3.3 s, on two processors.
constexpr const char* kThreads = "2";

using Words = std::vector<std::string>;

std::string yuv_filter(const std::string& pixels) {
  return "scale=out_color_matrix=bt709:out_range=tv,format=" + pixels;
}

/// A side as the format has it.
int stored(int side, const VideoFormat& format) {
  return format.even_sides ? side + side % 2 : side;
}

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// Ends the words for a codec of YUV with those for colours and container.
Words with_bt709(Words words, const Words& container) {
  append(words, {"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
                 "-color_range", "tv"});
  append(words, container);
  return words;
}

Words gif_encoder(Alpha) {
  // The palette is of all frames, so that what rests does not flicker.
  return {"-filter_complex", "[0][1]paletteuse=diff_mode=rectangle", "-loop", "0", "-f", "gif"};
}

Words mp4_encoder(Alpha) {
  return with_bt709({"-vf", yuv_filter("yuv420p"), "-c:v", "libx264", "-crf", kMp4Quality},
                    {"-movflags", "+faststart", "-f", "mp4"});
}

Words webm_encoder(Alpha alpha) {
  Words words = {"-vf",       yuv_filter(alpha == Alpha::None ? "yuv420p" : "yuva420p"),
                 "-c:v",      "libvpx-vp9",
                 "-crf",      kWebmQuality,
                 "-b:v",      "0",
                 "-row-mt",   "1",
                 "-cpu-used", "4"};
  if (alpha != Alpha::None) append(words, {"-auto-alt-ref", "0"});  // VP9 with alpha has none
  return with_bt709(std::move(words), {"-f", "webm"});
}

/// With -xerror a file whose end cannot be written is a failure, too.
const Words kProgram = {kName, "-nostdin", "-hide_banner", "-loglevel", "error", "-xerror"};

/// Frames from the pipe.
Words raw_frames(const VideoOptions& options) {
  const std::string size = std::to_string(stored(options.width, *options.format)) + "x" +
                           std::to_string(stored(options.height, *options.format));
  return {"-f", "rawvideo",   "-pixel_format",         "rgba", "-video_size",
          size, "-framerate", rounded(options.fps, 9), "-i",   "pipe:0"};
}

/// Ends the words for an output.
void append_output(Words& words, const UnnamedFile& file) {
  // No dates, no random numbers: the same frames give the same bytes.
  append(words, {"-fflags", "+bitexact", "-flags:v", "+bitexact"});
  append(words, {"-filter_threads", kThreads, "-threads", kThreads});
  append(words, {"-y", file.path()});
}

Words command(const VideoOptions& options, const UnnamedFile& file) {
  Words words = kProgram;
  append(words, raw_frames(options));
  append(words, options.format->encoder(options.alpha));
  append_output(words, file);
  return words;
}

/// With the last row and column once more where the format has no odd sides.
Image widened(const Image& image, const VideoFormat& format) {
  Image wide(stored(image.width, format), stored(image.height, format));
  for (int y = 0; y < wide.height; ++y) {
    const std::uint8_t* const row = image.pixel(0, std::min(y, image.height - 1));
    std::uint8_t* const end = std::copy_n(row, 4 * image.width, wide.pixel(0, y));
    if (wide.width > image.width) std::copy_n(end - 4, 4, end);
  }
  return wide;
}

/// On black.
Image flattened(Image image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const unsigned alpha = image.rgba[i + 3];
    if (alpha == 255) continue;
    for (std::size_t k = i; k < i + 3; ++k) {
      image.rgba[k] = static_cast<std::uint8_t>((image.rgba[k] * alpha + 127) / 255);
    }
    image.rgba[i + 3] = 255;
  }
  return image;
}

}  // namespace

/// ffmpeg makes a palette of the frames, and keeps them, without a loss, for a second look.
struct Video::Palette {
  UnnamedFile frames = {};
  UnnamedFile colors = {};

  Words first_command(const VideoOptions& options) const {
    Words words = kProgram;
    append(words, raw_frames(options));
    append(words, {"-filter_complex", "split[a][b];[a]palettegen[p]"});
    append(words, {"-map", "[p]", "-c:v", "png", "-f", "image2pipe"});
    append_output(words, colors);
    append(words, {"-map", "[b]", "-c:v", "ffv1", "-pix_fmt", "bgra", "-f", "nut"});
    append_output(words, frames);
    return words;
  }
  Words second_command(const VideoOptions& options, const UnnamedFile& file) const {
    Words words = kProgram;
    append(words, {"-f", "nut", "-i", frames.path(), "-f", "png_pipe", "-i", colors.path()});
    append(words, options.format->encoder(options.alpha));
    append_output(words, file);
    return words;
  }
};

constexpr VideoFormat kGif = {
    .name = "GIF",
    .encoder = gif_encoder,
    .has_palette = true,
    .part_warning = "GIF has nothing half transparent: the background is mixed with black",
    .most_fps = 50,
    .beyond_most_fps = "players slow faster ones down to 10"};

// MP4 and WebM store chroma for blocks of 2x2 pixels.
constexpr VideoFormat kMp4 = {.name = "MP4",
                              .encoder = mp4_encoder,
                              .even_sides = true,
                              .whole_warning = "MP4 has no transparency: the background is black",
                              .part_warning = "MP4 has no transparency: the background is black"};

constexpr VideoFormat kWebm = {.name = "WebM", .encoder = webm_encoder, .even_sides = true};

Video::Video(const VideoOptions& options) : options_(options) {
  if (!options.format->has_palette) {
    ffmpeg_.emplace(command(options, file_), kPackage, std::array{file_.descriptor()});
    return;
  }
  palette_ = std::make_unique<Palette>();
  ffmpeg_.emplace(palette_->first_command(options), kPackage,
                  std::array{palette_->frames.descriptor(), palette_->colors.descriptor()});
}

Video::~Video() = default;

std::optional<std::string> Video::warning() const {
  const VideoFormat& format = *options_.format;
  const char* const text = options_.alpha == Alpha::Whole  ? format.whole_warning
                           : options_.alpha == Alpha::Part ? format.part_warning
                                                           : nullptr;
  if (text == nullptr) return std::nullopt;
  return text;
}

void Video::add(const Image& frame) {
  assert(frame.width == options_.width && frame.height == options_.height);
  Image stored = widened(frame, *options_.format);
  if (warning()) stored = flattened(std::move(stored));
  const auto* const bytes = reinterpret_cast<const char*>(stored.rgba.data());
  if (ffmpeg_->feed({bytes, stored.rgba.size()})) return;
  const UnnamedFile& written = palette_ ? palette_->frames : file_;
  written.check_written(kName, [this] { ffmpeg_->finish(); });
  throw Error(Status::Machine, "ffmpeg wants no more frames");
}

void Video::finish() {
  if (palette_) {
    palette_->frames.check_written(kName, [this] { ffmpeg_->finish(); });
    ffmpeg_.emplace(palette_->second_command(options_, file_), kPackage,
                    std::array{palette_->frames.descriptor(), palette_->colors.descriptor(),
                               file_.descriptor()});
  }
  file_.check_written(kName, [this] { ffmpeg_->finish(); });
}

}  // namespace saddle
