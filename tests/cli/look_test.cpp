// Proportions, themes, titles and lines from the command line.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/image_compare.h"
#include "base/image_png.h"
#include "cli/program.h"
#include "ply_mesh.h"

namespace saddle {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

class Look : public ProgramTest {
 protected:
  /// The scene that these arguments make.
  std::string scene(Arguments arguments) {
    arguments.insert(arguments.end(), {"-o", "-", "--format", "toml"});
    const Outcome run = saddle(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  }
  Image picture(Arguments arguments) {
    arguments.insert(arguments.end(), {"-s", "320x240", "-q", "-o", "p.png"});
    EXPECT_EQ(saddle(arguments).status, 0);
    return read_png(path("p.png")).image;
  }
};

const Arguments kNeedle = {"z=u^2+v^2", "u=-10:10", "v=-10:10"};

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_F(Look, NoticesThatAHeightIsCompressed) {
  const std::string notice =
      "saddle: z is compressed to 0.06 of its height in the picture; --scale equal leaves it as it "
      "is\n";
  const Outcome run = small(with(kNeedle, {"-o", "a.png", "-o", "a.ply", "--strict"}));
  EXPECT_EQ(run.status, 0) << "it is no warning";
  EXPECT_EQ(run.err, notice);
  EXPECT_EQ(small(with(kNeedle, {"-o", "a.png", "-q"})).err, "");
  EXPECT_EQ(small(with(kNeedle, {"-o", "a.png", "--scale", "equal"})).err, "");
  EXPECT_EQ(small(with(kNeedle, {"-o", "b.ply"})).err, "") << "there is no picture";
}

TEST_F(Look, KeepsMeshesAndReportsInTrueUnits) {
  for (const char* scale : {"auto", "1,1,0.01", "3,1,2"}) {
    const Json report = report_of(with(kNeedle, {"--scale", scale, "-q", "-o", "a.png"}));
    EXPECT_EQ(report["surfaces"][0]["bounds"][1], Json({10, 10, 200})) << scale;
  }
  const Arguments box = {"x=u", "y=v", "z=u", "--samples", "2x2"};
  ASSERT_EQ(saddle(with(box, {"-o", "true.ply"})).status, 0);
  ASSERT_EQ(
      saddle(with(box, {"--scale", "2,1,5", "-s", "64x48", "-o", "a.png", "-o", "scaled.ply"}))
          .status,
      0);
  EXPECT_TRUE(mesh_in_ply(read_file(path("true.ply"))) ==
              mesh_in_ply(read_file(path("scaled.ply"))));
}

TEST_F(Look, StretchesThePicture) {
  const Image stretched = picture({"z=u*v", "--scale", "1,1,3", "--samples", "64"});
  const Image formula = picture({"z=3*u*v", "--scale", "equal", "--samples", "64"});
  EXPECT_LT(compare_images(formula, stretched).mean, 0.005);
  EXPECT_GT(compare_images(formula, picture({"z=u*v", "--samples", "64"})).mean, 0.02);
  EXPECT_EQ(picture({"z=k*u", "k=4", "--scale", "1,1,1/k"}).rgba,
            picture({"z=k*u", "k=4", "--scale", "1,1,0.25"}).rgba);
  EXPECT_EQ(scene({"z=u", "--scale", "1,1,k", "k=2"}),
            "scale = [1, 1, \"k\"]\n\n[params]\nk = 2\n\n[[surface]]\nz = \"u\"\n");
}

TEST_F(Look, GivesWayToOptionsInAnyOrder) {
  const std::string first = scene({"torus", "--theme", "paper", "--background", "black"});
  EXPECT_EQ(first, scene({"torus", "--background", "black", "--theme", "paper"}));
  EXPECT_TRUE(contains(first, "theme = \"paper\"\nbackground = \"#000000\"\n"));
  EXPECT_FALSE(contains(first, "front"));
  write_file_whole(path("s.toml"), [](std::ostream& out) {
    out << "background = \"black\"\n[[surface]]\nz = \"u\"\nfront = \"#ffff80\"\n";
  });
  const std::string file = scene({"s.toml", "--theme", "light"});
  EXPECT_TRUE(contains(file, "theme = \"light\"\nbackground = \"#000000\"\n"));
  EXPECT_TRUE(contains(file, "front = { diffuse = \"#ffff80\" }\n"));
}

TEST_F(Look, OpensAPictureOfAThemeAgain) {
  const Image paper = picture({"torus", "--theme", "paper", "--line-width", "3", "--title", "T"});
  ASSERT_EQ(saddle({"p.png", "-o", "again.toml"}).status, 0);
  EXPECT_EQ(picture({"again.toml"}).rgba, paper.rgba);
  EXPECT_EQ(std::vector<int>(paper.pixel(0, 0), paper.pixel(0, 0) + 4),
            (std::vector<int>{255, 255, 255, 255}));
}

TEST_F(Look, DrawsATitleWithoutAxes) {
  const Image plain = picture({"torus"});
  const Image titled = picture({"torus", "--title", "A torus"});
  EXPECT_NE(titled.rgba, plain.rgba);
  const std::string file = scene({"torus", "--title", "A torus"});
  EXPECT_TRUE(contains(file, "title = \"A torus\"\nshow_title = true\n"));
  // An empty title is none, and has no room.
  const auto write = [&](const std::string& keys) {
    write_file_whole(path("s.toml"),
                     [&](std::ostream& out) { out << keys << "[[surface]]\nz = \"u\"\n"; });
    return picture({"s.toml"}).rgba;
  };
  EXPECT_EQ(write("title = \"\"\nshow_title = true\n"), write(""));
  EXPECT_EQ(write("title = \"\"\naxes = true\n"), write("axes = true\n"));
  EXPECT_NE(write("title = \"T\"\naxes = true\n"), write("axes = true\n"));
}

TEST_F(Look, LabelsAxes) {
  const std::string file = scene({"z=u", "--axes", "--labels", "time,,height in m"});
  EXPECT_TRUE(contains(file, "labels = [\"time\", \"\", \"height in m\"]\n"));
  EXPECT_NE(picture({"z=u", "--axes", "--labels", "a,b,c"}).rgba, picture({"z=u", "--axes"}).rgba);
}

}  // namespace
}  // namespace saddle
