#include "surface/surface_enclosure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "base/parallel.h"

namespace saddle {

void SurfaceEnclosures::in_chunks(
    std::size_t count, std::size_t chunk, unsigned threads,
    const std::function<void(SurfaceEnclosure& enclosure, std::size_t begin, std::size_t end)>&
        body) {
  parallel_chunks(count, chunk, threads, [&](std::size_t begin, std::size_t end) {
    std::unique_ptr<SurfaceEnclosure> enclosure = take();
    body(*enclosure, begin, end);
    give_back(std::move(enclosure));
  });
}

std::unique_ptr<SurfaceEnclosure> SurfaceEnclosures::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      std::unique_ptr<SurfaceEnclosure> enclosure = std::move(free_.back());
      free_.pop_back();
      return enclosure;
    }
  }
  return std::make_unique<SurfaceEnclosure>(surface_, outputs_);
}

void SurfaceEnclosures::give_back(std::unique_ptr<SurfaceEnclosure> enclosure) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(enclosure));
}

bool are_continuous(std::span<const Interval> bounds) {
  return std::ranges::all_of(bounds, is_continuous);
}

Defined least_defined(std::span<const Interval> bounds) {
  Defined least = Defined::Yes;
  for (const Interval& a : bounds) least = std::min(least, a.defined);
  return least;
}

Bounds hull_of(std::span<const Interval> bounds) {
  return {{bounds[0].low, bounds[1].low, bounds[2].low},
          {bounds[0].high, bounds[1].high, bounds[2].high}};
}

std::size_t KnownHulls::HashOfBox::operator()(const std::array<double, 4>& box) const {
  constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio
  std::uint64_t hash = 0;
  for (const double end : box) hash = (hash ^ std::bit_cast<std::uint64_t>(end)) * kSpread;
  return hash >> 32U;
}

std::vector<Bounds> KnownHulls::over(std::span<const ParameterBox> boxes, unsigned threads) {
  constexpr std::size_t kChunk = 16;
  if (!keeps_) {
    std::unique_ptr<SurfaceEnclosure> enclosure = enclosures_.take();
    keeps_ = enclosure->steps() >= kStepsToKeep;
    enclosures_.give_back(std::move(enclosure));
  }
  const auto ends_of = [](const ParameterBox& box) {
    return std::array{box.low.x, box.low.y, box.high.x, box.high.y};
  };
  std::vector<Bounds> hulls(boxes.size());
  std::vector<std::size_t> unknown;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const auto known = *keeps_ ? known_.find(ends_of(boxes[k])) : known_.end();
    if (known == known_.end()) {
      unknown.push_back(k);
    } else {
      hulls[k] = known->second;
    }
  }
  enclosures_.in_chunks(unknown.size(), kChunk, threads,
                        [&](SurfaceEnclosure& enclosure, std::size_t begin, std::size_t end) {
                          for (std::size_t i = begin; i < end; ++i)
                            hulls[unknown[i]] = hull_of(enclosure.enclose(boxes[unknown[i]]));
                        });
  for (const std::size_t k : unknown) {
    if (*keeps_ && known_.size() < kMostKnown) known_.try_emplace(ends_of(boxes[k]), hulls[k]);
  }
  return hulls;
}

double room_beyond(const Bounds& points, const Bounds& bounds) {
  dvec3 excess(0);
  for (int k = 0; k < 3; ++k)
    excess[k] = std::max({points.low[k] - bounds.low[k], bounds.high[k] - points.high[k], 0.0});
  const double room = glm::length(excess);
  if (std::isnan(room)) return kInfinity;
  return room;
}

}  // namespace saddle
