// Counts the points at which a surface is computed, and says how many more may be. Other work for
// its mesh is counted as so many points.
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>

namespace saddle {

/// A count that any number of threads may add to. Relaxed: the total is read once the threads have
/// been joined.
class PointCount {
 public:
  void add(std::size_t points) { points_.fetch_add(points, std::memory_order_relaxed); }
  std::size_t total() const { return points_.load(std::memory_order_relaxed); }
  /// Adds work that takes as long as so many points, and computes none.
  void add_work(std::size_t points) { work_.fetch_add(points, std::memory_order_relaxed); }

  /// Allows so many more points; without a call there is no limit. Called where no thread computes.
  void allow(std::size_t points) { most_ = with_work() + points; }
  bool is_used_up() const { return with_work() >= most_; }
  std::size_t with_work() const { return total() + work_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::size_t> points_ = 0;
  std::atomic<std::size_t> work_ = 0;
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace saddle
