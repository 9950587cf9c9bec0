// saddle FORMULAS or NAME: check the outputs, then for each moment mesh what is another surface
// than before, draw and write; report.
#include <algorithm>
#include <future>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "app/build_scene.h"
#include "app/commands.h"
#include "app/framing.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/reference.h"
#include "app/run_report.h"
#include "app/scene_meshes.h"
#include "app/shots.h"
#include "base/image_png.h"
#include "export/video.h"
#include "render/picture.h"
#include "scene/instances.h"

namespace saddle {
namespace {

Purpose purpose_of(const CommandLine& line, const std::vector<Output>& outputs) {
  const auto is_picture = [](const Output& output) { return output.format->is_drawn(); };
  const auto is_mesh = [](const Output& output) { return output.is(Format::Kind::Mesh); };
  Purpose purpose;
  purpose.picture = !line.reference.empty() || std::ranges::any_of(outputs, is_picture);
  purpose.mesh = !purpose.picture || std::ranges::any_of(outputs, is_mesh);
  return purpose;
}

/// The scene as its outputs need it.
Scene animated(Scene scene, bool frames) {
  if (frames && !scene.animation) scene.animation.emplace();
  return scene;
}

VideoOptions video_options(const Output& output, const Scene& scene, unsigned threads) {
  VideoOptions options;
  options.format = output.format->video;
  options.width = scene.picture.width;
  options.height = scene.picture.height;
  options.fps = scene.animation->fps;
  const Number& alpha = scene.background.a;
  const bool is_part = !alpha.text.empty() || (alpha > 0 && alpha < 1);
  options.alpha = is_part ? Alpha::Part : alpha == 0 ? Alpha::Whole : Alpha::None;
  options.threads = threads;
  return options;
}

/// Writing beside drawing: one thing at a time, in order.
class Behind {
 public:
  /// Does `work` once the last is done. Throws what that has thrown.
  template <typename Work>
  void start(Work work) {
    wait();
    last_ = std::async(std::launch::async, std::move(work));
  }
  void wait() {
    if (last_.valid()) last_.get();
  }

 private:
  std::future<void> last_;
};

/// One run of the program.
class Run {
 public:
  Run(const CommandLine& line, Clock::time_point start)
      : Run(line, start, build_scene(line), checked_outputs(line)) {}

  void go() {
    for (std::size_t i = 0; i < shots_.size(); ++i) {
      show_progress(i);
      try {
        take(shots_[i]);
      } catch (const Error& error) {
        throw located(error, shots_[i]);
      }
    }
    behind_.wait();
    progress_.reset();
    finish();
  }

 private:
  struct Film {
    std::string path;
    std::unique_ptr<Video> video;
  };

  Run(const CommandLine& line, Clock::time_point start, Scene scene, std::vector<Output> outputs)
      : line_(line),
        start_(start),
        outputs_(std::move(outputs)),
        timeline_(animated(std::move(scene), has_frames(line, outputs_))),
        shots_(shots_of(line, timeline_.scene(), outputs_)),
        purpose_(purpose_of(line, outputs_)) {
    if (!line.reference.empty()) reference_ = read_png(line.reference).image;
    for (const Output& output : outputs_) {
      if (!output.is(Format::Kind::Animation)) continue;
      films_.push_back({output.path, std::make_unique<Video>(
                                         video_options(output, timeline_.scene(), line.threads))});
    }
    // OpenGL takes as long to start as a surface to tessellate.
    if (purpose_.picture) {
      starting_ = std::async(std::launch::async, start_picture_maker, line.renderer);
    }
    if (needs_camera()) framing_ = frame_scene(timeline_, line.threads);
    Purpose purpose = purpose_;
    purpose.moments = framing_.moments;
    meshes_.emplace(std::move(purpose), line.threads);
    if (frames() > 1) progress_.emplace(!line.quiet);
  }

  /// Pixels are drawn, or are what the mesh is to be exact to.
  bool needs_camera() const {
    const auto& tolerance = timeline_.scene().mesh.tolerance;
    return purpose_.picture || (tolerance && tolerance->pixels);
  }

  int frames() const {
    return static_cast<int>(
        std::ranges::count_if(shots_, [](const Shot& shot) { return shot.frame.has_value(); }));
  }

  void show_progress(std::size_t done) {
    if (done == 0) began_ = Clock::now();
    if (progress_) progress_->show_frames(done, shots_.size(), since(began_) / 1000);
  }

  /// What is wrong with the scene at a moment of an animation, with the moment.
  static Error located(const Error& error, const Shot& shot) {
    const std::string name = name_of(shot);
    if (name.empty() || error.status() == Status::Machine) return error;
    return with_hint_line(error, "this is " + name);
  }

  void take(const Shot& shot) {
    const Scene scene = timeline_.at(shot.t);
    Scene seen = scene;
    framing_.apply(seen);
    const std::vector<std::size_t> updated = meshes_->update(seen, name_of(shot));
    if (line_.strict && meshes_->warn()) fail_strictly();
    write_meshes_of(shot, scene);
    if (!purpose_.picture) return;
    if (!maker_) {
      maker_ = starting_.get();
      maker_->enter();
    }
    for (const std::size_t i : updated) maker_->set_surface(seen, i, meshes_->meshes()[i]);
    Image image = maker_->draw(seen, meshes_->meshes(), seen.picture);
    if (line_.strict && !maker_->warnings().empty()) fail_strictly();
    if (shot.still && reference_) compared_ = image;
    if (!report_.image) describe_image(image, seen);
    behind_.start([this, shot, scene, image = std::move(image)] { write(shot, scene, image); });
  }

  void write_meshes_of(const Shot& shot, const Scene& scene) {
    const auto begin = Clock::now();
    for (const Output& output : outputs_) {
      if (!output.is(Format::Kind::Mesh) || !shot.is_for(output)) continue;
      write_to(output.path_of(shot.frame.value_or(0)), [&](std::ostream& out) {
        output.format->write_mesh(out, {meshes_->meshes(), scene});
      });
    }
    report_.times.encode += since(begin);
  }

  /// Beside the drawing of the next picture.
  void write(const Shot& shot, const Scene& scene, const Image& image) {
    const auto begin = Clock::now();
    for (const Output& output : outputs_) {
      if (!output.is(Format::Kind::Picture) || !shot.is_for(output)) continue;
      write_to(output.path_of(shot.frame.value_or(0)), [&](std::ostream& out) {
        output.format->write_picture(out, {image, scene, line_.threads});
      });
    }
    if (shot.frame) {
      for (const Film& film : films_) film.video->add(image);
    }
    encoding_ += since(begin);
  }

  void describe_image(const Image& image, const Scene& scene) {
    report_.image = ImageReport{image.width,
                                image.height,
                                maker_->renderer(),
                                scene.surfaces.size(),
                                instances(scene).size(),
                                maker_->shader_texts()};
  }

  /// Films are there when all of them are whole.
  void write_films() {
    for (const Film& film : films_) film.video->finish();
    for (const Film& film : films_) {
      write_to(film.path, [&](std::ostream& out) { film.video->write(out); });
    }
  }

  void gather_warnings() {
    meshes_->report(report_);
    if (maker_) std::ranges::copy(maker_->warnings(), std::back_inserter(report_.warnings));
    if (report_.frames > 1 && !meshes_->move() && !timeline_.moves()) {
      report_.warnings.emplace_back("nothing depends on t: all frames are the same");
    }
    for (const Film& film : films_) {
      if (const auto warning = film.video->warning()) {
        report_.warnings.push_back(film.path + ": " + *warning);
      }
    }
    print_warnings(line_, report_.warnings);
  }

  /// With --strict a warning ends the run; the report has it, other outputs are not written.
  void check_strictness() {
    if (!line_.strict || report_.warnings.empty()) return;
    report_.times.total = since(start_);
    send_report(line_.report, report_);
    fail_on_warnings(report_);
  }

  void fail_strictly() {
    gather_warnings();
    check_strictness();
  }

  void finish() {
    report_.frames = frames();
    const auto shots = static_cast<double>(shots_.size());
    if (report_.frames > 0) report_.times.frame = since(began_) / shots;
    gather_warnings();
    check_strictness();
    const auto writing = Clock::now();
    for (const Output& output : outputs_) {
      if (!output.is(Format::Kind::Scene)) continue;
      write_to(output.path,
               [&](std::ostream& out) { output.format->write_scene(out, timeline_.scene()); });
    }
    write_films();
    report_.times.encode += encoding_ + since(writing);
    if (maker_) {
      report_.times.render = maker_->times();
      report_.image->shaders = maker_->shader_texts();
    }
    report_.times.total = since(start_);
    send_report(line_.report, report_);
    if (line_.verbose) std::cerr << summary(report_);
    if (!reference_) return;
    const std::string passed =
        check_against_reference(*compared_, *reference_, line_.reference, line_.threshold);
    if (line_.verbose) std::cerr << passed << '\n';
  }

  const CommandLine& line_;
  Clock::time_point start_;
  std::vector<Output> outputs_;
  Timeline timeline_;
  std::vector<Shot> shots_;
  Purpose purpose_;
  std::optional<Image> reference_;
  std::optional<Image> compared_;
  std::vector<Film> films_;
  std::future<std::unique_ptr<PictureMaker>> starting_;
  Framing framing_;
  std::optional<SceneMeshes> meshes_;
  std::unique_ptr<PictureMaker> maker_;
  RunReport report_;
  double encoding_ = 0;  ///< milliseconds, beside the drawing
  std::optional<Progress> progress_;
  Clock::time_point began_;
  Behind behind_;  // the last member: it ends before what it writes to
};

}  // namespace

void run_graph(const CommandLine& line, Clock::time_point start) {
  auto run = std::make_unique<Run>(line, start);
  run->go();
  // All is written, and the process about to end: taking OpenGL apart is left to the system.
  static_cast<void>(run.release());
}

}  // namespace saddle
