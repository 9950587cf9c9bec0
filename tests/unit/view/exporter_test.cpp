#include "view/picture/exporter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <semaphore>

#include "base/file.h"
#include "export/formats/formats.h"
#include "paths.h"
#include "scene/model/gallery.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

std::vector<std::string> names(const std::string& typed) {
  std::vector<std::string> names;
  for (const ExportChoice& choice : export_choices("no such title", typed)) {
    names.push_back(choice.name);
  }
  return names;
}

TEST(Exports, HaveTheNamesOfAllFormats) {
  EXPECT_EQ(names("").size(), formats().size());
  EXPECT_EQ(names("").front(), "no-such-title.png");
  EXPECT_EQ(names("folder/").front(), "folder/no-such-title.png");
  EXPECT_EQ(names("a").size(), formats().size());
  EXPECT_EQ(names("a.p"), (std::vector<std::string>{"a.png", "a.ply", "a.pdf"}));
  EXPECT_EQ(names("a.glb"), std::vector<std::string>{"a.glb"});
  EXPECT_TRUE(names("a.xyz").empty());
}

TEST(Exports, HaveTheSizeThatIsTyped) {
  EXPECT_FALSE(typed_export(""));
  EXPECT_FALSE(typed_export("a"));
  EXPECT_FALSE(typed_export(".png"));
  EXPECT_FALSE(typed_export("a.png 64x"));
  EXPECT_FALSE(typed_export("a.png 64"));
  ASSERT_TRUE(typed_export("a.png"));
  EXPECT_FALSE(typed_export("a.png")->size);
  const auto sized = typed_export("my picture.PNG 64x48");
  ASSERT_TRUE(sized && sized->size);
  EXPECT_EQ(sized->path, "my picture.PNG");
  EXPECT_EQ(sized->size->u, 64);
  EXPECT_EQ(sized->size->v, 48);
}

/// Writing to a program that has ended is an error, no signal, as main has it.
class IgnoredSigpipe {
 public:
  IgnoredSigpipe() = default;
  IgnoredSigpipe(const IgnoredSigpipe&) = delete;
  IgnoredSigpipe& operator=(const IgnoredSigpipe&) = delete;
  ~IgnoredSigpipe() { std::signal(SIGPIPE, before_); }

 private:
  void (*before_)(int) = std::signal(SIGPIPE, SIG_IGN);
};

class Exporters : public ::testing::Test {
 protected:
  /// Its news once it is done.
  std::string write(const std::string& name) {
    exporter_.write(gallery_scene(*find_gallery_entry("torus")), {path(name)});
    EXPECT_TRUE(exporter_.is_busy());
    while (!news()) {
      if (!done_.try_acquire_for(std::chrono::minutes(1))) return "nothing";
    }
    EXPECT_FALSE(exporter_.is_busy());
    return *news_;
  }
  std::filesystem::path path(const std::string& name) const { return temporary_.path() / name; }

  IgnoredSigpipe ignored_;  // for longer than the exporter is there
  Exporter exporter_{program_path(), 1, [this] { done_.release(); }};

 private:
  bool news() {
    news_ = exporter_.pass();
    return news_.has_value();
  }

  TemporaryFolder temporary_;
  std::counting_semaphore<> done_{0};
  std::optional<std::string> news_;
};

TEST_F(Exporters, WriteMeshesAndReplaceThem) {
  for (int i = 0; i < 2; ++i) {
    const std::string news = write("a.ply");
    EXPECT_EQ(news, "wrote " + path("a.ply").string());
    EXPECT_TRUE(read_file(path("a.ply")).starts_with("ply"));
  }
}

TEST_F(Exporters, TellWhatTheyWroteAndWhyThereIsNoFile) {
  const std::string news = write("a.stl");
  EXPECT_TRUE(news.starts_with("wrote " + path("a.stl").string())) << news;
  const std::string failed = write("none/a.ply");
  EXPECT_NE(failed.find("none/a.ply"), std::string::npos);
  EXPECT_FALSE(failed.starts_with("saddle: ")) << failed;
}

TEST_F(Exporters, EndWhatIsAtWork) {
  exporter_.write(gallery_scene(*find_gallery_entry("torus")), {path("a.ply")});
}

TEST(Exporter, TellsOfAProgramThatIsGone) {
  Exporter exporter("/no/such/program", 1, [] {});
  exporter.write(gallery_scene(*find_gallery_entry("torus")), {"a.ply"});
  const auto news = exporter.pass();
  ASSERT_TRUE(news);
  EXPECT_NE(news->find("/no/such/program"), std::string::npos);
  EXPECT_FALSE(exporter.is_busy());
}

}  // namespace
}  // namespace saddle
