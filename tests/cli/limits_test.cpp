// Where the system gives no more threads or memory, a run ends with a message.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "base/file.h"
#include "base/run_limits.h"
#include "cli/program.h"

namespace saddle {
namespace {

void limit_to(int resource, rlim_t value) {
  const rlimit limit{value, value};
  if (setrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0) _exit(125);
}

class Limits : public ProgramTest {
 protected:
  Outcome picture(const std::string& name, const std::function<void()>& limit) {
    return run_saddle({"torus", "-s", "64x48", "-o", name}, folder_, "", limit);
  }
  std::string whole() {
    EXPECT_EQ(picture("whole.png", {}).status, 0);
    return read_file(path("whole.png"));
  }
};

TEST_F(Limits, APictureWithLittleMemoryIsTheSameOrNotThere) {
  if (!system_refuses_memory()) GTEST_SKIP() << "a sanitizer takes more addresses than that";
  const std::string expected = whole();
  for (rlim_t mebibytes = 240; mebibytes <= 340; mebibytes += 4) {
    SCOPED_TRACE(mebibytes);
    std::filesystem::remove(path("a.png"));
    const Outcome run = picture("a.png", [=] { limit_to(RLIMIT_AS, mebibytes << 20); });
    EXPECT_TRUE(run.status == 0 || run.status == 1) << run.status << run.err;
    EXPECT_EQ(exists("a.png"), run.status == 0);
    if (run.status == 0) {
      EXPECT_TRUE(read_file(path("a.png")) == expected);
    } else {
      EXPECT_TRUE(contains(run.err, "saddle: ")) << run.err;
    }
  }
}

TEST_F(Limits, APictureOfManyNodesTakesMemoryInProportionToThem) {
  const auto peak = [&](int nodes) {
    std::string names;
    std::string tables;
    for (int i = 0; i < nodes; ++i) {
      const std::string name = std::to_string(i);
      names += "\"" + name + "\",";
      tables += "[[node]]\nname = \"" + name + "\"\n";
    }
    std::ofstream(path("nodes.toml")) << "[[surface]]\nz = \"0\"\nin = [" + names + "]\n" + tables;
    const Outcome run = saddle({"nodes.toml", "-q", "-s", "16x12", "-o", "a.png", "--report", "-"});
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out)["peak_memory_bytes"].get<double>();
  };
  // The nodes take 80 megabytes, and threads that allocate at once up to 70 more. A list of all
  // names for each node would take 32 bytes a name, 288 megabytes besides.
  EXPECT_LT(peak(3000) - peak(10), 250e6);
}

/// The system counts what the process took before it became saddle: its parent's memory.
TEST_F(Limits, ARunDoesNotTellTheMemoryOfTheProgramThatStartedIt) {
  const auto peak = [&] {
    const Outcome run = saddle({"torus", "-q", "-o", "a.ply", "--report", "-"});
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out)["peak_memory_bytes"].get<double>();
  };
  const double alone = peak();
  const std::vector<char> large(std::size_t{300} << 20, 1);
  EXPECT_LT(peak(), alone + 100e6) << large.back();
}

TEST_F(Limits, APictureTakesNoThreads) {
  if (geteuid() != 0) GTEST_SKIP() << "only root runs it as a user without other processes";
  const std::string expected = whole();
  const auto user = static_cast<uid_t>(1'000'000 + getpid());
  ASSERT_EQ(chown(folder_.c_str(), user, user), 0);
  for (const rlim_t threads : {1, 2, 3, 4, 6, 10}) {
    const std::string name = std::to_string(threads) + ".png";
    const Outcome run = picture(name, [=] {
      limit_to(RLIMIT_NPROC, threads);
      if (setgid(user) != 0 || setuid(user) != 0) _exit(124);
    });
    ASSERT_EQ(run.status, 0) << threads << ": " << run.err;
    EXPECT_TRUE(read_file(path(name)) == expected) << threads;
  }
}

}  // namespace
}  // namespace saddle
