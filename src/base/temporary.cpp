#include "base/temporary.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"

namespace saddle {
namespace {

/// A handler may neither allocate nor lock, so the names lie in static memory, each guarded by a
/// lock-free state. More files than slots at a time are written without this help.
struct Slot {
  std::atomic<int> state;
  char path[PATH_MAX];
};
enum SlotState { kFree, kBusy, kLive };

constexpr int kSlots = 16;
Slot slots[kSlots];
static_assert(std::atomic<int>::is_always_lock_free);

int claim_slot(const std::string& path) {
  if (path.size() >= PATH_MAX) return -1;
  for (int i = 0; i < kSlots; ++i) {
    int expected = kFree;
    if (!slots[i].state.compare_exchange_strong(expected, kBusy)) continue;
    std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
    slots[i].state = kLive;
    return i;
  }
  return -1;
}

extern "C" void remove_temporaries_and_die(int signal_number) {
  for (Slot& slot : slots) {
    if (slot.state == kLive) unlink(slot.path);
  }
  // SA_RESETHAND has restored the default; the signal is delivered when this handler returns.
  raise(signal_number);
}

std::string random_letters(int count) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device device;
  std::uniform_int_distribution<std::size_t> index(0, kLetters.size() - 1);
  std::string text;
  for (int i = 0; i < count; ++i) text += kLetters[index(device)];
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
  constexpr int kRandom = 8;  // 36^8 names: a clash in one folder will not happen
  const std::string name = cut_name(target.filename().string(), NAME_MAX - kRandom - 2);
  return target.parent_path() / ("." + name + "." + random_letters(kRandom));
}

}  // namespace

// The name is registered before the file exists and forgotten after it is gone: a signal at any
// moment finds it, and removing a file that is not there does no harm.
TemporaryName::TemporaryName(const std::filesystem::path& target)
    : path_(beside(target)), slot_(claim_slot(path_.string())) {}

TemporaryName::~TemporaryName() {
  unlink(path_.c_str());
  if (slot_ >= 0) slots[slot_].state = kFree;
}

UnnamedFile::UnnamedFile() {
  const char* const folder = std::getenv("TMPDIR");
  std::string name = std::string(folder != nullptr ? folder : "/tmp") + "/saddle-XXXXXX";
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
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
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
