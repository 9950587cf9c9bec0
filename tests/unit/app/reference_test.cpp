#include "app/reference.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/error.h"

namespace saddle {
namespace {

TEST(Reference, IsKeptByAnEqualPictureWhateverTheThreshold) {
  const Image image(8, 8);
  const std::string figures = check_against_reference(image, image, "ref.png", 0);
  EXPECT_TRUE(figures.starts_with("ref.png: error 0 (threshold 0)")) << figures;
}

TEST(Reference, IsMissedByAPictureThatDiffersByMoreThanTheThreshold) {
  const std::string path = testing::TempDir() + "ref-" + std::to_string(getpid()) + ".png";
  Image image(8, 8);
  image.pixel(3, 3)[0] = 255;
  EXPECT_THROW(check_against_reference(image, Image(8, 8), path, 0), Error);
  EXPECT_TRUE(std::filesystem::remove(path + ".diff.png"));
}

}  // namespace
}  // namespace saddle
