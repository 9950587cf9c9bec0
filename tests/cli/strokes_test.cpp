// Curves and points as words of a command line.
#include <gtest/gtest.h>

#include "base/file.h"
#include "cli/program.h"
#include "ply_mesh.h"

namespace saddle {
namespace {

class Strokes : public ProgramTest {};

TEST_F(Strokes, BecomeASceneThatIsReadAgain) {
  const Outcome outcome =
      saddle({"torus",    "+",    "curve",        "u=3*s", "v=w", "w=2*s", "s=0:tau",
              "--radius", "0.05", "--color",      "red",   "+",   "point", "-1,2,3",
              "--label",  "P",    "--line-width", "9",     "-o",  "a.toml"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string scene = read_file(path("a.toml"));
  EXPECT_TRUE(contains(scene,
                       "[[curve]]\ncolor = \"#ff0000\"\nradius = 0.05\non = \"torus\"\n"
                       "u = \"3*s\"\nv = \"w\"\ns = [\"0\", \"tau\"]\n"))
      << scene;
  EXPECT_TRUE(contains(scene, "[[point]]\nlabel = \"P\"\nwidth = 9\nat = [-1, 2, 3]\n")) << scene;
  ASSERT_EQ(saddle({"a.toml", "-o", "b.toml"}).status, 0);
  EXPECT_EQ(read_file(path("b.toml")), scene);
}

TEST_F(Strokes, CurvesMayBeVectors) {
  ASSERT_EQ(saddle({"curve", "xyz=(cos(s),sin(s),s/5)", "s=0:tau", "--radius", "0.1", "-o",
                    "a.toml", "-o", "a.ply"})
                .status,
            0);
  EXPECT_TRUE(contains(read_file(path("a.toml")), "xyz = \"(cos(s),sin(s),s/5)\"\n"));
  ASSERT_EQ(saddle({"a.toml", "-o", "b.ply"}).status, 0);
  ASSERT_EQ(saddle({"curve", "x=cos(s)", "y=sin(s)", "z=s/5", "s=0:tau", "--radius", "0.1", "-o",
                    "c.ply"})
                .status,
            0);
  EXPECT_EQ(read_file(path("b.ply")), read_file(path("a.ply")));
  EXPECT_EQ(mesh_in_ply(read_file(path("c.ply"))), mesh_in_ply(read_file(path("a.ply"))));
}

TEST_F(Strokes, AreOnTheNearestSurfaceBefore) {
  const Outcome outcome = saddle({"torus", "+", "torus", "R=5", "+", "point", "u=0", "v=0", "+",
                                  "sphere", "-o", "a.toml", "--report", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(contains(read_file(path("a.toml")), "on = \"torus 2\""));
  const Outcome report = saddle({"a.toml", "-o", "a.png", "-s", "40x30", "--report", "r.json"});
  ASSERT_EQ(report.status, 0) << report.err;
  EXPECT_TRUE(contains(read_file(path("r.json")), "\"position\": [\n        5.8,\n"));
}

TEST_F(Strokes, TakeTheNamesOfTheParametersOfTheirSurface) {
  const std::vector<std::string> ball = {"xyz=spherical(1,theta,phi)", "theta=0:pi", "phi=0:tau"};
  const auto scene_with = [&](const std::vector<std::string>& strokes) {
    std::vector<std::string> words = ball;
    words.insert(words.end(), strokes.begin(), strokes.end());
    words.insert(words.end(), {"-o", "a.toml"});
    const Outcome outcome = saddle(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_file(path("a.toml"));
  };
  const std::string usual =
      scene_with({"+", "curve", "u=pi*s", "v=6*s", "+", "point", "u=1", "v=2"});
  EXPECT_EQ(scene_with({"+", "curve", "phi=6*s", "theta=pi*s", "+", "point", "theta=1", "φ=2"}),
            usual);
  // x and y of a curve are its place in space, whatever the surface calls its parameters.
  ASSERT_EQ(saddle({"z=x*y", "x=0:1", "y=0:1", "+", "curve", "x=s", "y=s", "-o", "b.toml"}).status,
            0);
  EXPECT_TRUE(contains(read_file(path("b.toml")), "[[curve]]\nx = \"s\"\ny = \"s\"\n"));
}

TEST_F(Strokes, KeepTheirColorsBesideAColoredSurface) {
  ASSERT_EQ(saddle({"z=u*v", "+", "curve", "x=s", "--color", "red", "-o", "a.toml"}).status, 0);
  for (const std::vector<std::string>& more : {std::vector<std::string>(), {"+", "z=2"}}) {
    std::vector<std::string> words = {"a.toml", "--color", "gauss", "--radius", "0.2"};
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), {"-o", "b.toml"});
    const Outcome outcome = saddle(words);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::string scene = read_file(path("b.toml"));
    EXPECT_TRUE(contains(scene, "color = \"gauss\"")) << scene;
    EXPECT_TRUE(contains(scene, "[[curve]]\ncolor = \"#ff0000\"\nradius = 0.2\n")) << scene;
  }
}

TEST_F(Strokes, TubesAndBallsArePartOfMeshesAndLinesAreNot) {
  const Outcome tube = saddle(
      {"curve", "x=s", "--radius", "0.1", "+", "point", "0,3,0", "--radius", "0.5", "-o", "a.ply"});
  EXPECT_EQ(tube.status, 0) << tube.err;
  EXPECT_EQ(tube.err, "");
  EXPECT_GT(read_file(path("a.ply")).size(), 10'000U);
  const Outcome line = saddle({"sphere", "+", "curve", "x=s", "-o", "b.ply"});
  EXPECT_EQ(line.status, 0);
  EXPECT_TRUE(contains(line.err, "warning: b.ply: .ply has no lines and dots: curve is left out"))
      << line.err;
  ASSERT_EQ(saddle({"sphere", "-o", "c.ply"}).status, 0);
  EXPECT_TRUE(mesh_in_ply(read_file(path("b.ply"))) == mesh_in_ply(read_file(path("c.ply"))));
  const Outcome nothing = saddle({"point", "1,2,3", "-o", "d.ply"});
  EXPECT_EQ(nothing.status, 3);
  EXPECT_TRUE(contains(nothing.err, "--radius makes a tube")) << nothing.err;
}

TEST_F(Strokes, MoveWithTime) {
  const Outcome outcome =
      saddle({"curve", "x=s", "y=t*s", "t=0:1", "+", "point", "0,0,t", "--radius", "0.1",
              "--frames", "3", "-s", "60x40", "-o", "f%d.png", "--report", "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(read_file(path("f0.png")), read_file(path("f2.png")));
  const std::string report = read_file(path("r.json"));
  EXPECT_EQ(report.find("\"meshes\": 1"), std::string::npos) << "each frame has its own";
}

TEST_F(Strokes, CheckTellsTheLength) {
  const Outcome outcome = saddle({"check", "curve", "x=3*s", "y=4*s", "+", "point", "1,2,3"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "curve of length 5\n")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "point at 1, 2, 3\n")) << outcome.out;
}

}  // namespace
}  // namespace saddle
