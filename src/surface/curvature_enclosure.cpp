#include "surface/curvature_enclosure.h"

#include "eval/interval.h"

namespace saddle {

namespace {

using VectorBounds = std::array<Interval, 3>;

VectorBounds bounds_at(std::span<const Interval> bounds, std::size_t first) {
  return {bounds[first], bounds[first + 1], bounds[first + 2]};
}

Interval dot_of(const VectorBounds& a, const VectorBounds& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Interval square_of(const VectorBounds& a) {
  return sqr(a[0]) + sqr(a[1]) + sqr(a[2]);
}

VectorBounds cross_of(const VectorBounds& a, const VectorBounds& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

CurvatureBounds CurvatureEnclosure::enclose(const ParameterBox& box) {
  const std::span<const Interval> bounds = enclosure_.enclose(box);
  const VectorBounds r_u = bounds_at(bounds, 3);
  const VectorBounds r_v = bounds_at(bounds, 6);
  const VectorBounds normal = cross_of(r_u, r_v);
  const Interval L = dot_of(bounds_at(bounds, 9), normal);
  const Interval M = dot_of(bounds_at(bounds, 12), normal);
  const Interval N = dot_of(bounds_at(bounds, 15), normal);
  const Interval area = square_of(normal);  // squared
  const Interval F = dot_of(r_u, r_v);
  CurvatureBounds result;
  result.position = bounds_at(bounds, 0);
  result.gauss = (L * N - sqr(M)) / sqr(area);
  const Interval twice = square_of(r_u) * N - (F + F) * M + square_of(r_v) * L;
  const Interval mean = twice / ((area + area) * sqrt(area));
  result.mean = flip_ ? -mean : mean;
  return result;
}

}  // namespace saddle
