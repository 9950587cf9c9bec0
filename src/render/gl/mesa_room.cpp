#include "render/gl/mesa_room.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <latch>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"

namespace saddle {
namespace {

/// llvmpipe has two sets of threads, for triangles and for compute shaders, each with a thread for
/// a processor, but at most this many (LP_MAX_THREADS in its lp_limits.h).
constexpr std::size_t kMostOfMesa = 32;
constexpr std::size_t kSets = 2;

/// Threads of this program beside those of a loop: this one, a writer, and those that listen to
/// ffmpeg.
constexpr std::size_t kOthers = 4;

/// Bytes that a small picture and the compiler of its shaders take from here on, without threads.
constexpr std::size_t kMemory = std::size_t{32} << 20;

/// Bytes that the system still allows of a resource of which `used` pages are taken.
std::size_t left_of(__rlimit_resource_t resource, std::size_t used) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return std::numeric_limits<std::size_t>::max();
  }
  const std::size_t bytes = used * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<std::size_t>(bytes, limit.rlim_cur);
}

/// Bytes of address space and of data that this process may still have.
std::size_t memory_left() {
  std::array<std::size_t, 6> pages{};  // all, resident, shared, text, unused, data
  std::ifstream file("/proc/self/statm");
  for (std::size_t& count : pages) file >> count;
  if (!file) return std::numeric_limits<std::size_t>::max();
  return std::min(left_of(RLIMIT_AS, pages[0]), left_of(RLIMIT_DATA, pages[5]));
}

std::size_t stack_bytes() {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  std::size_t bytes = 0;
  pthread_attr_getstacksize(&attributes, &bytes);
  pthread_attr_destroy(&attributes);
  return bytes;
}

void* wait_for(void* latch) {
  static_cast<std::latch*>(latch)->wait();
  return nullptr;
}

/// Whether the system runs so many more threads at the same time. Their stacks are small: they must
/// not take the memory that other threads need meanwhile.
bool can_start(std::size_t count) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, static_cast<std::size_t>(PTHREAD_STACK_MIN));
  std::latch all_tried(1);
  std::vector<pthread_t> threads;
  threads.reserve(count);
  pthread_t thread{};
  while (threads.size() < count &&
         pthread_create(&thread, &attributes, wait_for, &all_tried) == 0) {
    threads.push_back(thread);
  }
  all_tried.count_down();
  for (const pthread_t started : threads) pthread_join(started, nullptr);
  pthread_attr_destroy(&attributes);
  return threads.size() == count;
}

}  // namespace

void make_room_for_mesa() {
  const std::size_t left = memory_left();
  if (left < kMemory) {
    throw Error(Status::Machine, "not enough memory for OpenGL", {},
                "--max-memory and ulimit -v say how much there may be");
  }
  const std::size_t processors = available_threads();
  const std::size_t wanted = kSets * std::min(processors, kMostOfMesa) + processors + kOthers;
  const bool have_stacks = (left - kMemory) / stack_bytes() >= wanted;
  if (!have_stacks || !can_start(wanted)) setenv("LP_NUM_THREADS", "0", 1);
}

}  // namespace saddle
