#include "view/picture/exporter.h"

#include <charconv>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/format.h"
#include "export/formats/formats.h"
#include "scene/toml/scene_file.h"
#include "view/model/files.h"

namespace saddle {
namespace {

/// "1920x1080"
std::optional<GridSize> size_in(const std::string& text) {
  GridSize size{};
  const char* const end = text.data() + text.size();
  const auto [x, wrong] = std::from_chars(text.data(), end, size.u);
  if (wrong != std::errc() || x == end || *x != 'x') return std::nullopt;
  const auto [rest, also_wrong] = std::from_chars(x + 1, end, size.v);
  if (also_wrong != std::errc() || rest != end) return std::nullopt;
  return size;
}

std::string use_of(const Format& format) {
  switch (format.kind) {
    case Format::Kind::Picture:
      return "picture; a size may follow: 1920x1080";
    case Format::Kind::Mesh:
      return "mesh for " + std::string(format.use);
    case Format::Kind::Page:
      return format.takes_sliders ? "page that turns in a browser" : "drawing of lines, to print";
    case Format::Kind::Animation:
      return "film of t";
    case Format::Kind::Scene:
      return "scene file";
  }
  return "";
}

bool is_film(const Format& format) {
  return format.kind == Format::Kind::Animation;
}

/// The text before a space and a size.
std::pair<std::string, std::optional<GridSize>> parted(const std::string& typed) {
  const std::size_t space = typed.rfind(' ');
  if (space == std::string::npos) return {typed, std::nullopt};
  const auto size = size_in(typed.substr(space + 1));
  return size ? std::pair(typed.substr(0, space), size) : std::pair(typed, size);
}

std::string detail_of(const Format& format, const std::filesystem::path& path) {
  std::error_code ignored;
  return (std::filesystem::exists(path, ignored) ? "replace: " : "") + use_of(format);
}

}  // namespace

std::optional<Export> typed_export(const std::string& typed) {
  const auto [name, size] = parted(typed);
  const auto path = typed_path(name);
  if (path.stem().empty() || find_format(extension_of(path)) == nullptr) return std::nullopt;
  return Export{path, size};
}

std::vector<ExportChoice> export_choices(const std::string& title, const std::string& typed) {
  if (const auto whole = typed_export(typed)) {
    const Format& format = *find_format(extension_of(whole->path));
    return {{*whole, typed, detail_of(format, whole->path), is_film(format)}};
  }
  const auto [name, size] = parted(typed);
  const std::filesystem::path path(name);
  const std::string begun = extension_of(path);
  const std::string stem =
      begun.empty() ? name : name.substr(0, name.size() - path.extension().string().size());
  std::vector<ExportChoice> choices;
  for (const Format& format : formats()) {
    if (!format.extension.starts_with(begun)) continue;
    const std::string extension = "." + std::string(format.extension);
    const bool is_named = !stem.empty() && !stem.ends_with('/');
    const std::string file =
        is_named ? stem + extension : stem + free_file_name(title, extension).string();
    choices.push_back(
        {{typed_path(file), size}, file, detail_of(format, typed_path(file)), is_film(format)});
  }
  return choices;
}

/// In a window each line is saddle's.
std::string without_program(const std::string& words) {
  static constexpr std::string_view kProgram = "saddle: ";
  std::string rest;
  std::size_t begin = 0;
  while (begin < words.size()) {
    const std::size_t end = std::min(words.find('\n', begin), words.size() - 1) + 1;
    std::string line = words.substr(begin, end - begin);
    if (line.starts_with(kProgram)) line.erase(0, kProgram.size());
    rest += line;
    begin = end;
  }
  return rest;
}

Exporter::Exporter(std::filesystem::path program, unsigned threads, std::function<void()> wake)
    : program_(std::move(program)), threads_(threads), wake_(std::move(wake)) {}

Exporter::~Exporter() {
  if (child_) child_->interrupt();
}

void Exporter::write(const Scene& scene, const Export& file) {
  add({write_scene(scene), [file] { return file; }});
}

void Exporter::write_new(const Scene& scene, const std::string& extension) {
  const std::string title = scene.title;
  add({write_scene(scene),
       [title, extension] { return Export{free_file_name(title, extension)}; }});
}

void Exporter::add(Job job) {
  waiting_.push_back(std::move(job));
  if (waiting_.size() == 1) begin_next();
}

std::vector<std::string> Exporter::command_for(const Export& file) const {
  const std::string path = std::filesystem::absolute(file.path);  // no option, such as "-x.png"
  std::vector<std::string> command{program_, "-", "-o", path};
  if (file.size) {
    command.insert(command.end(), {"--size", formatted("%dx%d", file.size->u, file.size->v)});
  }
  if (threads_ > 0) command.insert(command.end(), {"--threads", std::to_string(threads_)});
  return command;
}

/// A process that cannot begin is told as one that fails; so is a folder that is gone.
void Exporter::begin_next() {
  const Job& job = waiting_.front();
  try {
    const Export file = job.file();
    child_ = std::make_unique<Child>(command_for(file), "saddle");
    worker_ = std::jthread([this, &job, file] { run(job.scene, file.path); });
  } catch (...) {
    news_ = caught_error().what();
    child_.reset();
    is_done_ = true;
    wake_();
  }
}

void Exporter::run(const std::string& scene, const std::filesystem::path& path) {
  bool failed = false;
  child_->feed(scene);
  try {
    child_->finish();
  } catch (const Error& error) {
    failed = true;
    news_ = error.what();
  }
  const std::string words = without_program(child_->words());
  if (!failed) {
    news_ = "wrote " + path.string() + (words.empty() ? "" : "\n" + words);
  } else if (!words.empty()) {
    news_ = words;
  }
  is_done_ = true;
  wake_();
}

std::optional<std::string> Exporter::pass() {
  if (!is_done_.exchange(false)) return std::nullopt;
  if (worker_.joinable()) worker_.join();
  child_.reset();
  waiting_.pop_front();
  std::string news = std::exchange(news_, {});
  if (!waiting_.empty()) begin_next();
  return news;
}

}  // namespace saddle
