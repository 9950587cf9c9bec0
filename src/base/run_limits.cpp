#include "base/run_limits.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>

#include "base/format.h"
#include "base/heap.h"

// Sanitizers have an operator new of their own, and take more addresses than any machine has.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SADDLE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define SADDLE_SANITIZED 1
#endif
#endif
#ifndef SADDLE_SANITIZED
#define SADDLE_SANITIZED 0
#endif

namespace saddle {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// Looking up what is in use takes two microseconds; refinement takes some 100 MB in this time.
constexpr std::chrono::milliseconds kBetweenLooks(50);
/// Proofs, searches and what else cannot stop early takes about as long as refinement, and a root
/// grid some seconds on a busy machine.
constexpr double kLongOvertime = 3;
constexpr double kLeastOvertime = 20;  // seconds
/// Heap, stacks and libraries of a process that does nothing yet.
constexpr std::uint64_t kAtRest = 100'000'000;

std::atomic<std::uint64_t> most_memory = kUnlimited;
std::atomic<double> most_seconds = std::numeric_limits<double>::infinity();
std::atomic<Clock::time_point> time_began = Clock::time_point();
std::atomic<Clock::time_point> last_look = Clock::time_point();
std::atomic<bool> is_memory_short = false;
/// The size of the last allocation that failed.
std::atomic<std::size_t> refused_bytes = 0;

bool has_passed(double seconds) {
  if (seconds == std::numeric_limits<double>::infinity()) return false;
  return std::chrono::duration<double>(Clock::now() - time_began.load()).count() > seconds;
}

/// Memory of our own that is in use, without files and programs; 0 if the system does not say.
std::uint64_t memory_in_use() {
  std::uint64_t all = 0;
  std::uint64_t resident = 0;
  std::uint64_t shared = 0;
  if (!(std::ifstream("/proc/self/statm") >> all >> resident >> shared)) return 0;
  return (resident - shared) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// The limit of the container, if it has one.
std::uint64_t container_memory() {
  for (const char* path :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::uint64_t bytes = 0;
    if (std::ifstream(path) >> bytes) return bytes;
  }
  return kUnlimited;
}

}  // namespace

std::uint64_t usual_memory_limit() {
  const auto machine = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return std::min(machine, container_memory()) / 2;
}

bool system_refuses_memory() {
  return SADDLE_SANITIZED == 0;
}

void limit_memory(std::uint64_t bytes) {
  most_memory = bytes;
  rlimit limit{};
  if (!system_refuses_memory() || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>({bytes, limit.rlim_cur, limit.rlim_max});
  setrlimit(RLIMIT_DATA, &limit);
  most_memory = limit.rlim_cur;
}

void limit_time(double seconds) {
  time_began = Clock::now();
  most_seconds = seconds;
}

double time_for_work() {
  return most_seconds;
}

std::uint64_t memory_for_work() {
  const std::uint64_t most = most_memory;
  return most > kAtRest ? most - kAtRest : 0;
}

Shortage shortage() {
  if (has_passed(most_seconds)) return Shortage::Time;
  if (most_memory == kUnlimited) return Shortage::None;
  const auto now = Clock::now();
  if (now - last_look.load() > kBetweenLooks) {
    last_look = now;
    is_memory_short = memory_in_use() > memory_for_work() / 2;
  }
  return is_memory_short ? Shortage::Memory : Shortage::None;
}

bool is_long_overtime() {
  const double seconds = most_seconds;
  return has_passed(std::max(kLongOvertime * seconds, seconds + kLeastOvertime));
}

std::string bytes_text(std::uint64_t bytes) {
  const auto count = static_cast<double>(bytes);
  if (bytes >= 1'000'000'000) return rounded(count / 1e9, 3) + " GB";
  return rounded(count / 1e6, 3) + " MB";
}

std::string memory_refusal() {
  std::string text = "out of memory";
  if (refused_bytes > 0) {
    text += ": " + bytes_text(refused_bytes) + " more than the " + bytes_text(memory_in_use()) +
            " in use";
  }
  return most_memory == kUnlimited ? text : text + "; --max-memory is " + bytes_text(most_memory);
}

std::string time_refusal() {
  return "--max-time is over, and nothing is whole yet";
}

}  // namespace saddle

#if !SADDLE_SANITIZED

namespace {

/// As operator new does, with the size of what is refused, and large blocks in huge pages.
void* allocate(std::size_t bytes, std::size_t alignment) {
  const std::size_t asked = std::max<std::size_t>(bytes, 1);
  for (;;) {
    void* memory = nullptr;
    if (alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__) {
      memory = std::malloc(asked);
    } else if (posix_memalign(&memory, alignment, asked) != 0) {
      memory = nullptr;
    }
    if (memory != nullptr) {
      saddle::prefer_huge_pages(memory, bytes);
      return memory;
    }
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) break;
    handler();
  }
  saddle::refused_bytes = bytes;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) {
  return allocate(bytes, 1);
}

void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate(bytes, static_cast<std::size_t>(alignment));
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

#endif
