// A loop over fixed chunks on several threads. The chunks do not depend on the number of threads,
// so neither does any result that is computed chunk by chunk.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <future>
#include <stop_token>
#include <system_error>
#include <utility>

namespace saddle {

/// Calls body(begin, end) for consecutive chunks of [0, count), each `chunk` long but the last;
/// every index exactly once, chunks in any order, on up to `threads` threads (0: all of the
/// machine's). Loops that run at the same time share the threads that wait for them, the oldest
/// loop first. The first exception thrown by a body is rethrown here once all threads have ended.
/// Throws Overtime when --max-time is long over.
void parallel_chunks(std::size_t count, std::size_t chunk, unsigned threads,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

/// The result of `work`, computed on a thread of its own; if the system starts none, on the thread
/// that gets it.
template <typename Work>
auto run_beside(Work work) -> std::future<decltype(work())> {
  try {
    return std::async(std::launch::async, work);
  } catch (const std::system_error&) {
    return std::async(std::launch::deferred, std::move(work));
  }
}

/// Thrown by parallel_chunks() when its work is no longer wanted.
class Abandoned : public std::exception {
 public:
  const char* what() const noexcept override { return "abandoned"; }
};

/// While it lives, loops that are started on this thread end with Abandoned, at the next chunk,
/// once `token` is asked to stop. For work that a user can supersede by typing on. One at a time.
class Abandonable {
 public:
  explicit Abandonable(std::stop_token token);
  ~Abandonable();
  Abandonable(const Abandonable&) = delete;
  Abandonable& operator=(const Abandonable&) = delete;
};

/// Threads that `0` stands for: what the process may run on, at least 1.
unsigned available_threads();

}  // namespace saddle
