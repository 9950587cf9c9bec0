#include "app/run/output_writer.h"

#include <ostream>
#include <utility>

namespace saddle {
namespace {

VideoOptions video_options(const Output& output, const Scene& scene) {
  VideoOptions options;
  options.format = output.format->video;
  options.width = scene.picture.width;
  options.height = scene.picture.height;
  options.fps = scene.animation->fps;
  const Number& alpha = scene.background.a;
  const bool is_part = !alpha.text.empty() || (alpha > 0 && alpha < 1);
  options.alpha = is_part ? Alpha::Part : alpha == 0 ? Alpha::Whole : Alpha::None;
  return options;
}

}  // namespace

OutputWriter::OutputWriter(std::span<const Output> outputs, const Scene& scene, unsigned threads,
                           bool holds_back)
    : outputs_(outputs), threads_(threads), holds_back_(holds_back) {
  if (holds_back_) allow_many_open_files();  // each has its lock
  for (const Output& output : outputs_) {
    if (!output.is(Format::Kind::Animation)) continue;
    films_.push_back({output.path, std::make_unique<Video>(video_options(output, scene))});
  }
}

void OutputWriter::put(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (!holds_back_) return write_to(path, write);
  StagedFile file(path == "-" ? "/dev/stdout" : path, write);
  const std::lock_guard lock(mutex_);
  held_.push_back(std::move(file));
}

void OutputWriter::write_meshes_of(const Shot& shot, const Scene& scene,
                                   std::span<const Mesh> meshes) {
  const auto begin = Clock::now();
  for (const Output& output : outputs_) {
    if (!output.is(Format::Kind::Mesh) || !shot.is_for(output)) continue;
    put(output.path_of(shot.frame.value_or(0)), [&](std::ostream& out) {
      output.format->write_mesh(out, {meshes, scene});
    });
  }
  milliseconds_ += milliseconds_since(begin);
}

void OutputWriter::start_writing(const Shot& shot, const Scene& scene, Image image) {
  behind_.start(
      [this, shot, scene, image = std::move(image)] { write_picture_of(shot, scene, image); });
}

void OutputWriter::write_picture_of(const Shot& shot, const Scene& scene, const Image& image) {
  for (const Output& output : outputs_) {
    if (!output.is(Format::Kind::Picture) || !shot.is_for(output)) continue;
    put(output.path_of(shot.frame.value_or(0)), [&](std::ostream& out) {
      output.format->write_picture(out, {image, scene, threads_});
    });
  }
  if (shot.frame) {
    for (const Film& film : films_) film.video->add(image);
  }
}

void OutputWriter::finish(const Scene& scene) {
  const auto begin = Clock::now();
  for (StagedFile& file : held_) file.publish();
  for (const Output& output : outputs_) {
    if (!output.is(Format::Kind::Scene)) continue;
    write_to(output.path, [&](std::ostream& out) { output.format->write_scene(out, scene); });
  }
  write_films();
  milliseconds_ += milliseconds_since(begin);
}

void OutputWriter::write_films() {
  for (const Film& film : films_) film.video->finish();
  for (const Film& film : films_) {
    write_to(film.path, [&](std::ostream& out) { film.video->write(out); });
  }
}

std::vector<std::string> OutputWriter::warnings() const {
  std::vector<std::string> warnings;
  for (const Film& film : films_) {
    if (const auto warning = film.video->warning()) warnings.push_back(film.path + ": " + *warning);
  }
  return warnings;
}

}  // namespace saddle
