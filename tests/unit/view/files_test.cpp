#include "view/model/files.h"

#include <gtest/gtest.h>

#include <fstream>

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

}  // namespace
}  // namespace saddle
