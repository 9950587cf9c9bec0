// How the gallery's surfaces fill their pictures: a table, and a check of the margin.
// ctest -V -R Extents prints it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/image_png.h"
#include "paths.h"
#include "scene/model/camera.h"
#include "scene/model/gallery.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
/// Tips that are thinner than a pixel are not seen up to their ends.
constexpr double kSlack = 2.5 / kHeight;

/// What is free on each side of the picture, as shares of its width and height.
struct Margins {
  double left = 1, right = 1, top = 1, bottom = 1;
};

Margins margins_of(const Image& image) {
  Margins m;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.pixel(x, y)[3] == 0) continue;
      m.left = std::min(m.left, double(x) / image.width);
      m.right = std::min(m.right, 1 - double(x + 1) / image.width);
      m.top = std::min(m.top, double(y) / image.height);
      m.bottom = std::min(m.bottom, 1 - double(y + 1) / image.height);
    }
  }
  return m;
}

TEST(Extents, OfTheGalleryTouchTheMarginOnTwoOppositeSides) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "extents.png";
  std::printf("margins in percent      left right   top bottom\n");
  for (const GalleryEntry& entry : gallery()) {
    if (gallery_scene(entry).camera.distance) continue;  // it has a camera of its own
    const std::string name(entry.name);
    const std::string command =
        program_path() + " " + name +
        " --background transparent --grid off --antialias 4 -q -s 320x240 -o " + file.string();
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const Margins m = margins_of(read_png(file.string()).image);
    std::printf("%-22s %5.1f %5.1f %5.1f %5.1f\n", name.c_str(), 100 * m.left, 100 * m.right,
                100 * m.top, 100 * m.bottom);
    const auto touches = [](double margin) { return margin < kPictureMargin + kSlack; };
    EXPECT_TRUE((touches(m.left) && touches(m.right)) || (touches(m.top) && touches(m.bottom)))
        << name;
    for (const double margin : {m.left, m.right, m.top, m.bottom}) {
      EXPECT_GT(margin, kPictureMargin - kSlack) << name;
    }
  }
}

}  // namespace
}  // namespace saddle
