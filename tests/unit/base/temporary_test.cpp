// What a run leaves behind that a signal ends in the middle of writing a file.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <ostream>
#include <set>
#include <string>

#include "base/file.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// More than the buffer that a stream collects before it writes.
const std::string kLarge(3'000'000, 'x');

class KilledRun : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "saddle-killed-XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder = pattern;
  }
  void TearDown() override { fs::remove_all(folder); }

  Names names() const {
    Names result;
    for (const auto& entry : fs::directory_iterator(folder)) {
      result.insert(entry.path().filename().string());
    }
    return result;
  }

  fs::path folder;
};

/// Starts a process that writes half of `path`, lets `inspect` look, sends `signal_number` and
/// returns how the process ended.
int end_in_the_middle(const fs::path& path, int signal_number,
                      const std::function<void()>& inspect) {
  int ready[2];
  EXPECT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    remove_temporaries_on_signals();
    write_file_whole(path, [&ready](std::ostream& out) {
      out << kLarge << std::flush;
      if (write(ready[1], "x", 1) != 1) _exit(1);
      while (true) pause();
    });
  }
  char letter = 0;
  EXPECT_EQ(read(ready[0], &letter, 1), 1);
  inspect();
  EXPECT_EQ(kill(child, signal_number), 0);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  close(ready[0]);
  close(ready[1]);
  return status;
}

TEST_F(KilledRun, LeavesNothingAtAllWhenItIsAskedToEnd) {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const int status =
        end_in_the_middle(folder / "a", signal_number, [this] { EXPECT_EQ(names().size(), 1u); });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal_number);
    EXPECT_EQ(names(), Names{}) << "signal " << signal_number;
  }
}

TEST_F(KilledRun, LeavesTheOldFileWhenItIsAskedToEnd) {
  write_file_whole(folder / "a", [](std::ostream& out) { out << "old"; });
  end_in_the_middle(folder / "a", SIGTERM, [] {});
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(names(), Names{"a"});
}

TEST_F(KilledRun, LeavesNothingUnderTheFinalNameWhenItCannotEvenCleanUp) {
  end_in_the_middle(folder / "a", SIGKILL, [] {});
  EXPECT_FALSE(fs::exists(folder / "a"));
  ASSERT_EQ(names().size(), 1u);
  EXPECT_TRUE(names().begin()->starts_with(".a.")) << "a user must see whose leftover it is";
}

TEST_F(KilledRun, GoesOnAfterASignalThatItWasStartedToIgnore) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGHUP, SIG_IGN);
    remove_temporaries_on_signals();
    write_file_whole(folder / "a", [](std::ostream& out) {
      raise(SIGHUP);
      out << "whole";
    });
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(read_file(folder / "a"), "whole");
}

}  // namespace
}  // namespace saddle
