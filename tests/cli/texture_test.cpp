// Textures: where their pixels are, what is refused, and what carries them.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/file.h"
#include "base/image_png.h"
#include "cli/program.h"

namespace saddle {
namespace {

using Rgb = std::array<int, 3>;

const Rgb kRed{255, 0, 0};
const Rgb kLime{0, 255, 0};
const Rgb kBlue{0, 0, 255};
const Rgb kWhite{255, 255, 255};

class Textures : public ProgramTest {
 protected:
  void SetUp() override { write_picture("four.png", {{kRed, kLime}, {kBlue, kWhite}}); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  void write_picture(const std::string& name, const std::vector<std::vector<Rgb>>& rows,
                     int alpha = 255) {
    Image image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<std::uint8_t>(rows[y][x][c]);
        image.pixel(x, y)[3] = static_cast<std::uint8_t>(alpha);
      }
    }
    std::ofstream out(path(name), std::ios::binary);
    write_png(out, image);
  }
  std::string content(const std::string& name) const { return read_file(path(name)); }

  /// A square from above that fills the picture of 40x40 pixels, u to the right and v up.
  Image square(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {
        "z=0*u",   "--grid",   "off",         "--view",     "0,0,1", "--up",  "0,1,0",
        "--ortho", "--target", "0,0,0",       "--distance", "1",     "--fov", "90",
        "-s",      "40x40",    "--antialias", "1",          "-o",    "a.png"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome run = saddle(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return read_png(path("a.png")).image;
  }
  static Rgb at(const Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return {p[0], p[1], p[2]};
  }
  static void expect_near(const Rgb& got, const Rgb& wanted) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], 1) << "channel " << c;
  }
};

TEST_F(Textures, CoverTheRangesUToTheRightAndVUp) {
  const Image image =
      square({"--shading", "unlit", "--texture", "four.png", "--texture-filter", "nearest"});
  EXPECT_EQ(at(image, 5, 5), kRed);
  EXPECT_EQ(at(image, 35, 5), kLime);
  EXPECT_EQ(at(image, 5, 35), kBlue);
  EXPECT_EQ(at(image, 35, 35), kWhite);
}

TEST_F(Textures, AreTheDiffuseColourOfTheEquation) {
  write("s.toml",
        "[[surface]]\nz = \"0*u\"\ngrid = \"off\"\ntexture = \"four.png\"\ntexture-filter = "
        "\"nearest\"\n"
        "front = { specular = [0.2, 0.2, 0.2] }\n"
        "[[light]]\ndirection = [0, 0, 1]\ncolor = [0.5, 0.5, 0.5]\nambient = [0.1, 0.1, 0.1]\n");
  for (const char* shading : {"pixel", "vertex", "exact"}) {
    ASSERT_EQ(saddle({"s.toml", "--view", "0,0,1", "--up", "0,1,0", "--ortho", "-s", "40x40",
                      "--shading", shading, "-o", "a.png"})
                  .status,
              0);
    // (0.5 + 0.1) of the texel, and 0.5 * 0.2 of the highlight.
    const Image image = read_png(path("a.png")).image;
    expect_near(at(image, 12, 12), {179, 26, 26});
    expect_near(at(image, 28, 28), {179, 179, 179});
  }
}

TEST_F(Textures, RepeatAndWrap) {
  const std::vector<std::string> common = {
      "--shading",        "unlit", "--texture",        "four.png",
      "--texture-repeat", "2x1",   "--texture-filter", "nearest"};
  const auto row = [&](const std::string& wrap) {
    std::vector<std::string> options = common;
    options.insert(options.end(), {"--texture-wrap", wrap});
    const Image image = square(options);
    return std::array{at(image, 5, 5), at(image, 15, 5), at(image, 25, 5), at(image, 35, 5)};
  };
  EXPECT_EQ(row("repeat"), (std::array{kRed, kLime, kRed, kLime}));
  EXPECT_EQ(row("mirror"), (std::array{kRed, kLime, kLime, kRed}));
  EXPECT_EQ(row("clamp"), (std::array{kRed, kLime, kLime, kLime}));
}

TEST_F(Textures, ACheckerHasTheCellsOfTheGrid) {
  const std::vector<std::string> common = {"--shading", "unlit",   "--texture",
                                           "checker",   "--front", "white"};
  std::vector<std::string> options = common;
  options.insert(options.end(), {"--grid", "3x2", "--line-width", "0.1"});
  const Image image = square(options);
  expect_near(at(image, 10, 12), kWhite);
  expect_near(at(image, 30, 12), {102, 102, 102});
  expect_near(at(image, 10, 28), kWhite);
}

TEST_F(Textures, FollowRangesThatDependOnU) {
  ASSERT_EQ(
      saddle({"z=0*u",      "u=0:1",     "v=0:1+u", "--texture", "four.png", "--texture-filter",
              "nearest",    "--shading", "unlit",   "--grid",    "off",      "--view",
              "0,0,1",      "--up",      "0,1,0",   "--ortho",   "--target", "0.5,1,0",
              "--distance", "1",         "--fov",   "90",        "-s",       "80x80",
              "-o",         "a.png"})
          .status,
      0);
  const Image image = read_png(path("a.png")).image;
  const auto at_uv = [&](double u, double v) {
    return at(image, static_cast<int>((u + 0.5) * 40), static_cast<int>((2 - v) * 40));
  };
  EXPECT_EQ(at_uv(0.9, 1.05), kLime);  // more than half of 1.9
  EXPECT_EQ(at_uv(0.9, 0.85), kWhite);
  EXPECT_EQ(at_uv(0.1, 0.65), kRed);
  EXPECT_EQ(at_uv(0.1, 0.45), kBlue);
}

TEST_F(Textures, ThatCannotBeAreRefused) {
  const auto error = [this](const std::string& texture) {
    return error_of(small({"torus", "--texture", texture, "-o", "a.png"}), 2);
  };
  EXPECT_TRUE(contains(error("none.png"), "there is no file none.png"));
  EXPECT_TRUE(contains(error("."), ". is not a file"));
  write("text.png", "no picture");
  EXPECT_TRUE(contains(error("text.png"), "text.png is not a PNG file"));
  std::string wide = content("four.png");
  wide[18] = 0x4E;  // the width becomes 0x4E20, 20000
  wide[19] = 0x20;
  write("wide.png", wide);
  EXPECT_TRUE(contains(error("wide.png"), "20000x2 pixels")) << error("wide.png");
  write("damaged.png", content("four.png").substr(0, 50));
  EXPECT_TRUE(contains(error("damaged.png"), "damaged"));
  EXPECT_TRUE(contains(error_of(small({"torus", "--texture-wrap", "clamp", "-o", "a.png"}), 2),
                       "there is no picture"));
  EXPECT_TRUE(
      contains(error_of(small({"torus", "--texture", "checker", "--color", "z", "-o", "a.png"}), 2),
               "not both"));
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(Textures, OfSceneFilesStayInTheirFolder) {
  std::filesystem::create_directories(path("scenes/inside"));
  std::filesystem::copy(path("four.png"), path("scenes/inside/four.png"));
  std::filesystem::create_symlink(path("four.png"), path("scenes/link.png"));
  const auto run = [this](const std::string& texture) {
    write("scenes/s.toml", "[[surface]]\nz = \"u*v\"\ntexture = \"" + texture + "\"\n");
    return small({"scenes/s.toml", "-o", "a.png"});
  };
  EXPECT_EQ(run("inside/four.png").status, 0);
  for (const std::string& texture :
       {std::string("../four.png"), path("four.png").string(), std::string("inside/../../four.png"),
        std::string("link.png")}) {
    const std::string error = error_of(run(texture), 2);
    EXPECT_TRUE(contains(error, "outside of the scene's folder")) << texture << "\n" << error;
    EXPECT_TRUE(contains(error, "s.toml:3:")) << error;
  }
  EXPECT_TRUE(contains(error_of(run("none.png"), 2), "there is no file"));
}

TEST_F(Textures, GoWithScenesAndPictures) {
  const std::vector<std::string> options = {"-s", "60x40", "--grid", "off"};
  const auto make = [&](std::vector<std::string> arguments) {
    const Outcome run = saddle(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
  };
  make({"torus", "--texture", "four.png", "--texture-repeat", "3x2", "--texture-wrap", "mirror",
        "-s", "60x40", "-o", "a.png", "-o", "a.toml"});
  std::filesystem::remove(path("four.png"));
  std::filesystem::create_directory(path("elsewhere"));
  make({"a.png", "-o", "elsewhere/b.png", "-o", "elsewhere/b.toml"});
  make({"a.toml", "-o", "elsewhere/c.png"});
  EXPECT_EQ(content("a.png"), content("elsewhere/b.png"));
  EXPECT_EQ(content("a.png"), content("elsewhere/c.png"));
  EXPECT_EQ(content("a.toml"), content("elsewhere/b.toml"));
}

TEST_F(Textures, WarnOfWhatIsNotShown) {
  write_picture("clear.png", {{kRed, kLime}}, 100);
  EXPECT_TRUE(
      contains(small({"torus", "--texture", "clear.png", "-o", "a.png"}).err, "transparent"));
  EXPECT_TRUE(
      contains(small({"torus", "--texture", "four.png", "-o", "a.ply"}).err, "has no texture"));
  EXPECT_TRUE(contains(small({"torus", "--texture", "four.png", "-o", "a.html"}).err,
                       "a page has no texture"));
  EXPECT_EQ(small({"torus", "--texture", "four.png", "-o", "a.png"}).err, "");
}

TEST_F(Textures, AreInTheShaderWhereTheyAreUsed) {
  const std::string none = saddle({"show", "--shader", "torus"}).out;
  EXPECT_TRUE(contains(none, "//   no texture: no lookup in a picture\n")) << none;
  EXPECT_TRUE(contains(none, "//   no spot light: no cone test\n"));
  EXPECT_FALSE(contains(none, "texture_place"));
  EXPECT_TRUE(contains(none, "// Fragment shader\n#version 330 core\n"));
  const std::string some = saddle({"show", "--shader", "torus", "--texture", "four.png"}).out;
  EXPECT_TRUE(contains(some, "uniform sampler2D picture;"));
  EXPECT_FALSE(contains(some, "no texture:"));
}

}  // namespace
}  // namespace saddle
