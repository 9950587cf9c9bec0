#include "view/picture/saver.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/file.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;

/// An empty folder that is the current one.
class SavedScenes : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "saddle-saver-XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    before_ = fs::current_path();
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }

 private:
  fs::path folder_;
  fs::path before_;
};

TEST_F(SavedScenes, NeverReplaceAFile) {
  Scene scene;
  scene.title = "a/b";
  scene.surfaces.emplace_back().z = "u";
  EXPECT_EQ(save_scene(scene), "a-b.toml");
  const std::string first = read_file("a-b.toml");
  scene.surfaces[0].z = "v^2";
  EXPECT_EQ(save_scene(scene), "a-b-2.toml");
  EXPECT_EQ(save_scene(scene), "a-b-3.toml");
  EXPECT_EQ(read_file("a-b.toml"), first);
  EXPECT_NE(read_file("a-b-2.toml"), first);
}

}  // namespace
}  // namespace saddle
