#include "app/run/plan.h"

#include <algorithm>

#include "app/run/build_scene.h"
#include "app/run/written_files.h"

namespace saddle {
namespace {

Purpose purpose_of(const CommandLine& line, const std::vector<Output>& outputs,
                   const Scene& scene) {
  const auto is_picture = [](const Output& output) { return output.format->is_seen(); };
  const auto is_mesh = [](const Output& output) { return output.is(Format::Kind::Mesh); };
  Purpose purpose;
  purpose.picture = !line.run.reference.empty() || std::ranges::any_of(outputs, is_picture);
  for (const Output& output : outputs) {
    if (!is_picture(output)) continue;
    purpose.pixels = std::min(purpose.pixels, output.format->pixels_off(scene.picture.height));
  }
  purpose.mesh = !purpose.picture || std::ranges::any_of(outputs, is_mesh);
  return purpose;
}

/// The scene as its outputs need it.
Scene animated(Scene scene, bool frames) {
  if (frames && !scene.animation) scene.animation.emplace();
  return scene;
}

}  // namespace

Plan::Plan(const CommandLine& line)
    : outputs(checked_outputs(line)),
      timeline(animated(build_scene(line), has_frames(line, outputs))),
      shots(shots_of(line, timeline.scene(), outputs)),
      purpose(purpose_of(line, outputs, timeline.scene())) {
  std::vector<int> numbers;
  for (const Shot& shot : shots) {
    if (shot.frame) numbers.push_back(*shot.frame);
  }
  check_names_differ(line, outputs, numbers);
}

int Plan::frames() const {
  return static_cast<int>(
      std::ranges::count_if(shots, [](const Shot& shot) { return shot.frame.has_value(); }));
}

bool Plan::draws(const CommandLine& line) const {
  const auto is_drawn = [](const Output& output) { return output.format->is_drawn(); };
  return !line.run.reference.empty() || std::ranges::any_of(outputs, is_drawn);
}

bool Plan::needs_camera() const {
  const auto& tolerance = scene().mesh.tolerance;
  return purpose.picture || (tolerance && tolerance->pixels);
}

}  // namespace saddle
