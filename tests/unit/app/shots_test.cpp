#include "app/run/shots.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"

namespace saddle {
namespace {

Scene ten_frames() {
  Scene scene;
  scene.surfaces.emplace_back().z = "u";
  set_time_range(scene, 2, 7);
  scene.animation->frames = 10;
  scene.t = 3.25;
  return scene;
}

const Output kPicture{"x.png", find_format("png")};
const Output kNumbered{"x-%02d.png", find_format("png"), Span{2, 6}};
const Output kGif{"x.gif", find_format("gif")};
const Output kScene{"x.toml", find_format("toml")};

std::vector<double> moments(const std::vector<Shot>& shots) {
  std::vector<double> result;
  for (const Shot& shot : shots) result.push_back(shot.t);
  return result;
}

Error error_of(const CommandLine& line, const std::vector<Output>& outputs,
               const Scene& scene = ten_frames()) {
  try {
    shots_of(line, scene, outputs);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Input);
    return error;
  }
  ADD_FAILURE() << "no error";
  return {Status::Done, ""};
}

CommandLine with_range(int first, int last) {
  CommandLine line;
  line.run.frame_range = FrameRange{first, last};
  line.given.push_back({find_option("frame-range"), {}});
  return line;
}

TEST(Shots, AreTheScenesMomentForAPicture) {
  const auto shots = shots_of({}, ten_frames(), std::vector{kPicture, kScene});
  ASSERT_EQ(shots.size(), 1U);
  EXPECT_EQ(shots[0].t, 3.25);
  EXPECT_FALSE(shots[0].frame);
  EXPECT_TRUE(shots[0].is_for(kPicture));
}

TEST(Shots, AreAllFramesButTheEndOfTheRange) {
  const auto shots = shots_of({}, ten_frames(), std::vector{kNumbered});
  EXPECT_EQ(moments(shots), (std::vector<double>{2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5}));
  EXPECT_EQ(shots[3].frame, 3);
  EXPECT_TRUE(shots[3].is_for(kNumbered));
  EXPECT_FALSE(shots[3].is_for(kPicture));
}

TEST(Shots, AreTheMomentAndTheFramesWhereBothAreWanted) {
  const auto shots = shots_of({}, ten_frames(), std::vector{kGif, kPicture});
  ASSERT_EQ(shots.size(), 11U);
  EXPECT_EQ(shots[0].t, 3.25);
  EXPECT_FALSE(shots[0].is_for(kGif));
  EXPECT_TRUE(shots[1].is_for(kGif));
}

TEST(Shots, OfARangeHaveBothItsEnds) {
  const auto shots = shots_of(with_range(3, 5), ten_frames(), std::vector{kNumbered});
  EXPECT_EQ(moments(shots), (std::vector<double>{3.5, 4, 4.5}));
}

TEST(Shots, OfARangeOfOneFrameAreForPicturesToo) {
  const auto shots = shots_of(with_range(9, 9), ten_frames(), std::vector{kPicture, kNumbered});
  ASSERT_EQ(shots.size(), 1U);
  EXPECT_EQ(shots[0].t, 6.5);
  EXPECT_TRUE(shots[0].is_for(kPicture));
  EXPECT_TRUE(shots[0].is_for(kNumbered));
}

TEST(Shots, RefuseFramesThatAreNotThere) {
  const Error error = error_of(with_range(3, 10), {kNumbered});
  EXPECT_EQ(std::string(error.what()), "there is no frame 10");
  EXPECT_EQ(error.place().text.substr(error.place().span.begin), "10");
  EXPECT_NE(error.hint().find("0 to 9"), std::string::npos);
}

TEST(Shots, RefuseSeveralFramesForOneFile) {
  const Error error = error_of(with_range(3, 5), {kGif, kPicture});
  EXPECT_NE(std::string(error.what()).find("x.png is one picture, and 3 frames"),
            std::string::npos);
  EXPECT_NE(error.hint().find("frame-%04d.png"), std::string::npos);
}

TEST(Shots, RefuseOptionsAboutFramesWithoutAny) {
  CommandLine line;
  line.given.push_back({find_option("frames"), {}});
  EXPECT_EQ(std::string(error_of(line, {kPicture}).what()), "no output has frames");
  EXPECT_EQ(shots_of(line, ten_frames(), std::vector{kScene}).size(), 1U);  // they are in the scene
  EXPECT_EQ(std::string(error_of(with_range(0, 0), {kScene}).what()), "no output has frames");
}

TEST(Shots, RefuseWhatVideosCannotBe) {
  Scene fast = ten_frames();
  fast.animation->fps = 60;
  EXPECT_NE(error_of({}, {kGif}, fast).hint().find(".mp4"), std::string::npos);
  fast.animation->fps = 50;
  EXPECT_EQ(shots_of({}, fast, std::vector{kGif}).size(), 10U);
  fast.animation->fps = 60;
  EXPECT_EQ(shots_of({}, fast, std::vector{Output{"x.mp4", find_format("mp4")}}).size(), 10U);
  const Output numbered{"x-%d.mp4", find_format("mp4"), Span{2, 4}};
  EXPECT_NE(error_of({}, {numbered}).hint().find("leave out the number"), std::string::npos);
}

TEST(Outputs, NumberTheirFrames) {
  EXPECT_EQ(kNumbered.path_of(7), "x-07.png");
  EXPECT_EQ(kNumbered.path_of(12345), "x-12345.png");
  EXPECT_EQ((Output{"%d", find_format("png"), Span{0, 2}}).path_of(40), "40");
  EXPECT_EQ(kPicture.path_of(7), "x.png");
}

}  // namespace
}  // namespace saddle
