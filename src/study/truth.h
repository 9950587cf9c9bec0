// The true surface: positions and normals from 50-digit arithmetic, independent of every
// method that is measured against them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/model/scene.h"
#include "surface/normal.h"

namespace saddle {

/// A position as the sum of two doubles for each coordinate: 32 digits.
struct TruePosition {
  dvec3 value;
  dvec3 rest;
};

class Truth {
 public:
  /// Throws Error (Input): anything wrong with a formula.
  Truth(const Scene& scene, const SurfaceSpec& spec);
  ~Truth();
  Truth(const Truth&) = delete;
  Truth& operator=(const Truth&) = delete;

  /// Positions; NaN or infinite where there is none.
  std::vector<TruePosition> positions(std::span<const dvec2> uv, unsigned threads) const;

  /// Unit normals along r_u x r_v at the corners; where that has no direction, its limit from
  /// inside. Nothing where there is no limit either.
  std::vector<std::optional<dvec3>> normals(std::span<const Approach> approaches,
                                            unsigned threads) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace saddle
