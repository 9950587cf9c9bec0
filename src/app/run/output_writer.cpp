#include "app/run/output_writer.h"

#include <algorithm>
#include <iterator>
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

OutputWriter::OutputWriter(std::span<const Output> outputs, const Scene& scene,
                           const RunSettings& run)
    : outputs_(outputs),
      threads_(static_cast<unsigned>(run.threads)),
      holds_back_(run.strict),
      mesh_up_(run.mesh_up) {
  if (holds_back_) allow_many_open_files();  // each has its lock
  for (const Output& output : outputs_) {
    if (!output.is(Format::Kind::Animation)) continue;
    films_.push_back({output.path, std::make_unique<Video>(video_options(output, scene))});
  }
}

void OutputWriter::put(const std::vector<FileToWrite>& files) {
  if (!holds_back_) return write_all(files);
  std::vector<StagedFile> staged;
  staged.reserve(files.size());
  for (const FileToWrite& file : files) {
    staged.emplace_back(file.path == "-" ? "/dev/stdout" : file.path, file.write);
  }
  // The first of files that belong together gets its name last.
  const std::lock_guard lock(mutex_);
  std::move(staged.rbegin(), staged.rend(), std::back_inserter(held_));
}

bool OutputWriter::take_meshes(const Shot& shot, const Scene& scene, std::span<const Mesh> meshes) {
  const auto begin = Clock::now();
  mesh_files_.clear();
  shells_.clear();
  for (const Output& output : outputs_) {
    if (!output.is(Format::Kind::Mesh) || !shot.is_for(output)) continue;
    const Format& format = *output.format;
    if (!format.holds.open && shells_.empty()) shells_ = shells_of(meshes);
    MeshContent content{meshes, scene, shells_, threads_};
    content.factor = factor_of(format, content);
    content.y_up = mesh_up_ == MeshUp::Y;
    add_losses(output, losses_of(format, content));
    mesh_files_.push_back({output, shot.frame.value_or(0), std::move(content)});
  }
  milliseconds_ += milliseconds_since(begin);
  return !warnings_.empty();
}

void OutputWriter::add_losses(const Output& output, const std::vector<Loss>& losses) {
  for (const Loss& loss : losses) {
    if (!known_losses_.insert({&output, loss.kind}).second) continue;
    warnings_.push_back((output.path == "-" ? std::string(output.format->extension) : output.path) +
                        ": " + loss.text);
  }
}

void OutputWriter::write_meshes() {
  const auto begin = Clock::now();
  for (MeshFile& file : mesh_files_) put(mesh_files(file.output, file.frame, file.content));
  milliseconds_ += milliseconds_since(begin);
}

void OutputWriter::write_pages_of(const Shot& shot, const PageContent& content) {
  const auto begin = Clock::now();
  for (const Output& output : outputs_) {
    if (!output.is(Format::Kind::Page) || !shot.is_for(output)) continue;
    add_losses(output, losses_of(*output.format, content));
    const auto write = [&](std::ostream& out) { output.format->write_page(out, content); };
    put({{output.path_of(shot.frame.value_or(0)), write}});
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
    const auto write = [&](std::ostream& out) {
      output.format->write_picture(out, {image, scene, threads_});
    };
    put({{output.path_of(shot.frame.value_or(0)), write}});
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
    const auto write = [&](std::ostream& out) { output.format->write_scene(out, scene); };
    write_all({{output.path, write}});
  }
  write_films();
  milliseconds_ += milliseconds_since(begin);
}

void OutputWriter::write_films() {
  for (const Film& film : films_) film.video->finish();
  for (const Film& film : films_) {
    write_all({{film.path, [&](std::ostream& out) { film.video->write(out); }}});
  }
}

std::vector<std::string> OutputWriter::warnings() const {
  std::vector<std::string> warnings = warnings_;
  for (const Film& film : films_) {
    if (const auto warning = film.video->warning()) warnings.push_back(film.path + ": " + *warning);
  }
  return warnings;
}

}  // namespace saddle
