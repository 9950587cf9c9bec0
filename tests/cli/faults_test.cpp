// What goes wrong around a run, and what others have put in its way: nothing is lost, nothing takes
// for ever, and a message says what happened.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "base/file.h"
#include "base/run_limits.h"
#include "cli/program.h"
#include "sanitized.h"

namespace saddle {
namespace {

using Words = std::vector<std::string>;

class Faults : public ProgramTest {
 protected:
  /// A program of that name comes first in the PATH of run_with_programs().
  void put_program(const std::string& name, const std::string& script) const {
    const std::filesystem::path file = programs_.path() / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  Outcome run_with_programs(const Words& words, const std::function<void()>& limit = {}) const {
    return run_saddle(words, folder_, "", [&] {
      if (limit) limit();
      const std::string path = programs_.path().string() + ":" + std::getenv("PATH");
      setenv("PATH", path.c_str(), 1);
    });
  }
  Outcome run_with(const char* variable, const std::string& value, const Words& words) const {
    return run_saddle(words, folder_, "", [&] { setenv(variable, value.c_str(), 1); });
  }
  /// Ended by the system after so much work, ten times as much with a sanitizer.
  Outcome run_within(rlim_t seconds, const Words& words) const {
    const rlim_t most = kIsSanitized ? 10 * seconds : seconds;
    return run_saddle(words, folder_, "", [=] {
      const rlimit limit{most, most};
      setrlimit(RLIMIT_CPU, &limit);
    });
  }

  const TemporaryFolder programs_;
};

const Words kFilm = {"z=u*v*t", "--frames", "3", "-s", "16x16"};

Words film(const Words& more) {
  Words words = kFilm;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(Faults, TwoOutputsNeverMeetInOneFile) {
  const std::vector<Words> wrong = {
      {"-o", "f%d.png", "--report", "f1.png"}, {"-o", "f-%d.png", "-o", "f-0.png"},
      {"-o", "f%d.png", "-o", "f%01d.png"},    {"-o", "./f%d.png", "-o", "f2.png"},
      {"-o", "f%d.png", "-o", "link.png"},     {"-o", "f%d.png", "-o", "sub/../f1.png"},
  };
  std::filesystem::create_symlink("f2.png", path("link.png"));
  std::filesystem::create_directory(path("sub"));
  for (const Words& words : wrong) {
    const std::string said = error_of(saddle(film(words)), 2);
    EXPECT_TRUE(contains(said, "two outputs are called")) << said;
    EXPECT_TRUE(contains(said, "its own name")) << said;
    EXPECT_EQ(files(), (Words{"link.png", "sub"})) << words[1];
  }
  EXPECT_EQ(saddle(film({"-o", "f%d.png", "--report", "f3.png"})).status, 0);
  EXPECT_EQ(saddle(film({"-o", "g%d.png", "-o", "g%d.png", "-o", "g0.ply"})).status, 0);
}

TEST_F(Faults, StrictRunsLeaveNoFrameOfAFilmThatWarns) {
  std::ofstream(path("f0.png")) << "old";
  const Words pole = {"z=1/(u+1.6-t)", "t=0:2", "--frames", "3", "-s", "32x24"};
  Words words = pole;
  words.insert(words.end(), {"-o", "f%d.png", "-o", "f%d.ply", "--strict"});
  EXPECT_TRUE(contains(error_of(saddle(words), 2), "--strict: "));
  EXPECT_EQ(files(), Words{"f0.png"});
  EXPECT_EQ(read_file(path("f0.png")), "old");
  words.pop_back();
  EXPECT_EQ(saddle(words).status, 0);
  EXPECT_EQ(files().size(), 6U);
  // Warnings that are known only at the end, and standard output.
  EXPECT_EQ(saddle({"torus", "a=1", "--strict", "-o", "t.ply"}).status, 2);
  EXPECT_EQ(saddle({"torus", "--strict", "-o", "t.ply"}).status, 0);
  const Outcome unused = saddle({"z=u", "a=1", "--strict", "-o", "-", "--format", "ply"});
  EXPECT_EQ(unused.status, 2);
  EXPECT_EQ(unused.out, "");
  const Outcome good = saddle({"z=u", "--strict", "-o", "-", "--format", "ply"});
  EXPECT_EQ(good.out, saddle({"z=u", "-o", "-", "--format", "ply"}).out);
}

TEST_F(Faults, AnFfmpegThatWritesNothingReplacesNothing) {
  put_program("ffmpeg", "cat >/dev/null");
  for (const std::string name : {"a.mp4", "a.gif"}) {
    std::ofstream(path(name)) << "old";
    const std::string said = error_of(run_with_programs(film({"-o", name})), 1);
    EXPECT_TRUE(contains(said, "ffmpeg failed: it has written nothing")) << said;
    EXPECT_EQ(read_file(path(name)), "old");
  }
}

TEST_F(Faults, AnFfmpegThatFindsNoRoomForTheEndReplacesNothing) {
  put_program("ffmpeg", R"(cat >/dev/null; for last; do :; done; printf %1000s a >"$last")");
  for (const std::string name : {"a.mp4", "a.gif"}) {
    std::ofstream(path(name)) << "old";
    const Outcome run = run_with_programs(film({"-o", name}), [] {
      const rlimit limit{1000, 1000};
      setrlimit(RLIMIT_FSIZE, &limit);
    });
    EXPECT_TRUE(contains(error_of(run, 1), "ffmpeg failed: File too large")) << run.err;
    EXPECT_EQ(read_file(path(name)), "old");
  }
}

TEST_F(Faults, AnFfmpegThatFloodsDoesNoHarm) {
  put_program("ffmpeg", "yes | head -c 300000000 >&2; echo last words >&2; exit 1");
  const std::string said = error_of(run_with_programs(film({"-o", "a.mp4"})), 1);
  EXPECT_TRUE(contains(said, "last words")) << said.size();
  EXPECT_LT(said.size(), 10'000U);
}

TEST_F(Faults, NamesTheFolderOfTemporaryFiles) {
  const std::string none = error_of(run_with("TMPDIR", "/nonexistent", film({"-o", "a.mp4"})), 1);
  EXPECT_TRUE(contains(none, "no temporary file /nonexistent/saddle-")) << none;
  EXPECT_TRUE(contains(none, "TMPDIR")) << none;
}

TEST_F(Faults, AFullStandardOutputIsTheSystemsReason) {
  const Outcome run =
      run_saddle({"torus", "-s", "64x48", "-o", "-", "--format", "png"}, folder_, "/dev/full");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.err, "cannot write to standard output: No space left")) << run.err;
}

TEST_F(Faults, ADamagedSceneInAPictureIsSaidToBeDamaged) {
  saddle({"torus", "-s", "16x16", "-o", "a.png"});
  std::string bytes = read_file(path("a.png"));
  bytes[bytes.find("saddle-scene") + 20] ^= 1;
  std::ofstream(path("b.png")) << bytes;
  const std::string said = error_of(saddle({"b.png", "-o", "c.ply"}), 2);
  EXPECT_TRUE(contains(said, "damaged")) << said;
}

TEST_F(Faults, NumbersThatAreNoneHaveNoSign) {
  for (const std::string formula : {"0/0", "-(0/0)"}) {
    const std::string said = error_of(saddle({"torus", "--fov", formula, "-o", "a.ply"}), 2);
    EXPECT_FALSE(contains(said, "-nan")) << said;
  }
}

TEST_F(Faults, GridsHaveABound) {
  const std::string said = error_of(saddle({"torus", "--grid", "4096x4096", "-o", "a.png"}), 2);
  EXPECT_TRUE(contains(said, "at most 1048576, such as 1024x1024")) << said;
  EXPECT_EQ(saddle({"torus", "--grid", "1024x2", "-s", "16x16", "-o", "a.png"}).status, 0);
}

TEST_F(Faults, ScenesAreReadInATimeLikeTheirLength) {
  std::string steps;
  for (int i = 0; i < 30'000; ++i) steps += "{translate=[0,0,1e-9]},";
  std::ofstream(path("line.toml"))
      << "surface=[{z=\"u\",in=\"a\"}]\nnode=[{name=\"a\",transform=[" << steps << "]}]\n";
  std::ofstream chain(path("chain.toml"));
  chain << "[params]\np0=1\n";
  for (int i = 1; i < 50'000; ++i) chain << "p" << i << "=\"p" << i - 1 << "+1\"\n";
  chain << "[[surface]]\nz=\"u+p49999\"\n";
  chain.close();
  for (const std::string name : {"line.toml", "chain.toml"}) {
    const Outcome run = run_within(10, {name, "-q", "-s", "16x16", "-o", "a.png"});
    EXPECT_EQ(run.status, 0) << name << run.err;
  }
  std::ofstream mesh(path("lines.obj"));
  for (int i = 0; i < 600'000; ++i) mesh << "# scene # nothing\n";
  mesh.close();
  const Outcome run = run_within(10, {"lines.obj", "-o", "a.png"});
  EXPECT_TRUE(contains(error_of(run, 2), "a scene file of more than 4 MiB")) << run.err;
}

TEST_F(Faults, ScenesAreRefusedThatWouldTakeForEver) {
  const auto scene = [this](int surfaces, int definitions, const std::string& more) {
    std::ofstream file(path("s.toml"));
    if (definitions > 0) file << "[params]\n";
    for (int i = 0; i < definitions; ++i) file << "p" << i << "=1\n";
    for (int i = 0; i < surfaces; ++i) file << "[[surface]]\nz=\"u\"\n" << more;
  };
  scene(20'001, 0, "");
  EXPECT_TRUE(contains(error_of(run_within(20, {"s.toml", "-o", "a.png"}), 2), "too many"));
  scene(2001, 0, "");
  EXPECT_TRUE(contains(error_of(run_within(20, {"s.toml", "-o", "a.png"}), 2), "at most 2000;"));
  scene(1500, 1500, "");
  EXPECT_TRUE(contains(error_of(run_within(20, {"s.toml", "-o", "a.png"}), 2), "too many"));
  scene(10, 0, "grid=[1024,1024]\n");
  EXPECT_TRUE(contains(error_of(run_within(20, {"s.toml", "-o", "a.png"}), 2), "too many lines"));
}

TEST_F(Faults, FormulasOfASceneAreBoundedTogether) {
  std::string sum = "sin(u)";
  for (int i = 0; i < 2000; ++i) sum += "+sin(u+" + std::to_string(i) + "*v)";
  std::ofstream file(path("s.toml"));
  file << "[functions]\n\"f(u,v)\"=\"" << sum << "\"\n";
  for (int i = 0; i < 1000; ++i) file << "[[surface]]\nz=\"f(u,v)+" << i << "\"\n";
  file.close();
  const std::string said = error_of(run_within(20, {"s.toml", "-o", "a.png"}), 2);
  EXPECT_TRUE(contains(said, "too long together")) << said;
}

TEST_F(Faults, SeeThroughLayersAreBounded) {
  const Outcome run = run_within(40, {"z=sin(60*u)*sin(60*v)", "--opacity", "0.1", "--view",
                                      "1,0,0", "--max-triangles", "300000", "-o", "a.png"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "see-through layers lie behind each other")) << run.err;
}

TEST_F(Faults, MemoryIsRefusedWithAWordOfHowMuch) {
  if (!system_refuses_memory()) GTEST_SKIP() << "a sanitizer takes more addresses than that";
  const Outcome run =
      saddle({"torus", "--samples", "4096x4096", "--max-memory", "500MB", "-o", "a.ply"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.err, "more than the")) << run.err;
  EXPECT_TRUE(contains(run.err, "--max-memory is 500 MB")) << run.err;
  EXPECT_TRUE(files().empty());
}

TEST_F(Faults, ShortMemoryStopsRefinement) {
  const Outcome run = saddle({"torus", "--tolerance", "1e-9", "--max-triangles", "1000000000",
                              "--max-memory", "300MB", "-o", "a.ply"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "stopped refinement")) << run.err;
  EXPECT_TRUE(contains(run.err, "--max-memory allows more")) << run.err;
}

TEST_F(Faults, TimeThatIsOverStopsRefinement) {
  const Outcome run =
      run_within(60, {"z=sin(1/(u*v))", "--tolerance", "1e-5", "--max-time", "0.2", "-o", "a.ply"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "the limit of time stopped refinement")) << run.err;
  EXPECT_TRUE(contains(run.err, "--max-time allows more")) << run.err;
  EXPECT_TRUE(exists("a.ply"));
}

TEST_F(Faults, AFileThatMayNotGrowIsAnError) {
  for (const char* const name : {"a.png", "a.ply"}) {
    std::ofstream(path(name)) << "old";
    const Outcome run = run_saddle({"torus", "-s", "64x64", "-o", name}, folder_, "", [] {
      const rlimit limit{1000, 1000};
      setrlimit(RLIMIT_FSIZE, &limit);
      signal(SIGXFSZ, SIG_DFL);
    });
    EXPECT_TRUE(contains(error_of(run, 1), "File too large")) << name;
    EXPECT_EQ(read_file(path(name)), "old");
  }
  EXPECT_EQ(files(), (Words{"a.ply", "a.png"}));
}

TEST_F(Faults, LinksOfOthersInSharedFoldersAreNotFollowed) {
  if (geteuid() != 0) GTEST_SKIP() << "only root makes links of another user";
  const std::filesystem::path shared = path("shared");
  std::filesystem::create_directory(shared);
  ASSERT_EQ(chmod(shared.c_str(), 01777), 0);
  std::ofstream(path("victim.png")) << "old";
  std::filesystem::create_symlink("../victim.png", shared / "a.png");
  ASSERT_EQ(lchown((shared / "a.png").c_str(), 12345, 12345), 0);
  const std::string said = error_of(small({"torus", "-o", "shared/a.png"}), 1);
  EXPECT_TRUE(contains(said, "another user's link")) << said;
  EXPECT_EQ(read_file(path("victim.png")), "old");
  ASSERT_EQ(lchown((shared / "a.png").c_str(), 0, 0), 0);
  EXPECT_EQ(small({"torus", "-o", "shared/a.png"}).status, 0);
  EXPECT_TRUE(read_file(path("victim.png")).starts_with("\x89PNG"));
}

}  // namespace
}  // namespace saddle
