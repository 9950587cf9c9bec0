#include "base/child.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"

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

TEST(RunWithInput, OutlivesAProgramThatDoesNotRead) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);  // as main does
  EXPECT_THROW(run_with_input({"false"}, std::string(1'000'000, 'x'), "coreutils"), Error);
  std::signal(SIGPIPE, before);
}

}  // namespace
}  // namespace saddle
