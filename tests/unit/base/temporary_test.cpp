// What a run leaves behind that a signal ends in the middle of writing a file.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "base/temporary.h"
#include "sanitized.h"
#include "temporary_folder.h"
#include "wait_for_child.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;
using FileNames = std::set<std::string>;

/// More than the buffer that a stream collects before it writes.
const std::string kLarge(3'000'000, 'x');

class KilledRun : public testing::Test {
 protected:
  FileNames names() const {
    FileNames result;
    for (const auto& entry : fs::directory_iterator(folder)) {
      result.insert(entry.path().filename().string());
    }
    return result;
  }

  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
};

/// Writes half of `path`, says so to `ready`, and waits for a signal.
[[noreturn]] void write_half(const fs::path& path, int ready) noexcept {
  write_file_whole(path, [ready](std::ostream& out) {
    out << kLarge << std::flush;
    if (write(ready, "x", 1) != 1) _exit(1);
    while (true) pause();
  });
  _exit(1);
}

/// Starts a process that writes half of `path`, lets `inspect` look, sends `signal_number` and
/// returns how the process ended.
int end_in_the_middle(const fs::path& path, int signal_number,
                      const std::function<void()>& inspect) {
  int ready[2];
  EXPECT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    signal(signal_number, SIG_DFL);  // under nohup or in a background job it is ignored
    remove_temporaries_on_signals();
    write_half(path, ready[1]);
  }
  close(ready[1]);
  char letter = 0;
  EXPECT_EQ(read(ready[0], &letter, 1), 1) << "the process ended before it wrote";
  close(ready[0]);
  inspect();
  EXPECT_EQ(kill(child, signal_number), 0);
  return wait_for_child(child);
}

TEST_F(KilledRun, LeavesNothingAtAllWhenItIsAskedToEnd) {
  if (!kForkHandlesSignals) GTEST_SKIP();
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    const int status =
        end_in_the_middle(folder / "a", signal_number, [this] { EXPECT_EQ(names().size(), 1u); });
    EXPECT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(WTERMSIG(status), signal_number);
    EXPECT_EQ(names(), FileNames{}) << "signal " << signal_number;
  }
}

TEST_F(KilledRun, LeavesNothingOfSeveralFilesWhenItIsAskedToEnd) {
  if (!kForkHandlesSignals) GTEST_SKIP();
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGTERM, SIG_DFL);
    remove_temporaries_on_signals();
    write_file_whole(folder / "c", [](std::ostream& out) { out << "whole"; });
    write_file_whole(folder / "a", [&](std::ostream&) { write_half(folder / "b", ready[1]); });
  }
  close(ready[1]);
  char letter = 0;
  EXPECT_EQ(read(ready[0], &letter, 1), 1);
  close(ready[0]);
  EXPECT_EQ(names().size(), 3U);
  EXPECT_EQ(kill(child, SIGTERM), 0);
  wait_for_child(child);
  EXPECT_EQ(names(), FileNames{"c"});
}

TEST_F(KilledRun, LeavesTheOldFileWhenItIsAskedToEnd) {
  if (!kForkHandlesSignals) GTEST_SKIP();
  write_file_whole(folder / "a", [](std::ostream& out) { out << "old"; });
  end_in_the_middle(folder / "a", SIGTERM, [] {});
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(names(), FileNames{"a"});
}

TEST_F(KilledRun, LeavesNothingUnderTheFinalNameWhenItCannotEvenCleanUp) {
  end_in_the_middle(folder / "a", SIGKILL, [] {});
  EXPECT_FALSE(fs::exists(folder / "a"));
  ASSERT_EQ(names().size(), 1u);
  EXPECT_TRUE(names().begin()->starts_with(".a.")) << "a user must see whose leftover it is";
}

TEST_F(KilledRun, LeavesNothingForGoodWhenItCannotEvenCleanUp) {
  end_in_the_middle(folder / "a", SIGKILL, [] {});
  std::ofstream(folder / ".a.saddle-short") << "another program's";
  std::ofstream(folder / ".a.saddle-UPPERCAS") << "another program's";
  fs::create_symlink("nowhere", folder / ".l.saddle-abcdefgh");
  ASSERT_EQ(names().size(), 4u);
  const pid_t next = fork();  // a folder is swept once in the life of a process
  if (next == 0) {
    write_file_whole(folder / "b", [](std::ostream& out) { out << "whole"; });
    _exit(0);
  }
  EXPECT_EQ(wait_for_child(next), 0);
  EXPECT_EQ(names(),
            (FileNames{".a.saddle-UPPERCAS", ".a.saddle-short", ".l.saddle-abcdefgh", "b"}));
}

TEST_F(KilledRun, IsNotSweptWhileItLives) {
  end_in_the_middle(folder / "a", SIGKILL, [this] {
    const FileNames before = names();
    const pid_t other = fork();
    if (other == 0) {
      write_file_whole(folder / "b", [](std::ostream& out) { out << "whole"; });
      _exit(0);
    }
    EXPECT_EQ(wait_for_child(other), 0);
    EXPECT_EQ(before.size(), 1u);
    EXPECT_TRUE(names().contains(*before.begin()));
    EXPECT_TRUE(names().contains("b"));
  });
}

TEST_F(KilledRun, LeavesWhatOthersDoNotSweep) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser can give files away";
  end_in_the_middle(folder / "a", SIGKILL, [] {});
  const FileNames left = names();
  ASSERT_EQ(left.size(), 1u);
  ASSERT_EQ(chown((folder / *left.begin()).c_str(), 12345, 12345), 0);
  const pid_t next = fork();
  if (next == 0) {
    write_file_whole(folder / "b", [](std::ostream& out) { out << "whole"; });
    _exit(0);
  }
  EXPECT_EQ(wait_for_child(next), 0);
  EXPECT_TRUE(names().contains(*left.begin()));
}

TEST_F(KilledRun, HidesFromOthersWhatTheyMayNotReadOfTheOldFile) {
  std::ofstream(folder / "a") << "old";
  fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_write);
  end_in_the_middle(folder / "a", SIGTERM, [this] {
    for (const std::string& name : names())
      EXPECT_EQ(fs::status(folder / name).permissions() & fs::perms(0077), fs::perms::none) << name;
  });
}

TEST_F(KilledRun, GoesOnAfterASignalThatItWasStartedToIgnore) {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const fs::path path = folder / std::to_string(signal_number);
    const pid_t child = fork();
    if (child == 0) {
      signal(signal_number, SIG_IGN);
      remove_temporaries_on_signals();
      write_file_whole(path, [signal_number](std::ostream& out) {
        raise(signal_number);
        out << "whole";
      });
      _exit(0);
    }
    EXPECT_EQ(wait_for_child(child), 0);
    EXPECT_EQ(read_file(path), "whole");
  }
}

class WithoutAName : public KilledRun {
 protected:
  void SetUp() override {
    if (const char* const before = std::getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", folder.c_str(), 1);
  }
  void TearDown() override { before_ ? setenv("TMPDIR", before_->c_str(), 1) : unsetenv("TMPDIR"); }

 private:
  std::optional<std::string> before_;
};

TEST_F(WithoutAName, AFileIsInNoFolder) {
  const UnnamedFile file;
  EXPECT_EQ(names(), FileNames{});
  ASSERT_EQ(write(file.descriptor(), "text", 4), 4);
  EXPECT_NO_THROW(file.check_written("the program", [] {}));
  std::ostringstream copy;
  file.copy_to(copy);
  EXPECT_EQ(copy.str(), "text") << "without what the check has tried";
}

TEST_F(WithoutAName, AFileThatHasNothingIsTold) {
  const UnnamedFile file;
  try {
    file.check_written("the program", [] {});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the program failed: it has written nothing");
  }
  EXPECT_THROW(file.check_written("x", [] { throw std::runtime_error("late"); }),
               std::runtime_error);
}

TEST_F(WithoutAName, AFileNeedsAFolderThatIsNamedAndThere) {
  setenv("TMPDIR", "", 1);
  EXPECT_NO_THROW(UnnamedFile());
  setenv("TMPDIR", (folder / "nowhere").c_str(), 1);
  try {
    const UnnamedFile file;
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find((folder / "nowhere").string()), std::string::npos);
  }
}

}  // namespace
}  // namespace saddle
