#include "view/model/session.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <ostream>
#include <sstream>
#include <utility>

#include "base/file.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 20;
/// Works of other windows that are kept; a larger scene than this is not kept.
constexpr std::size_t kMostWorks = 10;
constexpr std::size_t kMostBytes = std::size_t{1} << 20U;

constexpr const char* kRecent = "recent";
constexpr const char* kWork = "unsaved-";
constexpr const char* kWorkExtension = ".toml";

/// The process that keeps the work, 0: it is no work.
pid_t owner_of(const fs::path& path) {
  const std::string name = path.stem();
  if (!name.starts_with(kWork) || path.extension() != kWorkExtension) return 0;
  pid_t owner = 0;
  const std::string digits = name.substr(std::string(kWork).size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), owner);
  return error == std::errc() && end == digits.data() + digits.size() ? owner : 0;
}

bool is_running(pid_t process) {
  return kill(process, 0) == 0 || errno == EPERM;
}

/// The works of windows that have ended, the newest first.
std::vector<fs::path> left_works(const fs::path& directory) {
  std::vector<std::pair<fs::file_time_type, fs::path>> works;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    const pid_t owner = owner_of(entry->path());
    if (owner <= 0 || is_running(owner)) continue;
    std::error_code ignored;
    works.emplace_back(entry->last_write_time(ignored), entry->path());
  }
  std::ranges::sort(works, std::greater{});
  std::vector<fs::path> paths;
  paths.reserve(works.size());
  for (auto& [time, path] : works) paths.push_back(std::move(path));
  return paths;
}

fs::path from_environment(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr ? fs::path(value) : fs::path();
}

}  // namespace

fs::path state_directory() {
  const fs::path state = from_environment("XDG_STATE_HOME");
  if (state.is_absolute()) return state / "saddle";
  const fs::path home = from_environment("HOME");
  return home.is_absolute() ? home / ".local/state/saddle" : fs::path();
}

Session::Session(fs::path directory) : directory_(std::move(directory)) {}

std::vector<fs::path> Session::recent_files() const {
  std::vector<fs::path> files;
  try {
    std::istringstream lines(read_file(directory_ / kRecent));
    std::string line;
    while (files.size() < kMostRecent && std::getline(lines, line)) {
      std::error_code ignored;
      if (fs::is_regular_file(line, ignored)) files.emplace_back(line);
    }
  } catch (const std::exception&) {
  }
  return files;
}

void Session::remember_file(const fs::path& path) {
  if (directory_.empty()) return;
  try {
    const fs::path whole = fs::weakly_canonical(path);
    std::vector<fs::path> files = recent_files();
    std::erase(files, whole);
    files.insert(files.begin(), whole);
    files.resize(std::min(files.size(), kMostRecent));
    fs::create_directories(directory_);
    write_file_whole(directory_ / kRecent, [&](std::ostream& out) {
      for (const fs::path& file : files) out << file.string() << '\n';
    });
  } catch (const std::exception&) {
  }
}

fs::path Session::own_work() const {
  return directory_ / (kWork + std::to_string(getpid()) + kWorkExtension);
}

std::string Session::keep_work(const std::string& text) {
  if (directory_.empty()) return "neither XDG_STATE_HOME nor HOME names a folder";
  if (text == kept_) return "";
  if (text.size() > kMostBytes) return "the scene is larger than 1 MiB";
  try {
    fs::create_directories(directory_);
    write_file_whole(own_work(), [&](std::ostream& out) { out << text; });
    kept_ = text;
    thin_out();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

void Session::forget_work() {
  kept_.clear();
  std::error_code ignored;
  if (!directory_.empty()) fs::remove(own_work(), ignored);
}

std::optional<fs::path> Session::left_work() const {
  const std::vector<fs::path> works = left_works(directory_);
  return works.empty() ? std::nullopt : std::optional(works.front());
}

/// Keeps no more than the newest works.
void Session::thin_out() const {
  const std::vector<fs::path> works = left_works(directory_);
  for (std::size_t i = kMostWorks; i < works.size(); ++i) {
    std::error_code ignored;
    fs::remove(works[i], ignored);
  }
}

}  // namespace saddle
