// A loop over fixed chunks on several threads. The chunks do not depend on the number of threads,
// so neither does any result that is computed chunk by chunk.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <future>
#include <stop_token>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace saddle {

/// Calls body(begin, end) for consecutive chunks of [0, count), each `chunk` long but the last;
/// every index exactly once, chunks in any order, on up to `threads` threads (0: all of the
/// machine's). Loops that run at the same time share the threads that wait for them, the oldest
/// loop first. The first exception thrown by a body is rethrown here once all threads have ended.
/// Throws Overtime when --max-time is long over.
void parallel_chunks(std::size_t count, std::size_t chunk, unsigned threads,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

/// The results of body(begin, end) for the chunks of parallel_chunks(), in their order.
template <typename Body>
auto results_of_chunks(std::size_t count, std::size_t chunk, unsigned threads, const Body& body)
    -> std::vector<std::invoke_result_t<Body, std::size_t, std::size_t>> {
  std::vector<std::invoke_result_t<Body, std::size_t, std::size_t>> results((count + chunk - 1) /
                                                                            chunk);
  parallel_chunks(count, chunk, threads, [&](std::size_t begin, std::size_t end) {
    results[begin / chunk] = body(begin, end);
  });
  return results;
}

/// Calls append(k, found) for each k of [0, count), on up to `threads` threads, with a list for
/// each chunk. Returns what was found, in the order of k.
template <typename T, typename Append>
std::vector<T> gather_in_chunks(std::size_t count, std::size_t chunk, unsigned threads,
                                Append append) {
  std::vector<std::vector<T>> parts =
      results_of_chunks(count, chunk, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<T> part;
        for (std::size_t k = begin; k < end; ++k) append(k, part);
        return part;
      });
  if (parts.size() == 1) return std::move(parts.front());
  std::size_t size = 0;
  for (const std::vector<T>& part : parts) size += part.size();
  std::vector<T> found;
  found.reserve(size);
  for (const std::vector<T>& part : parts) found.insert(found.end(), part.begin(), part.end());
  return found;
}

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
