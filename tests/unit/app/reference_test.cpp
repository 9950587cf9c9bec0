#include "app/report/reference.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "base/image_png.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

class Reference : public testing::Test {
 protected:
  /// A black picture in a file.
  void SetUp() override {
    std::ofstream out(path_, std::ios::binary);
    write_png(out, Image(8, 8));
  }

  ReferenceCheck check_of(const Image& picture) const {
    ReferenceCheck check(path_, 0);
    check.take(picture);
    return check;
  }

  TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "ref.png").string();
};

TEST_F(Reference, IsKeptByAnEqualPictureWhateverTheThreshold) {
  const std::string figures = check_of(Image(8, 8)).compare();
  EXPECT_TRUE(figures.starts_with(path_ + ": difference 0, threshold 0")) << figures;
}

TEST_F(Reference, IsMissedByAPictureThatDiffersByMoreThanTheThreshold) {
  Image image(8, 8);
  image.pixel(3, 3)[3] = 255;
  EXPECT_THROW(check_of(image).compare(), Error);
  EXPECT_TRUE(std::filesystem::exists(path_ + ".diff.png"));
}

}  // namespace
}  // namespace saddle
