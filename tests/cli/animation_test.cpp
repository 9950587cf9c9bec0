// Animations from the command line: frames, videos, and what goes wrong with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "base/file.h"
#include "base/image_png.h"
#include "cli/program.h"
#include "export/formats/load_scene.h"
#include "paths.h"
#include "sanitized.h"

namespace saddle {
namespace {

using Words = std::vector<std::string>;

/// A value of the environment for the time of a test.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name), old_(getenv(name)) {
    setenv(name, value.c_str(), 1);
  }
  ~Environment() { setenv(name_, old_.c_str(), 1); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string old_;
};

class AnimationTest : public ProgramTest {
 protected:
  /// Arguments with those of a small picture.
  static Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), {"-s", "64x48"});
    return words;
  }
  Outcome run(const Words& words, const Words& more) { return saddle(with(words, more)); }
  void run_well(const Words& words, const Words& more) {
    const Outcome outcome = run(words, more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }

  std::string content(const std::string& name) const { return read_file(path(name)); }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(content(name));
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
  }

  /// What ffprobe says of a video.
  std::string probe(const std::string& name, const std::string& entry) const {
    const std::string out = path("probe");
    const std::string command = "ffprobe -v error -count_frames -show_entries stream=" + entry +
                                " -of csv=p=0 '" + path(name).string() + "' >'" + out + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::string text = read_file(out);
    std::filesystem::remove(out);
    text.erase(text.find_last_not_of(",\n") + 1);
    return text;
  }
};

/// A wave that t deforms, and, in the scene file, a wheel that it turns; the camera fits itself.
const Words kWave = {"z=sin(3*u+t)*cos(v)", "t=0:tau", "--frames", "6"};
constexpr const char* kScene = R"toml(
[[surface]]
z = "(1+t)*u*v"
[[surface]]
name = "wheel"
x = "cos(u)*(2+cos(v))"
y = "sin(u)*(2+cos(v))"
z = "sin(v)"
u = ["0", "tau"]
v = ["0", "tau"]
in = "arm"
[[node]]
name = "arm"
transform = [ { rotate = ["90*t", 0, 1, 0] }, { translate = [4, 0, 0] } ]
[animation]
t = [0, 2]
frames = 6
)toml";

TEST_F(AnimationTest, TwoRangesDrawnApartAreOneRunToTheBit) {
  write("scene.toml", kScene);
  run_well({"scene.toml", "-o", "all-%02d.png"}, {});
  run_well({"scene.toml", "-o", "part-%02d.png"}, {"--frame-range", "0:2"});
  run_well({"scene.toml", "-o", "part-%02d.png"}, {"--frame-range", "3:5"});
  for (const char* number : {"00", "01", "02", "03", "04", "05"}) {
    const std::string frame = std::string(number) + ".png";
    EXPECT_EQ(content("part-" + frame), content("all-" + frame)) << frame;
  }
  EXPECT_FALSE(exists("all-06.png"));
  EXPECT_NE(content("all-00.png"), content("all-03.png"));
}

TEST_F(AnimationTest, AFrameOpensAgainAtItsOwnMoment) {
  write("scene.toml", kScene);
  run_well({"scene.toml", "-o", "f-%d.png"}, {"--frame-range", "4:4"});
  EXPECT_EQ(load_scene(path("f-4.png")).t, 2 * 4.0 / 6);
  EXPECT_EQ(saddle({"f-4.png", "-o", "again.png", "-o", "again.toml"}).status, 0);
  EXPECT_EQ(content("again.png"), content("f-4.png"));
  EXPECT_EQ(saddle({"again.toml", "-o", "third.png"}).status, 0);
  EXPECT_EQ(content("third.png"), content("f-4.png"));
}

TEST_F(AnimationTest, OneRunWritesAllKindsOfOutput) {
  run_well(kWave, {"-o", "w.gif", "-o", "w.mp4", "-o", "w.webm", "-o", "w-%d.png", "-o", "w.png",
                   "-o", "w.toml", "-o", "w.ply", "--t", "1", "--fps", "10"});
  EXPECT_EQ(files(), (Words{"w-0.png", "w-1.png", "w-2.png", "w-3.png", "w-4.png", "w-5.png",
                            "w.gif", "w.mp4", "w.ply", "w.png", "w.toml", "w.webm"}));
  for (const char* name : {"w.gif", "w.mp4", "w.webm"}) {
    EXPECT_EQ(probe(name, "width,height,r_frame_rate,nb_read_frames"), "64,48,10/1,6") << name;
  }
  EXPECT_EQ(probe("w.mp4", "codec_name,pix_fmt"), "h264,yuv420p");
  EXPECT_EQ(probe("w.webm", "codec_name"), "vp9");
  EXPECT_NE(content("w.gif").find("NETSCAPE2.0\x03\x01" + std::string(3, '\0')),
            std::string::npos);  // loops for ever
  const Scene scene = load_scene(path("w.toml"));
  EXPECT_EQ(scene.animation->frames, 6);
  EXPECT_EQ(scene.animation->fps, 10);
  EXPECT_EQ(scene.animation->to.text, "tau");
  EXPECT_EQ(scene.t, 1);
}

TEST_F(AnimationTest, APictureIsOfTheStartOfTheRange) {
  const Words formula = {"z=sin(3*u+t)*cos(v)"};
  run_well(formula, {"t=1:2", "-o", "range.png"});
  run_well(formula, {"t=1:2", "--t", "1", "-o", "moment.png"});
  run_well(formula, {"t=1:2", "--t", "1.5", "-o", "other.png"});
  EXPECT_EQ(content("range.png"), content("moment.png"));
  EXPECT_NE(read_png(path("other.png")).image.rgba, read_png(path("range.png")).image.rgba);
}

TEST_F(AnimationTest, WithoutARangeTRunsFrom0To1) {
  run_well({"z=sin(3*u+t)*cos(v)"}, {"-o", "w-%d.png", "--frames", "2", "--frame-range", "1:1"});
  EXPECT_EQ(load_scene(path("w-1.png")).t, 0.5);
}

TEST_F(AnimationTest, AVideoGoesToStandardOutput) {
  const Outcome outcome = run(kWave, {"-o", "-", "--format", "gif"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("GIF89a"));
  EXPECT_EQ(outcome.out.back(), ';');
}

TEST_F(AnimationTest, WhatTimeDoesNotMoveIsMeshedOnce) {
  write("scene.toml", kScene);
  run_well({"scene.toml", "-o", "f-%d.png"}, {"--report", "r.json"});
  const nlohmann::json report = json("r.json");
  EXPECT_EQ(report["frames"], 6);
  EXPECT_EQ(report["surfaces"][0]["meshes"], 6);
  EXPECT_EQ(report["surfaces"][1]["meshes"], 1);
  EXPECT_GT(report["times"]["frame"], 0);
}

TEST_F(AnimationTest, TwoHundredNodesShareOneMeshInMemory) {
  std::string scene = "[[surface]]\nz = \"u*v\"\nin = [";
  std::string nodes;
  for (int i = 0; i < 200; ++i) {
    const std::string name = "\"n" + std::to_string(i) + "\"";
    scene += name + ", ";
    nodes += "[[node]]\nname = " + name + "\ntransform = [{ translate = [" +
             std::to_string(3 * (i % 20)) + ", " + std::to_string(3 * (i / 20)) +
             ", \"sin(t)\"] }]\n";
  }
  write("scene.toml", scene + "]\n" + nodes + "[animation]\nt = [0, 1]\nframes = 3\n");
  run_well({"scene.toml", "-o", "f-%d.png"}, {"--report", "r.json"});
  const nlohmann::json report = json("r.json");
  EXPECT_EQ(report["image"]["meshes"], 1);
  EXPECT_EQ(report["image"]["instances"], 200);
  EXPECT_EQ(report["surfaces"][0]["meshes"], 1);
  EXPECT_GT(report["times"]["frame"], 0);
}

TEST_F(AnimationTest, ASurfaceMayVanishForSomeFrames) {
  const Words ball = {"x=t*cos(u)*cos(v)", "y=t*sin(u)*cos(v)",
                      "z=t*sin(v)",        "u=0:tau",
                      "v=-pi/2:pi/2",      "t=0:1",
                      "--frames",          "3"};
  const Outcome outcome = run(ball, {"-o", "f-%d.png"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(
      outcome.err,
      "saddle: warning: surface: the surface is a single point, (0, 0, 0) (frame 0, t = 0)\n");
  EXPECT_EQ(files().size(), 3U);
  const Outcome nowhere = run({"z=log(-1-t^2)"}, {"-o", "g.gif", "--frames", "2"});
  EXPECT_TRUE(error_of(nowhere, 3).starts_with("saddle: the surface is undefined everywhere\n"));
  EXPECT_FALSE(exists("g.gif"));
}

TEST_F(AnimationTest, SaysWhenNothingMoves) {
  const Outcome outcome = run({"z=u*v", "t=0:1"}, {"-o", "f-%d.png", "--frames", "2"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "saddle: warning: nothing depends on t: all frames are the same\n");
  EXPECT_EQ(run({"z=u*v", "t=0:1"}, {"-o", "g.gif", "--frames", "2", "--strict"}).status, 2);
  EXPECT_FALSE(exists("g.gif"));
}

TEST_F(AnimationTest, SaysThatNothingMovesBeforeItDraws) {
  const Outcome strict =
      run({"z=u*v", "t=0:1"}, {"-o", "g.gif", "--frames", "2", "--strict", "--report", "r.json"});
  EXPECT_EQ(strict.status, 2);
  const std::string report = read_file(path("r.json"));
  EXPECT_TRUE(contains(report, "nothing depends on t"));
  EXPECT_TRUE(contains(report, "\"surfaces\": []")) << "a mesh was made";
  const std::vector<std::vector<std::string>> moving = {
      {"--turntable"}, {"--view", "cos(t),sin(t),1"}, {"--scale", "1,1,1+t"}};
  for (std::vector<std::string> more : moving) {
    more.insert(more.end(), {"-o", "f-%d.png", "--frames", "2", "--strict"});
    const Outcome outcome = run({"z=u*v", "t=0:1"}, more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

TEST_F(AnimationTest, SaysThatMp4HasNoTransparency) {
  const Outcome outcome = run(kWave, {"-o", "w.mp4", "-o", "w.gif", "--background", "transparent"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err,
            "saddle: warning: w.mp4: MP4 has no transparency: the background is black\n");
}

TEST_F(AnimationTest, SaysThatGifHasNothingHalfTransparent) {
  const Outcome outcome = run(kWave, {"-o", "w.gif", "--background", "#ffffff80"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err,
            "saddle: warning: w.gif: GIF has nothing half transparent: the background is mixed "
            "with black\n");
}

TEST_F(AnimationTest, NumbersFilesNotFoldersAndKeepsPercentSigns) {
  std::filesystem::create_directory(path("a%d"));
  run_well({"z=u*v"}, {"-o", "a%d/still.png", "-o", "100%%d.png"});
  run_well(kWave, {"-o", "a%d/100%%-%d.png", "--frame-range", "2:2"});
  EXPECT_TRUE(exists("a%d/still.png"));
  EXPECT_TRUE(exists("100%d.png"));
  EXPECT_TRUE(exists("a%d/100%-2.png"));
}

TEST_F(AnimationTest, KeepsTheBoxAndTheColoursOfAllItsTime) {
  const Outcome outcome =
      saddle({"z=t*(2-u^2-v^2)", "t=0:2", "--color", "z", "--axes", "--grid", "off", "--frames",
              "4", "-s", "320x240", "-o", "f-%d.png", "--frame-range", "0:2"});
  EXPECT_EQ(outcome.err, "");
  // The first frame is flat, at 0: purple, the first colour. With a range of its own it would be in
  // the middle of one, which is green.
  const Image first = read_png(path("f-0.png")).image;
  const std::uint8_t* const low = first.pixel(155, 177);
  EXPECT_GT(int{low[2]}, 20);
  EXPECT_GT(int{low[2]}, 4 * low[1]);
  // What is around the surface stays: the bar with its numbers, and the box's labels at the left.
  const Image third = read_png(path("f-2.png")).image;
  for (int y = 0; y < first.height; ++y) {
    for (const auto& [begin, end] : {std::pair(0, 90), std::pair(250, 320)}) {
      EXPECT_TRUE(std::equal(first.pixel(begin, y), first.pixel(begin, y) + 4 * (end - begin),
                             third.pixel(begin, y)))
          << y;
    }
  }
}

TEST_F(AnimationTest, SaysAtWhichFrameANumberIsWrong) {
  write("scene.toml",
        "[[surface]]\nz = \"u\"\nfront = { shininess = \"20*sin(10*t)\" }\n"
        "[animation]\nt = [0, 1]\n");
  const std::string error = error_of(run({"scene.toml"}, {"-o", "f-%d.png"}), 2);
  EXPECT_NE(error.find("must be at least 0"), std::string::npos) << error;
  EXPECT_NE(error.find("t = "), std::string::npos) << error;
}

TEST_F(AnimationTest, RefusesWhatCannotBe) {
  const std::map<std::string, Words> table = {
      {"the range of t is empty", {"t=1:1", "-o", "a.gif"}},
      {"the range of t runs backwards", {"t=2:1", "-o", "a.gif"}},
      {"there is no frame 120", {"-o", "f-%d.png", "--frame-range", "0:120"}},
      {"a range of frames is FIRST:LAST", {"-o", "f-%d.png", "--frame-range", "7"}},
      {"this range is empty", {"-o", "f-%d.png", "--frame-range", "5:4"}},
      {"not a whole number", {"-o", "f-%d.png", "--frame-range", "0:x"}},
      {"must be from 0 to 999999", {"-o", "f-%d.png", "--frame-range", "-1:4"}},
      {"must be from 1 to 1000000", {"-o", "a.gif", "--frames", "0"}},
      {"must be more than 0.01 and less than 1000", {"-o", "a.gif", "--fps", "1e-9"}},
      {"two places for the frame's number", {"-o", "f-%d-%03d.png"}},
      {"the frame's number has too many digits", {"-o", "f-%012d.png"}},
      {"f.png is one picture, and 120 frames are asked for",
       {"-o", "f.png", "--frame-range", "0:119"}},
      {"no output has frames", {"-o", "f.png", "--frames", "10"}},
      {"a video is one file for all frames", {"-o", "f-%d.gif"}},
      {"a scene is one file", {"-o", "f-%d.toml"}},
      {"a GIF shows at most 50 frames per second", {"-o", "f.gif", "--fps", "60"}},
      {"unknown extension '.avi'", {"-o", "f.avi"}},
      {"no output shows this moment", {"-o", "f.gif", "--t", "1"}},
      {"argument = t=0.5", {"t=0.5", "-o", "f-%d.png"}},
      {"no output shows this moment", {"t=0:2", "--t", "1", "-o", "f.png", "--frame-range", "1:1"}},
  };
  for (const auto& [message, words] : table) {
    const std::string error = error_of(run({"z=u*t"}, words), 2);
    EXPECT_NE(error.find(message), std::string::npos) << error;
    EXPECT_NE(error.find('\n'), error.size() - 1) << "no way out: " << error;
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(AnimationTest, NamesThePackageOfFfmpegBeforeAnythingIsDrawn) {
  const Environment path("PATH", "/nonexistent");
  const std::string error = error_of(run(kWave, {"-o", "w-%d.png", "-o", "w.gif"}), 1);
  EXPECT_NE(error.find("cannot run ffmpeg"), std::string::npos) << error;
  EXPECT_NE(error.find("install the package ffmpeg"), std::string::npos) << error;
  EXPECT_TRUE(files().empty());
}

TEST_F(AnimationTest, LeavesNoVideoWhenFfmpegDies) {
  write("ffmpeg", "#!/bin/sh\nhead -c 20000 >/dev/null\necho 'x: it had enough' >&2\nexit 3\n");
  std::filesystem::permissions(path("ffmpeg"), std::filesystem::perms::owner_all);
  const Environment path("PATH", folder_.string() + ":" + getenv("PATH"));
  const std::string error = error_of(run(kWave, {"-o", "w.mp4"}), 1);
  EXPECT_NE(error.find("ffmpeg failed: x: it had enough"), std::string::npos) << error;
  EXPECT_EQ(files(), Words{"ffmpeg"});
}

TEST_F(AnimationTest, LeavesNothingWhenInterrupted) {
  const std::string command = "cd '" + folder_.string() + "' && timeout -s INT 1 '" +
                              program_path() +
                              "' z='sin(u+t)' -o w.gif --frames 100000 -s 64x48 2>err";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_EQ(files(), Words{"err"});
  EXPECT_EQ(content("err"), "");
}

TEST_F(AnimationTest, ShowsItsProgressOnATerminalAlone) {
  const auto on_terminal = [&](const std::string& words, bool may_fail = false) {
    const std::string command = "cd '" + folder_.string() + "' && script -qec \"'" +
                                program_path() + "' " + words + "\" /dev/null >out </dev/null";
    const int status = std::system(command.c_str());
    if (!may_fail) {
      EXPECT_EQ(status, 0) << content("out");
    }
    return content("out");
  };
  const auto has_bar = [](const std::string& shown, const std::string& what) {
    return shown.find("[") != std::string::npos && shown.find(" % ") != std::string::npos &&
           shown.find(what) != std::string::npos;
  };
  // A fast machine draws 300 of these frames in less than a second; with a sanitizer, one.
  const std::string frames = kIsSanitized ? "40" : "900";
  const std::string film = "z='sin(u+t)' -o w-%d.png -s 400x300 --frames " + frames + " ";
  const std::string shown = on_terminal(film);
  EXPECT_TRUE(has_bar(shown, " of " + frames + ", ")) << shown;
  EXPECT_NE(shown.find(" left"), std::string::npos) << shown;
  EXPECT_EQ(shown.substr(shown.rfind('\r')), "\r\033[K") << shown;  // gone at the end
  EXPECT_EQ(on_terminal(film + "-q"), "");
  const auto begin = std::chrono::steady_clock::now();
  const std::string brief = on_terminal("torus -s 16x16 -o short.png");
  const bool is_brief = std::chrono::steady_clock::now() - begin < std::chrono::seconds(1);
  if (is_brief) {
    EXPECT_EQ(brief, "");
  }
  // Hundreds of sheets take a fast machine two seconds. With a sanitizer the time may end before
  // there is a mesh.
  const std::string hard = "x='sin(100*u*v)' y='cos(130*u+v)' z='sin(170*v-u*u)' --max-time 6 ";
  EXPECT_TRUE(has_bar(on_terminal(hard + "-o a.ply", kIsSanitized), "meshing"));
  EXPECT_TRUE(has_bar(on_terminal("check " + hard, kIsSanitized), "checking 1 of 2, meshing"));
}

TEST_F(AnimationTest, FilmsAreTheSameOnAnyNumberOfThreads) {
  // Tall enough for an encoder that cuts frames into a slice for each thread.
  const Words film = {"z=sin(3*u+t)*cos(v)", "t=0:tau", "--frames", "8", "-s", "256x256"};
  const auto make = [&](const std::string& threads) {
    Words words = film;
    const std::string name = "f" + threads;
    words.insert(words.end(), {"-o", name + ".mp4", "-o", name + ".webm", "-o", name + ".gif"});
    words.insert(words.end(), {"--threads", threads});
    EXPECT_EQ(saddle(words).status, 0);
  };
  make("1");
  for (const std::string threads : {"2", "3", "4", "8"}) {
    make(threads);
    for (const char* type : {".mp4", ".webm", ".gif"}) {
      EXPECT_TRUE(content("f" + threads + type) == content(std::string("f1") + type))
          << type << " on " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace saddle
