#include "view/model/files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/file.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

TEST(Files, AreFoundByTheBeginningsOfTheirNames) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path().string() + "/";
  std::filesystem::create_directory(folder + "tori");
  for (const char* name : {"torus.toml", "Tower.png", "notes.txt", ".hidden.toml"}) {
    std::ofstream(folder + name) << "x";
  }
  const auto found = [&](const std::string& typed) {
    std::vector<std::string> names;
    for (const FoundFile& file : find_files(folder + typed)) {
      names.push_back(file.path.substr(folder.size()));
    }
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(found(""), (Names{"tori/", "Tower.png", "torus.toml"}));
  EXPECT_EQ(found("TO"), (Names{"tori/", "Tower.png", "torus.toml"}));
  EXPECT_EQ(found("tow"), Names{"Tower.png"});
  EXPECT_EQ(found(".h"), Names{".hidden.toml"});
  EXPECT_EQ(found("tori/"), Names{});
  EXPECT_TRUE(find_files("/nowhere at all/").empty());
}

/// An empty folder that is the current one.
class SavedScenes : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(folder_.path()); }
  void TearDown() override { std::filesystem::current_path(before_); }

 private:
  const std::filesystem::path before_ = std::filesystem::current_path();
  const TemporaryFolder folder_;
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
