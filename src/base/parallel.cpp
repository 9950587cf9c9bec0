#include "base/parallel.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/run_limits.h"

namespace saddle {
namespace {

/// About as long as it takes to wake a thread that sleeps.
constexpr std::chrono::microseconds kAwake(50);

/// The stop token of the Abandonable that lives on this thread; empty without one.
thread_local std::stop_token wanted_no_longer;

/// The state that the threads of one loop share.
struct Loop {
  std::size_t count;
  std::size_t chunk;
  const std::function<void(std::size_t, std::size_t)>& body;
  std::stop_token abandoned;
  std::atomic<std::size_t> next{0};  ///< number of the next free chunk
  std::mutex mutex{};
  std::exception_ptr first_exception{};

  std::size_t chunks() const { return count / chunk + (count % chunk == 0 ? 0 : 1); }
};

void run_chunk(Loop& loop, std::size_t index) {
  if (loop.abandoned.stop_requested()) throw Abandoned();
  if (is_long_overtime()) throw Overtime();
  const std::size_t begin = index * loop.chunk;
  loop.body(begin, begin + std::min(loop.chunk, loop.count - begin));
}

/// Takes chunk after chunk until there is none left or a body has thrown.
void run_chunks(Loop& loop) noexcept {
  const std::size_t chunks = loop.chunks();
  try {
    for (std::size_t i = loop.next++; i < chunks; i = loop.next++) run_chunk(loop, i);
  } catch (...) {
    loop.next = chunks;
    const std::lock_guard lock(loop.mutex);
    if (!loop.first_exception) loop.first_exception = std::current_exception();
  }
}

/// Threads that wait for loops: to wake one takes a tenth of the time that to start one takes. A
/// loop may start others on any of its threads: it waits only for threads that are within its own
/// chunks, never for one to come.
class Helpers {
 public:
  static Helpers& all() {
    static Helpers helpers;
    return helpers;
  }

  ~Helpers() {
    {
      const std::lock_guard lock(mutex_);
      are_done_ = true;
    }
    asked_.notify_all();
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

  /// Runs a loop on this thread and on up to `others` that have time before it ends.
  void run(Loop& loop, std::size_t others) {
    Request request{.loop = loop, .wanted = others};
    {
      const std::lock_guard lock(mutex_);
      start(others);
      requests_.push_back(&request);
      ++news_;
    }
    for (std::size_t k = 0; k < others; ++k) asked_.notify_one();
    run_chunks(loop);
    std::unique_lock lock(mutex_);
    std::erase(requests_, &request);
    wait(lock, left_, [&] { return request.working == 0; });
  }

 private:
  struct Request {
    Loop& loop;
    std::size_t wanted;       ///< threads that may still come
    std::size_t working = 0;  ///< threads that came and have not left
  };

  Helpers() = default;

  /// Waits until `has_come()`: for a moment awake, as loops follow each other closely.
  template <class Condition>
  void wait(std::unique_lock<std::mutex>& lock, std::condition_variable& told, Condition has_come) {
    const auto asleep_from = std::chrono::steady_clock::now() + kAwake;
    while (!has_come() && std::chrono::steady_clock::now() < asleep_from) {
      const std::size_t before = news_;
      lock.unlock();
      while (news_ == before && std::chrono::steady_clock::now() < asleep_from)
        std::this_thread::yield();
      lock.lock();
    }
    told.wait(lock, has_come);
  }

  /// Starts threads until there are `count`.
  void start(std::size_t count) {
    try {
      while (threads_.size() < count) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // The system allows no more threads: those that are there do the work.
    }
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      wait(lock, asked_, [this] { return are_done_ || !requests_.empty(); });
      if (are_done_) return;
      Request& request = *requests_.front();
      if (--request.wanted == 0) requests_.erase(requests_.begin());
      ++request.working;
      lock.unlock();
      run_chunks(request.loop);
      lock.lock();
      if (--request.working == 0) {
        ++news_;
        left_.notify_all();
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable asked_, left_;
  std::vector<Request*> requests_;  ///< the oldest first
  bool are_done_ = false;
  std::atomic<std::size_t> news_{0};   ///< requests that have come or are done
  std::vector<std::jthread> threads_;  // the last member: they use the others
};

}  // namespace

Abandonable::Abandonable(std::stop_token token) {
  assert(!wanted_no_longer.stop_possible());
  wanted_no_longer = std::move(token);
}

Abandonable::~Abandonable() {
  wanted_no_longer = {};
}

unsigned available_threads() {
  cpu_set_t set;
  CPU_ZERO(&set);
  // Fails on machines with more than 1024 processors, whose mask is larger.
  if (sched_getaffinity(0, sizeof set, &set) == 0) {
    return static_cast<unsigned>(std::max(CPU_COUNT(&set), 1));
  }
  return std::max(std::thread::hardware_concurrency(), 1u);
}

void parallel_chunks(std::size_t count, std::size_t chunk, unsigned threads,
                     const std::function<void(std::size_t begin, std::size_t end)>& body) {
  assert(chunk > 0);
  Loop loop{.count = count, .chunk = chunk, .body = body, .abandoned = wanted_no_longer};
  const std::size_t chunks = loop.chunks();
  const unsigned wanted = chunks <= 1 ? 1 : threads == 0 ? available_threads() : threads;
  const std::size_t others = std::min<std::size_t>(wanted, std::max<std::size_t>(chunks, 1)) - 1;
  if (others == 0) {
    run_chunks(loop);
  } else {
    Helpers::all().run(loop, others);
  }
  if (loop.first_exception) std::rethrow_exception(loop.first_exception);
}

}  // namespace saddle
