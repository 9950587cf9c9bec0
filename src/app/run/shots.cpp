#include "app/run/shots.h"

#include <algorithm>

#include "base/error.h"
#include "base/format.h"
#include "export/pictures/video.h"
#include "scene/model/assignments.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

using FormatKind = Format::Kind;

std::string how_to_have_frames() {
  return "number the files: -o frame-%04d.png; or name a video, " +
         extension_list(FormatKind::Animation);
}

bool writes_scene(std::span<const Output> outputs) {
  return std::ranges::any_of(outputs, [](const Output& o) { return o.is(FormatKind::Scene); });
}

std::string frames_text(int count) {
  return "the animation has frames 0 to " + std::to_string(count - 1) + "; --frames sets how many";
}

FrameRange range_of(const CommandLine& line, const Animation& animation) {
  const FrameRange all{0, animation.frames - 1};
  if (!line.run.frame_range) return all;
  const FrameRange range = *line.run.frame_range;
  if (range.last <= all.last) return range;
  const std::string text = std::to_string(range.first) + ":" + std::to_string(range.last);
  throw Error(Status::Input, "there is no frame " + std::to_string(range.last),
              {"--frame-range", text, {text.find(':') + 1, text.size()}},
              frames_text(animation.frames));
}

/// An option about frames needs an output that has some, or a scene file that says so.
void check_frames_are_used(const CommandLine& line, std::span<const Output> outputs) {
  const Option* const given = line.last_given({"frames", "fps", "frame-range"});
  if (given == nullptr) return;
  const bool in_scene = given->scene != nullptr && writes_scene(outputs);
  if (in_scene || has_frames(line, outputs)) return;
  throw Error(Status::Input, "no output has frames", {dashed(*given), "", {}},
              how_to_have_frames());
}

/// `t=A` among the assignments, as against a range.
std::optional<std::string> assigned_moment(const CommandLine& line) {
  for (const std::string& argument : line.arguments()) {
    if (argument.find('=') == std::string::npos) continue;
    const Definition definition = parse_definition(argument);
    if (definition.name == "t" && !is_range(definition)) return argument;
  }
  return std::nullopt;
}

/// A moment that is asked for is that of some output.
void check_moment_is_used(const CommandLine& line, std::span<const Output> outputs,
                          std::span<const Shot> shots) {
  const auto is_own = [](const Shot& shot) { return !shot.frame; };
  if (writes_scene(outputs) || std::ranges::any_of(shots, is_own)) return;
  constexpr const char* kMessage = "no output shows this moment";
  constexpr const char* kWayOut =
      "frames show the range t=MIN:MAX; leave the moment out, or add -o FILE.png without "
      "--frame-range";
  if (line.last_given({"t"}) != nullptr) {
    throw Error(Status::Input, kMessage, {"--t", "", {}}, kWayOut);
  }
  if (const auto argument = assigned_moment(line)) {
    throw Error(Status::Input, kMessage, {"argument", *argument, {0, argument->size()}}, kWayOut);
  }
}

void check_videos(const Scene& scene, std::span<const Output> outputs) {
  for (const Output& output : outputs) {
    if (!output.is(FormatKind::Animation) && !output.is(FormatKind::Scene)) continue;
    if (output.number) {
      const std::string what = output.is(FormatKind::Animation) ? "a video" : "a scene";
      throw Error(Status::Input, what + " is one file for all frames",
                  {"--output", output.path, *output.number}, "leave out the number");
    }
    const VideoFormat* const video = output.format->video;
    if (video == nullptr || scene.animation->fps <= video->most_fps) continue;
    const std::string fps = format_number(scene.animation->fps);
    const std::string most = format_number(video->most_fps);
    throw Error(Status::Input,
                "a " + std::string(video->name) + " shows at most " + most + " frames per second",
                {"--fps", fps, {0, fps.size()}},
                video->beyond_most_fps + (": use --fps " + most) + ", or write an .mp4");
  }
}

/// Something is asked for that is of one moment.
bool wants_still(const CommandLine& line, std::span<const Output> outputs) {
  return !line.run.reference.empty() || std::ranges::any_of(outputs, &Output::is_still);
}

void check_one_frame(const CommandLine& line, std::span<const Output> outputs, int frames) {
  if (frames == 1 || !line.run.frame_range || !wants_still(line, outputs)) return;
  const auto still = std::ranges::find_if(outputs, &Output::is_still);
  const std::string what = still == outputs.end() ? "--reference" : still->path;
  throw Error(Status::Input,
              what + " is one picture, and " + std::to_string(frames) + " frames are asked for", {},
              how_to_have_frames());
}

}  // namespace

std::string name_of(const Shot& shot) {
  if (!shot.frame) return "";
  constexpr int kDigits = 6;
  return "frame " + std::to_string(*shot.frame) + ", t = " + rounded(shot.t, kDigits);
}

bool has_frames(const CommandLine& line, std::span<const Output> outputs) {
  return std::ranges::any_of(outputs, &Output::takes_frames) ||
         (line.run.frame_range && wants_still(line, outputs));
}

std::vector<Shot> shots_of(const CommandLine& line, const Scene& scene,
                           std::span<const Output> outputs) {
  check_frames_are_used(line, outputs);
  std::vector<Shot> shots;
  if (!has_frames(line, outputs)) {
    shots.push_back({scene.t, std::nullopt, true});
    return shots;
  }
  check_videos(scene, outputs);
  const Animation& animation = *scene.animation;
  const FrameRange range = range_of(line, animation);
  check_one_frame(line, outputs, range.count());
  if (!line.run.frame_range && wants_still(line, outputs)) {
    shots.push_back({scene.t, std::nullopt, true});
  }
  for (int frame = range.first; frame <= range.last; ++frame) {
    shots.push_back({animation.moment(frame), frame, line.run.frame_range.has_value()});
  }
  check_moment_is_used(line, outputs, shots);
  return shots;
}

}  // namespace saddle
