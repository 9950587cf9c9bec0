// Counts the points at which a surface is computed.
#pragma once

#include <atomic>
#include <cstddef>

namespace saddle {

/// A count that any number of threads may add to. Relaxed: the total is read once the threads have
/// been joined.
class PointCount {
 public:
  void add(std::size_t points) { points_.fetch_add(points, std::memory_order_relaxed); }
  std::size_t total() const { return points_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::size_t> points_ = 0;
};

}  // namespace saddle
