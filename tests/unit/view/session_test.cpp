#include "view/model/session.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "base/file.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

class Sessions : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const {
    const auto path = temporary_.path() / name;
    std::ofstream(path) << "x";
    return path;
  }
  std::filesystem::path directory() const { return temporary_.path() / "state"; }

  /// Work of a window that has ended.
  void leave(const std::string& text) const {
    const pid_t child = fork();
    if (child == 0) {
      Session(directory()).keep_work(text);
      _exit(0);
    }
    waitpid(child, nullptr, 0);
  }

  TemporaryFolder temporary_;
};

TEST_F(Sessions, HaveTheLastFileFirstAndOnce) {
  Session session(directory());
  EXPECT_TRUE(session.recent_files().empty());
  const auto a = file("a.toml");
  const auto b = file("b.toml");
  for (const auto& path : {a, b, a}) session.remember_file(path);
  EXPECT_EQ(session.recent_files(), (std::vector{a, b}));
  std::filesystem::remove(a);
  EXPECT_EQ(session.recent_files(), std::vector{b}) << "those that are gone are left out";
}

TEST_F(Sessions, RememberABoundedNumberOfFiles) {
  Session session(directory());
  for (int i = 0; i < 50; ++i) session.remember_file(file(std::to_string(i) + ".toml"));
  EXPECT_EQ(session.recent_files().size(), 20U);
  EXPECT_EQ(session.recent_files().front().filename(), "49.toml");
}

TEST_F(Sessions, HandOnTheWorkOfAWindowThatHasEnded) {
  Session session(directory());
  EXPECT_EQ(session.keep_work("own"), "");
  EXPECT_FALSE(session.left_work()) << "this window has not ended";
  leave("other");
  ASSERT_TRUE(session.left_work());
  EXPECT_EQ(read_file(*session.left_work()), "other");
  std::filesystem::remove(*session.left_work());
  EXPECT_FALSE(session.left_work());
}

TEST_F(Sessions, KeepABoundedAmountOfWork) {
  for (int i = 0; i < 14; ++i) leave(std::to_string(i));
  Session(directory()).keep_work(std::string(std::size_t{2} << 20U, 'x'));  // too much
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory())) {
    count += entry.path().filename().string().starts_with("unsaved-") ? 1 : 0;
  }
  EXPECT_LE(count, 12);
  EXPECT_GE(count, 10);
}

TEST_F(Sessions, GoOnWithoutAPlaceToKeepAnything) {
  for (const std::filesystem::path& nowhere :
       {std::filesystem::path(), std::filesystem::path("/proc/nowhere"), file("a file")}) {
    Session session(nowhere);
    session.remember_file(file("a.toml"));
    EXPECT_NE(session.keep_work("text"), "") << "it tells why";
    session.forget_work();
    EXPECT_TRUE(session.recent_files().empty());
    EXPECT_FALSE(session.left_work());
  }
}

}  // namespace
}  // namespace saddle
