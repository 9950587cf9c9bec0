#include "base/child.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/file.h"
#include "base/temporary.h"

namespace saddle {
namespace {

TEST(RunWithInput, HandsOverAllOfALongInput) {
  const auto path = std::filesystem::temp_directory_path() / "saddle-child-test";
  const std::string text(1'000'000, 'x');
  run_with_input({"dd", "of=" + path.string(), "status=none"}, text, "coreutils");
  EXPECT_EQ(read_file(path), text);
  std::filesystem::remove(path);
}

TEST(RunWithInput, NamesThePackageOfAProgramThatIsMissing) {
  try {
    run_with_input({"saddle-no-such-program"}, "", "some-package");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Machine);
    EXPECT_EQ(std::string(error.what()),
              "cannot run saddle-no-such-program: No such file or directory");
    EXPECT_EQ(error.hint(), "install the package some-package");
  }
}

TEST(RunWithInput, PassesOnTheLastThingThatAFailingProgramSaid) {
  try {
    run_with_input({"sh", "-c", "cat; echo one >&2; echo ' two ' >&2; exit 3"}, "text", "dash");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "sh failed: two");
  }
}

TEST(RunWithInput, KeepsTheEndOfAFlood) {
  try {
    run_with_input({"sh", "-c", "yes | head -c 100000000 >&2; echo the end >&2; exit 1"}, "",
                   "dash");
    FAIL();
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.ends_with("the end")) << text.size();
    EXPECT_LT(text.size(), 5000U);
  }
}

TEST(RunWithInput, SaysThatAProgramWasEnded) {
  try {
    run_with_input({"sh", "-c", "kill -9 $$"}, "", "dash");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "sh failed: it was ended: Killed");
  }
}

TEST(RunWithInput, OutlivesAProgramThatDoesNotRead) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);  // as main does
  EXPECT_THROW(run_with_input({"false"}, std::string(1'000'000, 'x'), "coreutils"), Error);
  std::signal(SIGPIPE, before);
}

TEST(Child, WritesToAFileWithoutANameThatItInherits) {
  const UnnamedFile file;
  Child child({"cp", "/dev/stdin", file.path()}, "coreutils", std::array{file.descriptor()});
  EXPECT_TRUE(child.feed("one "));
  EXPECT_TRUE(child.feed("two"));
  child.finish();
  std::ostringstream text;
  file.copy_to(text);
  EXPECT_EQ(text.str(), "one two");
}

TEST(Child, EndsWhenAnotherThreadWantsItTo) {
  Child child({"sleep", "1000"}, "coreutils");
  const std::jthread other([&] { child.interrupt(); });
  EXPECT_THROW(child.finish(), Error);
  child.interrupt();  // nothing is left to end
}

TEST(Child, TellsAllOfItsWords) {
  Child child({"sh", "-c", "echo one >&2; echo two >&2"}, "dash");
  child.finish();
  EXPECT_EQ(child.words(), "one\ntwo\n");
}

TEST(Child, EndsWithItsOwner) {
  const UnnamedFile file;
  {
    const std::string script = "echo $$ >" + file.path() + "; read line; echo survived >>";
    Child child({"sh", "-c", script + file.path()}, "dash", std::array{file.descriptor()});
    for (int i = 0; i < 60'000 && lseek(file.descriptor(), 0, SEEK_END) == 0; ++i) usleep(1000);
  }
  std::ostringstream text;
  file.copy_to(text);
  const int process = std::stoi(text.str());
  EXPECT_GT(process, 0);
  EXPECT_EQ(kill(process, 0), -1);  // there is none
  EXPECT_EQ(text.str(), std::to_string(process) + "\n");
}

}  // namespace
}  // namespace saddle
