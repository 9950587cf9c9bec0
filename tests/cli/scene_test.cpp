// Scene files and pictures that open again.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "cli/program.h"
#include "paths.h"

namespace saddle {
namespace {

class SceneFiles : public ProgramTest {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string content(const std::string& name) const { return read_file(path(name)); }
  /// Runs that must succeed.
  void make(const std::vector<std::string>& arguments) {
    const Outcome run = saddle(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
  }
};

TEST_F(SceneFiles, GiveTheSamePictureToTheBit) {
  const std::vector<std::string> formulas = {"z=a*sin(u)*cos(w)", "a=0.1+0.2", "w=v+t", "u=-3:pi"};
  const std::vector<std::string> options = {
      "-s",         "90x70",       "--view",       "1,-2,0.3",
      "--fov",      "25",          "--background", "#10203040",
      "--grid",     "7x0",         "--flip",       "--opacity",
      "0.3",        "--axes",      "--color",      "z*w",
      "--colormap", "magma",       "--t",          "1/3",
      "-q",         "--tolerance", "0.3px",        "--antialias",
      "3",          "--front",     "tomato",       "--normal-tolerance",
      "7"};
  std::vector<std::string> first = formulas;
  first.insert(first.end(), options.begin(), options.end());
  first.insert(first.end(), {"-o", "a.png", "-o", "a.toml"});
  make(first);
  make({"a.toml", "-q", "-o", "b.png", "-o", "b.toml"});
  EXPECT_EQ(content("a.png"), content("b.png"));
  EXPECT_EQ(content("a.toml"), content("b.toml"));
}

TEST_F(SceneFiles, OpenPicturesAgainAsTheyWere) {
  make({"torus", "r=0.5", "-s", "64x48", "--samples", "12x8", "--antialias", "1", "-o", "a.png"});
  make({"a.png", "-o", "b.png"});
  EXPECT_EQ(content("a.png"), content("b.png"));
}

TEST_F(SceneFiles, TakeOtherParametersAndOptions) {
  write("s.toml", "[params]\nR = 2\n[[surface]]\nz = \"R*u\"\n");
  make({"s.toml", "R=3", "--fov", "40", "-o", "t.toml"});
  EXPECT_EQ(content("t.toml"),
            "[params]\nR = 3\n\n[[surface]]\nz = \"R*u\"\n\n[camera]\nfov = 40\n");
  const std::string error = error_of(saddle({"s.toml", "r=3", "-o", "t.png"}), 2);
  EXPECT_NE(error.find("did you mean 'R'?"), std::string::npos) << error;
}

TEST_F(SceneFiles, AreFlippedBackByAnotherFlip) {
  write("s.toml", "[[surface]]\nz = \"u\"\nflip = true\n");
  make({"s.toml", "--flip", "-o", "t.toml"});
  EXPECT_EQ(content("t.toml"), "[[surface]]\nz = \"u\"\n");
}

TEST_F(SceneFiles, AreWhatShowPrints) {
  const Outcome shown = saddle({"show", "torus"});
  write("torus.toml", shown.out);
  make({"torus.toml", "-s", "64x48", "-o", "a.png"});
  make({"torus", "-s", "64x48", "-o", "b.png"});
  EXPECT_EQ(content("a.png"), content("b.png"));
}

TEST_F(SceneFiles, SayWhereTheyAreWrong) {
  write("s.toml", "[[surface]]\nz = \"cos(u)*foo(v)\"\n");
  EXPECT_EQ(error_of(saddle({"s.toml", "-o", "a.png"}), 2).substr(0, 83),
            "saddle: s.toml:2:13: z: unknown name 'foo'\n"
            "  z = \"cos(u)*foo(v)\"\n"
            "              ^~~\n");
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(SceneFiles, AreRefusedWhenTheyAreNone) {
  EXPECT_NE(error_of(saddle({"none.toml", "-o", "a.png"}), 2).find("there is no file none.toml"),
            std::string::npos);
  write("not.png", "nothing");
  error_of(saddle({"not.png", "-o", "a.png"}), 2);
  write("junk", std::string("\x7f\x45LF\x00\x01", 6));
  error_of(saddle({"junk", "-o", "a.png"}), 2);
  EXPECT_EQ(files(), (std::vector<std::string>{"junk", "not.png"}));
}

TEST_F(SceneFiles, GoToStandardOutput) {
  const Outcome run = saddle({"z=u", "-o", "-", "--format", "toml"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "[[surface]]\nz = \"u\"\n");
}

TEST_F(SceneFiles, ComeFromStandardInput) {
  make({"torus", "r=0.3", "-s", "40x30", "-o", "a.png", "-o", "a.toml"});
  const auto piped = [&](const std::string& command) {
    const std::string in_folder = "cd " + path(".").string() + " && ";
    return WEXITSTATUS(std::system((in_folder + command).c_str()));
  };
  const std::string program = program_path();
  for (const std::string file : {"a.toml", "a.png"}) {
    ASSERT_EQ(piped("cat " + file + " | " + program + " - -o b.toml"), 0) << file;
    EXPECT_EQ(content("b.toml"), content("a.toml")) << file;
  }
  ASSERT_EQ(piped(program + " show torus | " + program + " - r=0.3 -s 40x30 -o c.png"), 0);
  EXPECT_EQ(content("c.png"), content("a.png"));
  EXPECT_EQ(piped(program + " - -o d.png </dev/null 2>err"), 2);
  EXPECT_TRUE(contains(content("err"), "standard input is empty\n")) << content("err");
  EXPECT_EQ(piped("echo 'grif = 3' | " + program + " - -o d.png 2>err"), 2);
  EXPECT_TRUE(contains(content("err"), "saddle: standard input:1:1: unknown key 'grif'\n"))
      << content("err");
}

/// A sphere beside others, in a scene of its own.
std::string sphere_at(double x, double y) {
  const auto plus = [](double way) { return std::to_string(way) + "+"; };
  return "[[surface]]\nx = \"" + plus(x) + "sin(v)*cos(u)\"\ny = \"" + plus(y) +
         "sin(v)*sin(u)\"\nz = \"cos(v)\"\nu = [0, \"tau\"]\nv = [0, \"pi\"]\ngrid = \"off\"\n";
}

TEST_F(SceneFiles, MeshEachSurfaceForThePixelsThatItHas) {
  constexpr int kSide = 6;
  std::string many;
  for (int i = 0; i < kSide * kSide; ++i) many += sphere_at(2.5 * (i % kSide), 2.5 * (i / kSide));
  write("one.toml", sphere_at(0, 0));
  write("many.toml", many);
  const auto triangles = [this](const std::string& scene, std::vector<std::string> more) {
    more.insert(more.begin(), {scene, "-s", "600x600", "-o", "a.png", "--report", "r.json"});
    make(more);
    const nlohmann::json report = nlohmann::json::parse(content("r.json"));
    int sum = 0;
    for (const auto& surface : report["surfaces"]) sum += surface["triangles"].get<int>();
    return sum;
  };
  const int alone = triangles("one.toml", {});
  // A sphere's triangles are in proportion to its radius in pixels, a ninth here.
  EXPECT_LT(triangles("many.toml", {}), kSide * kSide * alone / 4);
  // The same sphere as large in the picture has the same triangles, whatever is beside it.
  const std::vector<std::string> near = {"--target", "0,0,0", "--distance", "4.3"};
  const int close = triangles("one.toml", near);
  EXPECT_LT(triangles("many.toml", near), close + kSide * kSide * alone / 4);
}

TEST_F(SceneFiles, MeshAlikeOnAnyNumberOfThreads) {
  std::string many;
  for (int i = 0; i < 9; ++i) many += sphere_at(2.5 * i, 0.1 * i);
  write("many.toml", many);
  make({"many.toml", "--threads", "1", "-o", "a.ply"});
  make({"many.toml", "--threads", "2", "-o", "b.ply"});  // side by side
  EXPECT_EQ(content("a.ply"), content("b.ply"));
}

}  // namespace
}  // namespace saddle
