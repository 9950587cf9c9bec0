// saddle FORMULAS or NAME: check the outputs, then for each moment mesh what is another surface
// than before, draw and write; report.
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "app/commands/commands.h"
#include "app/report/progress.h"
#include "app/report/reference.h"
#include "app/report/run_report.h"
#include "app/run/output_writer.h"
#include "app/run/picture_drawer.h"
#include "app/run/plan.h"
#include "app/run/scene_meshes.h"
#include "base/activity.h"
#include "base/format.h"
#include "base/standard_streams.h"
#include "render/picture/framing.h"
#include "scene/model/prepare.h"
#include "scene/model/strokes.h"

namespace saddle {
namespace {

/// Digits of a factor in a notice.
constexpr int kScaleDigits = 2;

/// Adds the moment to an error of the scene at a moment of an animation.
Error located(const Error& error, const Shot& shot) {
  const std::string name = name_of(shot);
  if (name.empty() || error.status() == Status::Machine) return error;
  return with_hint_line(error, "this is " + name);
}

std::optional<ReferenceCheck> reference_of(const CommandLine& line) {
  if (line.run.reference.empty()) return std::nullopt;
  return ReferenceCheck(line.run.reference, line.run.threshold);
}

std::optional<PictureDrawer> drawer_for(const CommandLine& line, const Plan& plan) {
  if (!plan.draws(line)) return std::nullopt;
  return PictureDrawer(line.run.renderer);
}

Framing framing_of(Plan& plan, unsigned threads) {
  return plan.needs_camera() ? frame_scene(plan.timeline, threads) : Framing();
}

/// The plan's, at the moments of the framing, or at that of the still picture.
Purpose purpose_of(Plan& plan, const Framing& framing, unsigned threads) {
  Purpose purpose = plan.purpose;
  purpose.moments = framing.moments;
  if (plan.needs_camera() && !plan.scene().animation) {
    Scene still = plan.timeline.at(plan.scene().t);
    framing.apply(still);
    purpose.moments = moments_of_still(still, threads);
  }
  return purpose;
}

/// One run of the program: its stages in their order.
class Run {
 public:
  Run(const CommandLine& line, Clock::time_point start)
      : line_(line),
        start_(start),
        progress_(std::in_place, !line.run.quiet),
        plan_(line),
        reference_(reference_of(line)),
        writer_(plan_.outputs, plan_.scene(), line.run),
        drawer_(drawer_for(line, plan_)),
        framing_(framing_of(plan_, line.run.threads)),
        meshes_(purpose_of(plan_, framing_, line.run.threads), line.run.threads) {}

  void go() {
    notice();
    warn_of_equal_frames();
    const auto begin = Clock::now();
    take_shots();
    report_.frames = plan_.frames();
    if (report_.frames > 0) {
      report_.times.frame = milliseconds_since(begin) / static_cast<double>(plan_.shots.size());
    }
    gather_warnings();
    if (line_.run.strict && !report_.warnings.empty()) fail_strictly();
    {
      const Activity writing("writing");
      writer_.finish(plan_.scene());
    }
    progress_.reset();
    report();
    if (!reference_) return;
    const std::string passed = reference_->compare();
    if (line_.run.verbose) tell(passed);
  }

 private:
  /// Tells about a compressed height, which is no warning.
  void notice() const {
    if (!framing_.scale || line_.run.quiet) return;
    tell("saddle: z is compressed to " + rounded(framing_.scale->z, kScaleDigits) +
         " of its height in the picture; --scale equal leaves it as it is");
  }

  /// Before the first frame is drawn: an animation may take hours.
  void warn_of_equal_frames() {
    if (plan_.frames() < 2) return;
    const Scene scene = plan_.timeline.at(plan_.shots[0].t);
    const auto moves = [&](const SurfaceSpec& spec) { return bind_surface(scene, spec).moves; };
    if (plan_.timeline.moves() || std::ranges::any_of(scene.surfaces, moves)) return;
    report_.warnings.emplace_back("nothing depends on t: all frames are the same");
    print_warnings(line_, report_.warnings);
    told_ = report_.warnings.size();
    if (line_.run.strict) fail_strictly();
  }

  void take_shots() {
    Activity frames(plan_.frames() > 0 ? "frame" : "", plan_.shots.size());
    for (const Shot& shot : plan_.shots) {
      try {
        take(shot);
      } catch (const Error& error) {
        throw located(error, shot);
      }
      frames.advance();
    }
    const Activity writing("writing");
    writer_.wait();
  }

  void take(const Shot& shot) {
    const Scene scene = with_strokes(plan_.timeline.at(shot.t));
    Scene seen = scene;
    framing_.apply(seen);
    const std::vector<std::size_t> updated = meshes_.update(seen, name_of(shot));
    if (line_.run.strict && meshes_.warn()) warn_and_fail();
    if (writer_.take_meshes(shot, scene, meshes_.meshes()) && line_.run.strict) warn_and_fail();
    writer_.write_meshes();
    writer_.write_pages_of(shot, {meshes_.meshes(), scene, seen, line_.run.sliders,
                                  line_.run.fragment, line_.run.renderer});
    if (!drawer_) return;
    Image image = draw(seen, updated);
    if (line_.run.strict && !drawer_->warnings().empty()) warn_and_fail();
    if (shot.still && reference_) reference_->take(image);
    if (!report_.image) report_.image = drawer_->describe(image, seen);
    writer_.start_writing(shot, scene, std::move(image));
  }

  Image draw(const Scene& seen, std::span<const std::size_t> updated) {
    const Activity drawing("drawing");
    return drawer_->draw(seen, meshes_.meshes(), updated);
  }

  void gather_warnings() {
    const auto add = [this](const std::vector<std::string>& warnings) {
      std::ranges::copy(warnings, std::back_inserter(report_.warnings));
    };
    add(warnings_of(plan_.scene()));
    meshes_.report(report_);
    if (drawer_) {
      add(drawer_->warnings());
      report_.findings = drawer_->findings();
      for (const SceneFinding& found : report_.findings) add({warning_of(found)});
    }
    add(writer_.warnings());
    print_warnings(line_, std::span(report_.warnings).subspan(told_));
  }

  void warn_and_fail() {
    gather_warnings();
    fail_strictly();
  }

  /// With --strict a warning ends the run; the report has it, and no other output gets its name.
  void fail_strictly() {
    report_.times.encode = writer_.milliseconds();
    report_.times.total = milliseconds_since(start_);
    send_report(line_.run.report, report_);
    fail_on_warnings(report_);
  }

  void report() {
    report_.times.encode = writer_.milliseconds();
    if (drawer_) {
      report_.times.render = drawer_->times();
      for (std::size_t i = 0; i < report_.surfaces.size(); ++i) {
        report_.surfaces[i].culls_backs = drawer_->culls(i);
      }
    }
    report_.times.total = milliseconds_since(start_);
    send_report(line_.run.report, report_);
    if (line_.run.verbose) tell(summary(report_));
  }

  const CommandLine& line_;
  Clock::time_point start_;
  std::optional<Progress> progress_;
  Plan plan_;
  std::optional<ReferenceCheck> reference_;
  OutputWriter writer_;
  std::optional<PictureDrawer> drawer_;  ///< if pictures are drawn
  Framing framing_;
  SceneMeshes meshes_;
  RunReport report_;
  std::size_t told_ = 0;  ///< warnings of the report that are printed
};

}  // namespace

void run_graph(const CommandLine& line, Clock::time_point start) {
  remove_results_of_comparison(line);
  auto run = std::make_unique<Run>(line, start);
  run->go();
  // All is written, and the process about to end: taking OpenGL apart is left to the system.
  static_cast<void>(run.release());
}

}  // namespace saddle
