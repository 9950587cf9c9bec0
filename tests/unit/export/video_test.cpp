// Videos are read back with ffmpeg: colours, sizes, frames.
#include "export/pictures/video.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "export/formats/formats.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

Image plain(int width, int height, const std::array<std::uint8_t, 4>& color) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = color[i % 4];
  return image;
}

const std::array<std::array<std::uint8_t, 4>, 3> kColors = {
    {{255, 255, 128, 255}, {128, 128, 255, 255}, {200, 30, 40, 255}}};

/// `param` is each format of animations.
class VideoTest : public testing::TestWithParam<Format> {
 protected:
  void SetUp() override {
    before_ = std::signal(SIGPIPE, SIG_IGN);  // as main does
  }
  void TearDown() override { std::signal(SIGPIPE, before_); }
  std::filesystem::path path() const {
    return folder_ / ("a." + std::string(GetParam().extension));
  }

  void make(const VideoOptions& options) const {
    Video video(options);
    for (const auto& color : kColors) video.add(plain(options.width, options.height, color));
    video.finish();
    std::ofstream out(path(), std::ios::binary);
    video.write(out);
  }

  /// All frames, RGBA.
  std::string frames(const std::string& options = "") const {
    const std::string raw = folder_ / "raw";
    const std::string command = "ffmpeg -loglevel error " + options + " -i '" + path().string() +
                                "' -f rawvideo -pix_fmt rgba '" + raw + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return read_file(raw);
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
  void (*before_)(int) = nullptr;
};

TEST_P(VideoTest, HasEachFrameInItsColour) {
  make({.format = GetParam().video, .width = 64, .height = 48, .fps = 10});
  const std::string raw = frames();
  const std::size_t size = 4 * 64 * 48;
  ASSERT_EQ(raw.size(), kColors.size() * size);
  for (std::size_t k = 0; k < kColors.size(); ++k) {
    for (std::size_t c = 0; c < 4; ++c) {
      const auto value = static_cast<std::uint8_t>(raw[k * size + size / 2 + c]);
      // 16 to 235 levels of luma, rounded, and back: two levels of each colour, and the codec's
      // one. With the matrix of another standard it would be ten.
      EXPECT_NEAR(value, kColors[k][c], 4) << "frame " << k << " channel " << c;
    }
  }
}

TEST_P(VideoTest, TakesOddSizes) {
  make({.format = GetParam().video, .width = 63, .height = 47, .fps = 10});
  const std::string raw = frames();
  const std::size_t size =
      4 * static_cast<std::size_t>(GetParam().video->even_sides ? 64 * 48 : 63 * 47);
  ASSERT_EQ(raw.size(), kColors.size() * size);
  for (std::size_t k = 0; k < kColors.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {  // of the last pixel: no black border
      const auto value = static_cast<std::uint8_t>(raw[(k + 1) * size - 4 + c]);
      EXPECT_NEAR(value, kColors[k][c], 4) << "frame " << k << " channel " << c;
    }
  }
}

TEST_P(VideoTest, IsTheSameForTheSameFrames) {
  const VideoOptions options{.format = GetParam().video, .width = 64, .height = 48, .fps = 10};
  make(options);
  const std::string first = read_file(path());
  make(options);
  EXPECT_EQ(read_file(path()), first);
}

std::vector<Format> animations() {
  std::vector<Format> result;
  std::ranges::copy_if(formats(), std::back_inserter(result),
                       [](const Format& f) { return f.kind == Format::Kind::Animation; });
  return result;
}

INSTANTIATE_TEST_SUITE_P(Formats, VideoTest, testing::ValuesIn(animations()),
                         [](const auto& row) { return std::string(row.param.extension); });

std::optional<std::string> warning(const VideoFormat& format, Alpha alpha) {
  return Video({.format = &format, .width = 2, .height = 2, .alpha = alpha}).warning();
}

TEST(Video, WarnsOfTransparencyThatIsLost) {
  for (const VideoFormat* format : {&kGif, &kMp4, &kWebm}) {
    EXPECT_FALSE(warning(*format, Alpha::None)) << format->name;
  }
  EXPECT_FALSE(warning(kGif, Alpha::Whole));
  EXPECT_EQ(warning(kGif, Alpha::Part),
            "GIF has nothing half transparent: the background is mixed with black");
  EXPECT_EQ(warning(kMp4, Alpha::Whole), "MP4 has no transparency: the background is black");
  EXPECT_EQ(warning(kMp4, Alpha::Part), "MP4 has no transparency: the background is black");
  EXPECT_FALSE(warning(kWebm, Alpha::Part));
}

TEST(Video, OfMp4IsOnBlackWhereItIsTransparent) {
  Video video({.format = &kMp4, .width = 16, .height = 16, .alpha = Alpha::Whole});
  video.add(plain(16, 16, {255, 255, 255, 0}));
  video.finish();
  const std::string path = testing::TempDir() + "saddle-video-" + std::to_string(getpid()) + ".mp4";
  {
    std::ofstream out(path, std::ios::binary);
    video.write(out);
  }
  const std::string raw = path + ".raw";
  const std::string command =
      "ffmpeg -y -loglevel error -i " + path + " -f rawvideo -pix_fmt rgb24 " + raw;
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_LE(static_cast<std::uint8_t>(read_file(raw)[0]), 2);
  std::filesystem::remove(path);
  std::filesystem::remove(raw);
}

}  // namespace
}  // namespace saddle
