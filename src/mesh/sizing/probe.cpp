#include "mesh/sizing/probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>

#include "base/random.h"
#include "eval/batch.h"
#include "mesh/model/tolerances.h"
#include "mesh/sizing/find_seams.h"

namespace saddle {
namespace {

/// In a dip |r_u x r_v| is less than 0.7 of a neighbour's. Beside a zero between samples it is less
/// than half of that.
constexpr double kDip = 0.7;

/// A surface that one sample in 256 meets, or fewer, lies in a small part of its domain.
constexpr std::size_t kFewMet = 256;

/// The middles of even stretches of [first, last], each shifted.
std::vector<double> jittered(double first, double last, std::uint64_t key) {
  std::vector<double> values;
  for (std::size_t i = 0; i < kDomainParts; ++i) {
    const double shift = kLineJitter * (2 * random_unit(key + i) - 1);
    const double part = (static_cast<double>(i) + 0.5 + shift) / kDomainParts;
    values.push_back(first * (1 - part) + last * part);
  }
  return values;
}

/// A tape's outputs at `count` places.
class TapeColumns {
 public:
  /// `evaluate` fills the columns.
  template <class F>
  TapeColumns(const Tape& tape, std::size_t count, F evaluate) : columns_(tape.outputs.size()) {
    std::vector<double*> starts;
    for (Array<double>& column : columns_) {
      column.resize(count);
      starts.push_back(column.data());
    }
    evaluate(tape, starts);
  }
  double number(std::size_t output, std::size_t i) const { return columns_[output][i]; }
  dvec3 vector(std::size_t output, std::size_t i) const {
    return {columns_[output][i], columns_[output + 1][i], columns_[output + 2][i]};
  }

 private:
  std::vector<Array<double>> columns_;
};

/// The largest |r_u x r_v| of each of two edges, from tangents on a grid of two columns or of two
/// rows; infinite if one is not known.
std::array<double, 2> largest_areas(const TapeColumns& tangents, std::size_t columns,
                                    std::size_t rows) {
  std::array<double, 2> largest = {};
  for (std::size_t i = 0; i < columns * rows; ++i) {
    const double area = glm::length(glm::cross(tangents.vector(3, i), tangents.vector(6, i)));
    double& most = largest[rows == 2 ? i / columns : i % columns];
    most = std::isfinite(area) ? std::max(most, area) : std::numeric_limits<double>::infinity();
  }
  return largest;
}

}  // namespace

Probe::Probe(const Surface& surface, unsigned threads)
    : u_(jittered(surface.domain.u0, surface.domain.u1, 0)),
      v_(jittered(surface.domain.v0, surface.domain.v1, kDomainParts)),
      domain_(surface.domain),
      landmarks_(find_landmarks(surface, threads)) {
  sample_inside(surface, threads);
  sample_edges(surface, threads);
  const auto is_met = [](const Sample& sample) { return is_finite(sample.position); };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(samples_, is_met));
  const bool is_inside = edges_along_u_.empty() && edges_along_v_.empty();
  const bool is_small = is_inside && kFewMet * count <= samples_.size();
  if (count == 0 || is_small || !(bounds_.diagonal() > 0)) {
    std::vector<dvec2> met;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      if (is_met(samples_[k])) met.push_back(uv(k));
    }
    component_ = component_of(landmarks_, met, surface, threads);
  }
  if (component_)
    std::ranges::for_each(component_->positions, [&](const dvec3& p) { bounds_.add(p); });
  list_positions();
  seams_ = find_seams(surface, bounds_.diagonal());
}

void Probe::keep_within(const Bounds& box) {
  Bounds kept;
  const auto add = [&](const auto& sample) {
    if (box.contains(sample.position)) kept.add(sample.position);
  };
  std::ranges::for_each(samples_, add);
  std::ranges::for_each(edges_along_u_, add);
  std::ranges::for_each(edges_along_v_, add);
  if (kept.empty() || component_) return;
  const auto is_outside = [&](const EdgeSample& edge) { return !box.contains(edge.position); };
  std::erase_if(edges_along_u_, is_outside);
  std::erase_if(edges_along_v_, is_outside);
  for (Sample& sample : samples_) {
    if (box.contains(sample.position)) continue;
    sample.position = dvec3(std::numeric_limits<double>::quiet_NaN());
    sample.regular = false;
  }
  for (int k = 0; k < 3; ++k) {
    if (bounds_.low[k] < box.low[k]) kept.low[k] = box.low[k];
    if (bounds_.high[k] > box.high[k]) kept.high[k] = box.high[k];
  }
  bounds_ = kept;
  list_positions();
}

void Probe::sample_inside(const Surface& surface, unsigned threads) {
  const NormalColumns first = evaluate_normals_on_grid(surface, u_, v_, threads);
  const auto vector = [&first](std::size_t column, std::size_t i) {
    return dvec3(first[column][i], first[column + 1][i], first[column + 2][i]);
  };
  const std::size_t count = u_.size() * v_.size();
  const TapeColumns second(surface.curvatures, count,
                           [&](const Tape& tape, std::span<double* const> columns) {
                             evaluate_grid(tape, u_, v_, columns, threads);
                           });
  samples_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 normal = vector(kNormalColumn, i);
    Sample& sample = samples_.emplace_back();
    sample.position = vector(0, i);
    const bool is_defined = is_finite(sample.position);
    const dvec3 r_uu = second.vector(0, i);
    const dvec3 r_uv = second.vector(3, i);
    const dvec3 r_vv = second.vector(6, i);
    sample.L = glm::dot(r_uu, normal);
    sample.M = glm::dot(r_uv, normal);
    sample.N = glm::dot(r_vv, normal);
    sample.bends = {glm::length(r_uu), glm::length(r_vv)};
    const double gauss = second.number(9, i);
    const double area = first[kAreaColumn][i];
    sample.area =
        std::isfinite(area) && is_defined ? area : std::numeric_limits<double>::infinity();
    sample.sqrt_k = std::sqrt(std::fabs(gauss)) * area;
    sample.saddle = gauss < 0;
    sample.regular =
        is_defined && is_finite({sample.L, sample.M, sample.N}) && std::isfinite(sample.sqrt_k);
    if (is_defined) bounds_.add(sample.position);
  }
}

/// Adds positions on edges of the domain to the bounds. One that is far outside is added if the
/// surface just inside of the edge is far outside, too: at its end, floor(u) has a line of its own,
/// which is no part of the surface.
void Probe::add_to_bounds(const Surface& surface, std::span<const SurfacePoint> edges,
                          std::span<const dvec2> uv) {
  const double margin = kFarApart * bounds_.diagonal();
  const dvec2 low(std::min(domain_.u0, domain_.u1), std::min(domain_.v0, domain_.v1));
  const dvec2 high(std::max(domain_.u0, domain_.u1), std::max(domain_.v0, domain_.v1));
  // Just inside of an edge, rounding of products with the parameter leads to no other value.
  const dvec2 reach = kRounding * (glm::max(glm::abs(low), glm::abs(high)));
  const Bounds inner{bounds_.low - margin, bounds_.high + margin};
  std::vector<dvec2> inside;
  std::vector<dvec3> far;
  for (std::size_t k = 0; k < uv.size(); ++k) {
    const dvec3& position = edges[k].position;
    if (!is_finite(position)) continue;
    if (bounds_.empty() || inner.contains(position)) {
      bounds_.add(position);
    } else {
      far.push_back(position);
      inside.push_back(glm::clamp(uv[k], low + reach, high - reach));
    }
  }
  const std::vector<SurfacePoint> beside = evaluate(surface, inside, 1);
  const double same = kLimitsAgree * bounds_.diagonal();
  for (std::size_t k = 0; k < beside.size(); ++k) {
    const dvec3& position = beside[k].position;
    // On its way to infinity, as tan(u), the surface leaves the bounds before the edge.
    const bool is_edge = !is_finite(position) || !inner.contains(position) ||
                         glm::distance(position, far[k]) <= same;
    bounds_.add(is_edge ? far[k] : position);
  }
}

void Probe::sample_edges(const Surface& surface, unsigned threads) {
  std::vector<SurfacePoint> points;
  std::vector<dvec2> places;
  const auto sample = [&](std::span<const double> u, std::span<const double> v, bool along_u) {
    const std::size_t count = u.size() * v.size();
    std::vector<double> all_u;
    std::vector<double> all_v;
    for (std::size_t i = 0; i < count; ++i) {
      all_u.push_back(u[i % u.size()]);
      all_v.push_back(v[i / u.size()]);
    }
    // Two columns fill no block of a grid.
    const auto at_points = [&](const Tape& tape, std::span<double* const> columns) {
      evaluate_points(tape, all_u, all_v, columns, threads);
    };
    const TapeColumns first(surface.tangents, count, at_points);
    const TapeColumns second(surface.curvatures, count, at_points);
    const std::size_t axis = along_u ? 0 : 1;
    for (std::size_t i = 0; i < count; ++i) {
      const dvec3 position = first.vector(0, i);
      points.push_back({position, {}, {}});
      places.emplace_back(all_u[i], all_v[i]);
      const dvec3 tangent = glm::normalize(first.vector(3 + 3 * axis, i));
      const dvec3 bend = second.vector(6 * axis, i);
      const double across = glm::length(bend - glm::dot(bend, tangent) * tangent);
      if (!is_finite(position) || !std::isfinite(across)) continue;
      auto& edges = along_u ? edges_along_u_ : edges_along_v_;
      edges.push_back({along_u ? i % u.size() : i / u.size(), position, across});
    }
    const std::array<double, 2> largest = largest_areas(first, u.size(), v.size());
    for (std::size_t end = 0; end < 2; ++end) {
      (along_u ? singular_ends_v_ : singular_ends_u_)[end] =
          largest[end] <= kNearly * area_beside(along_u, end);
    }
  };
  sample(u_, std::array{domain_.v0, domain_.v1}, true);
  sample(std::array{domain_.u0, domain_.u1}, v_, false);
  add_to_bounds(surface, points, places);
}

double Probe::area_beside(bool along_u, std::size_t end) const {
  double largest = 0;
  for (std::size_t k = 0; k < kDomainParts; ++k) {
    const double inside = area(along_u, k, end == 0 ? 0 : kDomainParts - 1);
    if (std::isfinite(inside)) largest = std::max(largest, inside);
  }
  return largest;
}

std::vector<dvec3> Probe::edge_positions() const {
  std::vector<dvec3> positions;
  positions.reserve(edges_along_u_.size() + edges_along_v_.size());
  for (const auto* edges : {&edges_along_u_, &edges_along_v_}) {
    for (const EdgeSample& e : *edges) {
      if (is_finite(e.position)) positions.push_back(e.position);
    }
  }
  return positions;
}

void Probe::list_positions() {
  positions_.clear();
  if (component_) positions_ = component_->positions;
  positions_.reserve(positions_.size() + samples_.size());
  for (const Sample& s : samples_) {
    if (is_finite(s.position)) positions_.push_back(s.position);
  }
}

dvec2 Probe::longest_lines() const {
  const std::size_t columns = u_.size();
  dvec2 longest(0);
  std::vector<double> along_v(columns, 0.0);
  const auto step = [this](std::size_t from, std::size_t to) {
    const double length = glm::distance(samples_[from].position, samples_[to].position);
    return std::isfinite(length) ? length : 0;
  };
  for (std::size_t row = 0; row < samples_.size(); row += columns) {
    double along_u = 0;
    for (std::size_t i = 0; i < columns; ++i) {
      if (i > 0) along_u += step(row + i - 1, row + i);
      if (row > 0) along_v[i] += step(row + i - columns, row + i);
    }
    longest.x = std::max(longest.x, along_u);
  }
  longest.y = *std::ranges::max_element(along_v);
  return longest;
}

LinearizationErrors Probe::linearization_errors(const dvec2& size,
                                                const Tolerance& tolerance) const {
  LinearizationErrors result{u_, v_, {}};
  result.values.reserve(samples_.size());
  for (const Sample& sample : samples_) {
    const dvec2 linearization_error = size * size * sample.bends / 8.0;
    result.values.push_back(is_finite(sample.position)
                                ? linearization_error / tolerance(sample.position)
                                : dvec2(std::numeric_limits<double>::quiet_NaN()));
  }
  return result;
}

bool Probe::is_dip(bool along_v, std::size_t line, std::size_t k) const {
  const std::array<bool, 2>& singular_ends = along_v ? singular_ends_v_ : singular_ends_u_;
  const bool is_first = k == 0;
  const bool is_last = k + 1 == kDomainParts;
  if ((is_first && singular_ends[0]) || (is_last && singular_ends[1])) return false;
  const double own = area(along_v, line, k);
  const double before = is_first ? own : area(along_v, line, k - 1);
  const double after = is_last ? own : area(along_v, line, k + 1);
  if (before < own || after < own) return false;  // as most are
  const auto is_far_below = [own](double other) {
    return std::isfinite(other) && own < kDip * other;
  };
  return is_far_below(before) || is_far_below(after);
}

Dips Probe::dips() const {
  Dips dips{{}, {}, bounds_, {}, {}};
  for (std::size_t end = 0; end < 2; ++end) {
    const dvec2 corner = domain_.at(dvec2(static_cast<double>(end)));
    if (singular_ends_u_[end]) dips.edges_u.push_back(corner.x);
    if (singular_ends_v_[end]) dips.edges_v.push_back(corner.y);
  }
  for (std::size_t j = 0; j < v_.size(); ++j) {
    for (std::size_t i = 0; i < u_.size(); ++i) {
      if (is_dip(true, i, j)) dips.along_v.emplace_back(u_[i], v_[j]);
      if (is_dip(false, j, i)) dips.along_u.emplace_back(u_[i], v_[j]);
    }
  }
  return dips;
}

double Probe::stretch() const {
  return std::fabs((domain_.u1 - domain_.u0) * (domain_.v1 - domain_.v0)) /
         static_cast<double>(samples_.size());
}

double Probe::least_triangles(const Tolerance& tolerance) const {
  const double convex = 2 / (3 * std::numbers::sqrt3);
  const double saddle = 1 / (2 * std::sqrt(5));
  double sum = 0;
  for (const Sample& s : samples_) {
    if (s.regular) sum += (s.saddle ? saddle : convex) * s.sqrt_k / tolerance(s.position);
  }
  return sum * stretch();
}

}  // namespace saddle
