// Names that would make a terminal do something: from scenes, pictures and the file system.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "base/file.h"
#include "base/image_png.h"
#include "base/utf8.h"
#include "cli/program.h"

namespace saddle {
namespace {

/// Clears the screen, writes to the clipboard, rings, begins a line, and ends one to write another.
constexpr const char* kName =
    R"(evil\u001b[2J\u001b]52;c;QQ==\u0007\u009b31m\u007f\rback\nsaddle: all is well)";

class Hostile : public ProgramTest {
 protected:
  void SetUp() override {
    std::ofstream(path("s.toml")) << "[[surface]]\nname = \"" << kName << "\"\nz = \"1/u\"\n"
                                  << "[[surface]]\nname = \"" << kName << " too\"\nz = \"t\"\n";
  }
};

/// Line breaks are the program's own.
void expect_harmless(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const Character c = decode_utf8(text, at);
    const bool shown = c.code >= 0x20 && (c.code < 0x7F || c.code > 0x9F);
    EXPECT_TRUE((shown && c.code != kReplacementCharacter) || c.code == '\n')
        << static_cast<unsigned>(c.code) << " at " << at << " of " << text;
    at += c.bytes;
  }
  EXPECT_FALSE(contains("\n" + text, "\nsaddle: all is well")) << text;
}

TEST_F(Hostile, WarningsAndSummariesShowNamesWithoutControlCharacters) {
  const Outcome scene = small({"s.toml", "-v", "-o", "a.png"});
  EXPECT_EQ(scene.status, 0) << scene.err;
  EXPECT_TRUE(contains(scene.err, "saddle: warning: evil?[2J")) << scene.err;
  EXPECT_TRUE(contains(scene.err, "\nevil?[2J")) << scene.err;
  expect_harmless(scene.err);
  const Outcome picture = small({"a.png", "-v", "-o", "b.png"});
  EXPECT_TRUE(contains(picture.err, "saddle: warning: evil?[2J")) << picture.err;
  expect_harmless(picture.err);
}

TEST_F(Hostile, CheckShowsNamesWithoutControlCharacters) {
  small({"s.toml", "-q", "-o", "a.png"});
  for (const char* name : {"s.toml", "a.png"}) {
    const Outcome run = saddle({"check", name});
    EXPECT_TRUE(run.out.starts_with("evil?[2J")) << run.out;
    expect_harmless(run.out);
    expect_harmless(run.err);
  }
}

TEST_F(Hostile, NamesOfFilesAreShownWithoutControlCharacters) {
  const std::string name = "d\x1b[31m\x9b\nsaddle: all is well";
  const Outcome film = saddle(
      {"z=u+t", "--frames", "2", "--background", "#00000000", "-s", "64x48", "-o", name + ".mp4"});
  EXPECT_EQ(film.status, 0) << film.err;
  EXPECT_TRUE(contains(film.err, "d?[31m??saddle: all is well.mp4: MP4 has")) << film.err;
  expect_harmless(film.err);
  for (const std::string& file : {name + "/a.png", "none" + name + "/b.png"}) {
    expect_harmless(error_of(small({"torus", "-o", file}), 1));
  }
  small({"torus", "-o", name + ".png"});
  const Outcome same = small({"torus", "-v", "-o", "c.png", "--reference", name + ".png"});
  EXPECT_EQ(same.status, 0) << same.err;
  expect_harmless(same.err);
}

TEST_F(Hostile, FilesOnStandardOutputAreAsTheyAre) {
  const Outcome scene = saddle({"s.toml", "-o", "-", "--format", "toml"});
  EXPECT_EQ(scene.status, 0) << scene.err;
  std::ofstream(path("again.toml")) << scene.out;
  EXPECT_EQ(saddle({"again.toml", "-o", "-", "--format", "toml"}).out, scene.out);
  EXPECT_TRUE(contains(saddle({"check", "s.toml", "--report", "-"}).out, "\\u001b[2J"));
}

/// A scene may ask for a picture or a film that takes hours.
TEST_F(Hostile, SizesAndFramesOfTheCommandLineWin) {
  std::ofstream(path("s.toml")) << "size = [16384, 16384]\n"
                                << "[animation]\nt = [0, 1]\nframes = 100000\n"
                                << "[[surface]]\nz = \"u*t\"\n";
  EXPECT_EQ(saddle({"s.toml", "-s", "16x12", "--frames", "2", "-o", "f%d.png"}).status, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"f0.png", "f1.png", "s.toml"}));
  EXPECT_EQ(read_png(path("f1.png")).image.width, 16);
}

}  // namespace
}  // namespace saddle
