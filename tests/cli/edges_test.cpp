// What is just allowed, and what happens just beyond.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <fstream>

#include "base/image_png.h"
#include "cli/program.h"

namespace saddle {
namespace {

class Edges : public ProgramTest {
 protected:
  std::array<int, 4> pixel(const std::string& name, int x, int y) const {
    Image image = read_png(path(name)).image;
    const auto* const p = image.pixel(x, y);
    return {p[0], p[1], p[2], p[3]};
  }
};

TEST_F(Edges, AGifMayHave50FramesPerSecond) {
  EXPECT_EQ(small({"z=u*t", "--frames", "2", "--fps", "50", "-o", "a.gif"}).status, 0);
  EXPECT_EQ(small({"z=u*t", "--frames", "2", "--fps", "50.01", "-o", "b.gif"}).status, 2);
}

TEST_F(Edges, EqualPicturesPassAtThreshold0) {
  ASSERT_EQ(small({"torus", "-o", "a.png"}).status, 0);
  EXPECT_EQ(small({"torus", "--reference", "a.png", "--threshold", "0"}).status, 0);
  EXPECT_EQ(small({"torus", "--front", "red", "--reference", "a.png", "--threshold", "0"}).status,
            1);
}

TEST_F(Edges, AConeOfLightMayHaveASharpEdge) {
  const auto draw = [this](const std::string& inner) {
    std::ofstream(path("s.toml")) << "[[surface]]\nz = \"0\"\n[[light]]\nposition = [0, 0, 0]\n"
                                  << "spot = { direction = [0, 0, -1], cutoff = 30, inner = "
                                  << inner << " }\n";
    return small({"s.toml", "-o", "a.png"}).status;
  };
  EXPECT_EQ(draw("30"), 0);
  EXPECT_EQ(draw("30.01"), 2);
}

TEST_F(Edges, ALightOfAmbientAloneLights) {
  std::ofstream(path("s.toml"))
      << "[[surface]]\nz = \"0\"\ngrid = \"off\"\nfront = { diffuse = \"white\", ambient = "
         "\"white\" }\n"
      << "[[light]]\nposition = [0, 0, 0]\ncolor = [0, 0, 0]\nambient = [0.5, 0.5, 0.5]\n";
  ASSERT_EQ(small({"s.toml", "--view", "top", "-o", "a.png"}).status, 0);
  EXPECT_GT(pixel("a.png", 32, 24)[0], 100);
}

TEST_F(Edges, AHalfTransparentBackgroundKeepsItsColour) {
  ASSERT_EQ(small({"torus", "--background", "#ff000080", "-o", "a.png"}).status, 0);
  EXPECT_EQ(pixel("a.png", 0, 0), (std::array{255, 0, 0, 128}));
}

TEST_F(Edges, AnErrorOfAFrameSaysWhichFrame) {
  const Outcome run = small({"z=u*v", "v=0:0.5-t", "t=0:1", "--frames", "4", "-o", "f%d.png"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(contains(run.err, "frame 2, t = 0.5")) << run.err;
}

TEST_F(Edges, AFileThatMayNotGrowIsAnError) {
  const auto limit = [] {
    const rlimit most{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &most);
  };
  const Outcome stream =
      run_saddle({"torus", "-o", "-", "--format", "ply"}, folder_, path("out").string(), limit);
  EXPECT_EQ(stream.status, 1);
  EXPECT_TRUE(contains(stream.err, "File too large")) << stream.err;
  std::filesystem::remove(path("out"));
  const Outcome run = run_saddle({"torus", "-o", "a.ply"}, folder_, "", limit);
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_TRUE(contains(run.err, "File too large")) << run.err;
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace saddle
