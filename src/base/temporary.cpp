#include "base/temporary.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace saddle {
namespace {

/// A temporary file as the handler knows it. A handler may neither allocate nor lock, so entries
/// and their paths are never freed; a free entry is used again.
struct Entry {
  std::atomic<bool> is_live = false;
  std::vector<char> path = {};  ///< with its zero; changed only while the entry is not live
  Entry* next = nullptr;
};

std::atomic<Entry*> entries = nullptr;
static_assert(std::atomic<Entry*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

/// Entries that are in no use. Only for code outside of the handler.
struct FreeEntries {
  std::mutex mutex = {};
  std::vector<Entry*> list = {};
};

FreeEntries& free_entries() {
  static auto* const all = new FreeEntries();  // files may be written until the very end
  return *all;
}

Entry* claim_entry(const std::string& path) {
  FreeEntries& free = free_entries();
  const std::lock_guard lock(free.mutex);
  Entry* entry = nullptr;
  if (free.list.empty()) {
    entry = new Entry();
    entry->next = entries;
    entries = entry;
  } else {
    entry = free.list.back();
    free.list.pop_back();
  }
  entry->path.assign(path.c_str(), path.c_str() + path.size() + 1);
  entry->is_live = true;
  return entry;
}

void release_entry(Entry* entry) {
  entry->is_live = false;
  FreeEntries& free = free_entries();
  const std::lock_guard lock(free.mutex);
  free.list.push_back(entry);
}

extern "C" void remove_temporaries_and_die(int signal_number) {
  for (const Entry* entry = entries; entry != nullptr; entry = entry->next) {
    if (entry->is_live) unlink(entry->path.data());
  }
  // SA_RESETHAND has restored the default; the signal is delivered when this handler returns.
  raise(signal_number);
}

constexpr int kRandomLetters = 8;  // 36^8 names: a clash in one folder will not happen
constexpr std::string_view kNameLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
/// Between a file's name and the random letters. No other program's temporaries look like this.
constexpr std::string_view kMark = ".saddle-";

std::string random_letters(int count) {
  std::random_device device;
  std::uniform_int_distribution<std::size_t> index(0, kNameLetters.size() - 1);
  std::string text;
  for (int i = 0; i < count; ++i) text += kNameLetters[index(device)];
  return text;
}

/// `name` cut to `bytes`, not inside of a UTF-8 sequence.
std::string cut_name(std::string name, std::size_t bytes) {
  if (name.size() <= bytes) return name;
  while (bytes > 0 && (static_cast<unsigned char>(name[bytes]) & 0xC0u) == 0x80) --bytes;
  name.resize(bytes);
  return name;
}

std::filesystem::path beside(const std::filesystem::path& target) {
  const std::size_t added = 1 + kMark.size() + kRandomLetters;
  const std::string name = cut_name(target.filename().string(), NAME_MAX - added);
  return target.parent_path() / ("." + name + std::string(kMark) + random_letters(kRandomLetters));
}

/// Whether beside() makes such names.
bool is_temporary_name(std::string_view name) {
  if (!name.starts_with('.') || name.size() < kMark.size() + kRandomLetters) return false;
  const std::string_view end = name.substr(name.size() - kMark.size() - kRandomLetters);
  return end.starts_with(kMark) &&
         end.find_first_not_of(kNameLetters, kMark.size()) == std::string_view::npos;
}

/// Removes a file that its run has left behind: it is ours, and no process holds its lock. A
/// name that has become another file's meanwhile stays.
void remove_if_left(int folder, const char* name) {
  const Descriptor file(
      openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat opened {};
  struct stat named {};
  if (!file || fstat(file.number(), &opened) != 0 || !S_ISREG(opened.st_mode)) return;
  if (opened.st_uid != geteuid() || flock(file.number(), LOCK_EX | LOCK_NB) != 0) return;
  if (fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) != 0) return;
  if (named.st_ino == opened.st_ino && named.st_dev == opened.st_dev) unlinkat(folder, name, 0);
}

/// Most names of a folder that are looked at for leftovers: a few hundredths of a second.
constexpr int kMostNames = 100'000;

void sweep(const std::filesystem::path& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> listing(opendir(folder.c_str()), closedir);
  if (!listing) return;
  for (int i = 0; i < kMostNames; ++i) {
    const dirent* const entry = readdir(listing.get());
    if (entry == nullptr) return;
    if (is_temporary_name(entry->d_name)) remove_if_left(dirfd(listing.get()), entry->d_name);
  }
}

/// Sweeps a folder once in the life of the process.
void sweep_once(const std::filesystem::path& folder) {
  static std::mutex mutex;
  static auto* const swept = new std::set<std::filesystem::path>();
  {
    const std::lock_guard lock(mutex);
    if (!swept->insert(folder).second) return;
  }
  sweep(folder);
}

/// The folder for files without a name.
std::string temporary_folder() {
  const char* const named = std::getenv("TMPDIR");
  return named == nullptr || *named == '\0' ? "/tmp" : named;
}

/// Why the file takes no more blocks, if it does not: errno, or 0.
int refusal_of_more(int descriptor, const struct stat& info) {
  const bool takes = pwrite(descriptor, "", 1, info.st_size + info.st_blksize) == 1;
  const int reason = takes ? 0 : errno;
  return ftruncate(descriptor, info.st_size) == 0 ? reason : errno;
}

}  // namespace

// The name is registered before the file exists and forgotten after it is gone: a signal at any
// moment finds it, and removing a file that is not there does no harm.
TemporaryFile::TemporaryFile(const std::filesystem::path& target, mode_t mode)
    : path_(beside(target)), entry_(claim_entry(path_.string())) {
  const std::filesystem::path folder = target.parent_path();
  sweep_once(folder.empty() ? "." : folder);
  struct stat info {};
  do {
    file_.set(open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (!file_) break;
    // Another run may find the file before it is locked, and takes it for a leftover. File systems
    // without locks have nothing to sweep, either.
    flock(file_.number(), LOCK_EX);
  } while (fstat(file_.number(), &info) == 0 && info.st_nlink == 0);
  error_ = file_ ? 0 : errno;
}

TemporaryFile::~TemporaryFile() {
  if (!is_kept_) unlink(path_.c_str());
  release_entry(static_cast<Entry*>(entry_));
}

bool TemporaryFile::rename_to(const std::filesystem::path& target) {
  is_kept_ = rename(path_.c_str(), target.c_str()) == 0;
  return is_kept_;
}

UnnamedFile::UnnamedFile() : folder_(saddle::temporary_folder()) {
  std::string name = (std::filesystem::path(folder_) / "saddle-XXXXXX").string();
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    throw Error(Status::Machine, "no temporary file " + name + ": " + std::strerror(errno), {},
                "set TMPDIR to a folder that can be written to");
  }
  unlink(name.c_str());
}

UnnamedFile::~UnnamedFile() {
  close(descriptor_);
}

void UnnamedFile::check_written(const std::string& name,
                                const std::function<void()>& finish) const {
  try {
    finish();
    struct stat info {};
    if (fstat(descriptor_, &info) != 0 || info.st_size == 0) {
      throw Error(Status::Machine, name + " failed: it has written nothing");
    }
    // gnuplot, and ffmpeg at times, succeed by their own word where the last bytes had no room.
    if (const int reason = refusal_of_more(descriptor_, info)) {
      throw Error(Status::Machine, name + " failed: " + std::strerror(reason));
    }
  } catch (const Error& error) {
    // A file system that is full refuses the next block.
    struct statvfs space {};
    if (fstatvfs(descriptor_, &space) != 0 || space.f_bavail > 0) throw;
    throw with_hint_line(
        error, "the folder of temporary files, " + folder_ + ", is full; TMPDIR names another");
  }
}

void UnnamedFile::copy_to(std::ostream& out) const {
  std::vector<char> buffer(std::size_t{1} << 20);
  for (off_t at = 0;;) {
    const ssize_t count = pread(descriptor_, buffer.data(), buffer.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      throw Error(Status::Machine,
                  std::string("cannot read a temporary file: ") + std::strerror(errno));
    }
    if (count == 0) return;
    out.write(buffer.data(), count);
    at += count;
  }
}

void remove_temporaries_on_signals() {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    struct sigaction old {};
    sigaction(signal_number, nullptr, &old);
    if (old.sa_handler == SIG_IGN) continue;  // nohup, or a shell's background job
    struct sigaction action {};
    action.sa_handler = remove_temporaries_and_die;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(signal_number, &action, nullptr);
  }
}

}  // namespace saddle
