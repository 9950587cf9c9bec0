#include "mesh/sizing/probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "base/random.h"
#include "eval/batch.h"
#include "mesh/sizing/find_seams.h"
#include "mesh/sizing/place_lines.h"

namespace saddle {
namespace {

/// Columns and rows of the probe. Features narrower than a cell of it are found by refinement.
constexpr std::size_t kProbes = 64;
/// Largest shift of a probe's line from the middle of its stretch, in stretches: a surface that
/// oscillates in step with an even grid does not with this one.
constexpr double kProbeJitter = 0.4;
/// Density falls by at most this factor from one probe to the next, and to no less than this share
/// of the largest: a straight stretch between curved ones is not skipped in one step.
constexpr double kFallOff = 0.7;
const double kFloor = 0.02;
/// No stretch is denser than so many times its neighbours: at 2 surfaces that end at upright
/// tangents take up to half as many triangles as without, at 3 more, others the same.
constexpr double kRise = 2;
/// Ratios of cell sides that are tried, as powers of 2 around the domain's own.
constexpr int kRatios = 6;
/// Every fourth sample of a column or row, next to those of its neighbours on a slant, is enough to
/// tell which ratio is best.
constexpr std::size_t kEveryForRatio = 4;
/// Times that cells are given a shape, at first the ratio's.
constexpr int kPasses = 3;
/// A cell that is off by so many tolerances at a sample is no cell that most of a line is good for:
/// its own tests might not see why.
constexpr double kFarTooLarge = 4;
/// A dip of |r_u x r_v| is to less than this part of the largest so many samples away: beside a
/// zero that is between samples to less than half.
constexpr double kDip = 0.7;
constexpr std::size_t kDipReach = 2;
/// Lines through singular points that a grid takes each way, for them to be vertices.
constexpr std::size_t kMostLines = 16;
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
/// |r_u x r_v| is 0 along an edge if it is less than this part of what it is beside it.
constexpr double kNoArea = 1e-6;

/// The middles of even stretches of [first, last], each shifted.
std::vector<double> jittered(double first, double last, std::uint64_t key) {
  std::vector<double> values;
  for (std::size_t i = 0; i < kProbes; ++i) {
    const double shift = kProbeJitter * (2 * random_unit(key + i) - 1);
    const double part = (static_cast<double>(i) + 0.5 + shift) / kProbes;
    values.push_back(first * (1 - part) + last * part);
  }
  return values;
}

/// A tape's outputs on a grid.
class GridColumns {
 public:
  GridColumns(const Tape& tape, std::span<const double> u, std::span<const double> v,
              unsigned threads)
      : columns_(tape.outputs.size()) {
    std::vector<double*> starts;
    for (Array<double>& column : columns_) {
      column.resize(u.size() * v.size());
      starts.push_back(column.data());
    }
    evaluate_grid(tape, u, v, starts, threads);
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
std::array<double, 2> largest_areas(const GridColumns& tangents, std::size_t columns,
                                    std::size_t rows) {
  std::array<double, 2> largest = {};
  for (std::size_t i = 0; i < columns * rows; ++i) {
    const double area = glm::length(glm::cross(tangents.vector(3, i), tangents.vector(6, i)));
    double& most = largest[rows == 2 ? i / columns : i % columns];
    most = std::isfinite(area) ? std::max(most, area) : std::numeric_limits<double>::infinity();
  }
  return largest;
}

/// What the neighbours of a stretch do not ask for is a feature narrower than it, or there is a
/// boundary or a line beside which second derivatives are endless: the probe's density is that of
/// one place, not of the stretch. Both are left to local refinement.
void limit_newton_step(std::vector<double>& density) {
  const std::vector<double> asked = density;
  for (std::size_t i = 0; i < density.size(); ++i) {
    const double before = i > 0 ? asked[i - 1] : 0;
    const double after = i + 1 < asked.size() ? asked[i + 1] : 0;
    density[i] = std::min(density[i], kRise * std::max(before, after));
  }
}

void limit_fall_off(std::vector<double>& density) {
  const double least = kFloor * *std::ranges::max_element(density);
  for (double& d : density) d = std::max(d, least);
  for (std::size_t i = 1; i < density.size(); ++i) {
    density[i] = std::max(density[i], kFallOff * density[i - 1]);
  }
  for (std::size_t i = density.size() - 1; i-- > 0;) {
    density[i] = std::max(density[i], kFallOff * density[i + 1]);
  }
}

/// Where edges meet, both need the density of the other, and where one is folded, each half.
void share_density(const Seam& seam, const std::array<bool, 2>& folded,
                   std::vector<double>& density) {
  static_assert(kProbes % 2 == 0);
  if (seam.reversed || folded[0] || folded[1]) {
    for (std::size_t i = 0; i < density.size(); ++i) {
      density[i] = std::max(density[i], density[density.size() - 1 - i]);
    }
  }
  if (!seam.shift.any()) return;
  const std::vector<double> own = density;
  const auto count = static_cast<double>(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (unsigned k = 1; k < seam.shift.of; ++k) {
      // A stretch that is shifted lies on two.
      const double at = Shift{k, seam.shift.of}(static_cast<double>(i), count);
      const auto lower = static_cast<std::size_t>(at);
      const std::size_t upper = at > std::floor(at) ? (lower + 1) % own.size() : lower;
      density[i] = std::max({density[i], own[lower], own[upper]});
    }
  }
}

}  // namespace

Probe::Probe(const Surface& surface, unsigned threads)
    : u_(jittered(surface.domain.u0, surface.domain.u1, 0)),
      v_(jittered(surface.domain.v0, surface.domain.v1, kProbes)),
      domain_(surface.domain) {
  sample_inside(surface, threads);
  sample_edges(surface, threads);
  const auto is_met = [](const Sample& sample) { return is_finite(sample.position); };
  if (std::ranges::none_of(samples_, is_met) || !(bounds_.diagonal() > 0)) {
    component_ = find_small_component(surface, threads);
  }
  if (component_)
    std::ranges::for_each(component_->positions, [&](const dvec3& p) { bounds_.add(p); });
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
}

void Probe::sample_inside(const Surface& surface, unsigned threads) {
  const NormalColumns first = evaluate_normals_on_grid(surface, u_, v_, threads);
  const auto vector = [&first](std::size_t column, std::size_t i) {
    return dvec3(first[column][i], first[column + 1][i], first[column + 2][i]);
  };
  const GridColumns second(surface.curvatures, u_, v_, threads);
  for (std::size_t i = 0; i < u_.size() * v_.size(); ++i) {
    const dvec3 normal = vector(kNormalColumn, i);
    Sample sample{};
    sample.position = vector(0, i);
    const dvec3 r_uu = second.vector(0, i);
    const dvec3 r_uv = second.vector(3, i);
    const dvec3 r_vv = second.vector(6, i);
    sample.L = glm::dot(r_uu, normal);
    sample.M = glm::dot(r_uv, normal);
    sample.N = glm::dot(r_vv, normal);
    sample.bends = {glm::length(r_uu), glm::length(r_vv)};
    const double gauss = second.number(9, i);
    const double area = first[kAreaColumn][i];
    sample.area = std::isfinite(area) && is_finite(sample.position)
                      ? area
                      : std::numeric_limits<double>::infinity();
    sample.sqrt_k = std::sqrt(std::fabs(gauss)) * area;
    sample.saddle = gauss < 0;
    sample.regular = is_finite(sample.position) && is_finite({sample.L, sample.M, sample.N}) &&
                     std::isfinite(sample.sqrt_k);
    if (is_finite(sample.position)) bounds_.add(sample.position);
    samples_.push_back(sample);
  }
}

void Probe::sample_edges(const Surface& surface, unsigned threads) {
  const auto sample = [&](std::span<const double> u, std::span<const double> v, bool along_u) {
    const GridColumns first(surface.tangents, u, v, threads);
    const GridColumns second(surface.curvatures, u, v, threads);
    const std::size_t axis = along_u ? 0 : 1;
    for (std::size_t i = 0; i < u.size() * v.size(); ++i) {
      const dvec3 position = first.vector(0, i);
      if (is_finite(position)) bounds_.add(position);
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
          largest[end] <= kNoArea * area_beside(along_u, end);
    }
  };
  sample(u_, std::array{domain_.v0, domain_.v1}, true);
  sample(std::array{domain_.u0, domain_.u1}, v_, false);
}

double Probe::area_beside(bool along_u, std::size_t end) const {
  double largest = 0;
  for (std::size_t k = 0; k < kProbes; ++k) {
    const double inside = area(along_u, k, end == 0 ? 0 : kProbes - 1);
    if (std::isfinite(inside)) largest = std::max(largest, inside);
  }
  return largest;
}

double Probe::radius(const dvec3& centre) const {
  double largest = 0;  // square
  const auto add = [&](const dvec3& position) {
    const dvec3 off = position - centre;
    largest = std::max(largest, glm::dot(off, off));
  };
  for (const Sample& s : samples_) {
    if (is_finite(s.position)) add(s.position);
  }
  for (const EdgeSample& e : edges_along_u_) add(e.position);
  for (const EdgeSample& e : edges_along_v_) add(e.position);
  return std::sqrt(largest);
}

std::vector<dvec3> Probe::positions() const {
  std::vector<dvec3> positions;
  if (component_) positions = component_->positions;
  for (const Sample& s : samples_) {
    if (is_finite(s.position)) positions.push_back(s.position);
  }
  return positions;
}

std::vector<SecondForm> Probe::bends(const Tolerance& tolerance) const {
  std::vector<SecondForm> bends;
  bends.reserve(samples_.size());
  for (const Sample& s : samples_) {
    const double per_eps = s.regular ? 1 / tolerance(s.position) : 0;
    bends.push_back({per_eps * s.L, per_eps * s.M, per_eps * s.N});
  }
  return bends;
}

SizingField Probe::along_edges(const Tolerance& tolerance) const {
  const auto largest = [&](std::size_t lines, std::span<const EdgeSample> edges) {
    std::vector<double> sizing(lines, 0.0);
    for (const EdgeSample& edge : edges) {
      double& d = sizing[edge.line];
      d = std::max(d, density_for(edge.across / (2 * tolerance(edge.position))));
    }
    return sizing;
  };
  return {largest(u_.size(), edges_along_u_), largest(v_.size(), edges_along_v_)};
}

void Probe::complete(const SizingField& along_edges, SizingField& sizing) const {
  const auto follow = [](const std::vector<double>& edges, std::vector<double>& lines) {
    for (std::size_t k = 0; k < lines.size(); ++k) lines[k] = std::max(lines[k], edges[k]);
  };
  limit_newton_step(sizing.of_u);
  limit_newton_step(sizing.of_v);
  follow(along_edges.of_u, sizing.of_u);
  follow(along_edges.of_v, sizing.of_v);
  share_density(seams_.u, seams_.folded_u, sizing.of_v);
  share_density(seams_.v, seams_.folded_v, sizing.of_u);
  limit_fall_off(sizing.of_u);
  limit_fall_off(sizing.of_v);
}

FixedLines Probe::fixed_lines(const FixedLines& drawn, const SingularSet& singular) const {
  const auto through = [&](int axis, std::vector<double> lines) {
    for (const dvec2& uv : singular.points) lines.push_back(uv[axis]);
    for (const dvec2& uv : singular.without_limit) lines.push_back(uv[axis]);
    return lines;
  };
  const auto with = [](const std::vector<double>& lines, const std::vector<double>& more,
                       const Seam& seam, const std::array<bool, 2>& folded) {
    const std::vector<double> shared = shared_lines(seam, lines);
    std::vector<double> all = with_lines(shared, more, seam, folded);
    return all.size() <= shared.size() + kMostLines ? all : shared;
  };
  return {with(drawn.u, through(0, singular.lines_u), seams_.v, seams_.folded_v),
          with(drawn.v, through(1, singular.lines_v), seams_.u, seams_.folded_u)};
}

double Probe::best_ratio(const FixedLines& fixed, const SizingField& along_edges,
                         SampledForms bent) const {
  const double own_ratio = std::fabs((domain_.v1 - domain_.v0) / (domain_.u1 - domain_.u0));
  const auto cells = [&](int power) {
    SizingField d = bent.sizing(std::ldexp(own_ratio, power), nullptr);
    complete(along_edges, d);
    return total_cells(Cumulative(d.of_u, domain_.u0, domain_.u1), fixed.u) *
           total_cells(Cumulative(d.of_v, domain_.v0, domain_.v1), fixed.v);
  };
  // Sums of powers of the ratio have one valley.
  int best = 0;
  double least = cells(best);
  for (const int step : {4, 2, 1}) {
    for (const int way : {-step, step}) {
      const int before = best;
      while (std::abs(best + way) <= kRatios) {
        const double next = cells(best + way);
        if (!(next < least)) break;
        least = next;
        best += way;
      }
      if (best != before) break;
    }
  }
  return std::ldexp(own_ratio, best);
}

SizingField Probe::sizing(const FixedLines& fixed, const Tolerance& tolerance) const {
  const std::vector<SecondForm> bent = bends(tolerance);
  std::vector<std::uint8_t> regular;
  regular.reserve(samples_.size());
  for (const Sample& s : samples_) regular.push_back(s.regular ? 1 : 0);
  const SizingField edges = along_edges(tolerance);
  const double ratio =
      best_ratio(fixed, edges, SampledForms(bent, regular, u_.size(), v_.size(), kEveryForRatio));
  SampledForms all(bent, regular, u_.size(), v_.size(), 1);
  SizingField sizing;
  for (int k = 0; k < kPasses; ++k) {
    sizing = all.sizing(ratio, k > 0 ? &sizing : nullptr);
    complete(edges, sizing);
  }
  return sizing;
}

FixedLines Probe::place_lines(const FixedLines& fixed, const SizingField& sizing,
                              double times) const {
  const auto closer = [times](std::vector<double> lines) {
    for (double& density : lines) density *= times;
    return lines;
  };
  return {
      place_between(Cumulative(closer(sizing.of_u), domain_.u0, domain_.u1), fixed.u, seams_.v),
      place_between(Cumulative(closer(sizing.of_v), domain_.v0, domain_.v1), fixed.v, seams_.u)};
}

template <class F>
void Probe::for_sampled_cells(const FixedLines& lines, std::span<const SecondForm> bends,
                              F f) const {
  const auto cells = [](std::span<const double> places, std::span<const double> lines_across) {
    const bool backwards = lines_across.front() > lines_across.back();
    std::vector<std::size_t> result;
    for (const double place : places) {
      const auto next = backwards ? std::ranges::upper_bound(lines_across, place, std::greater())
                                  : std::ranges::upper_bound(lines_across, place);
      const auto cell = static_cast<std::size_t>(next - lines_across.begin() - 1);
      // In a range of few doubles a sample may be its last end.
      result.push_back(std::min(cell, lines_across.size() - 2));
    }
    return result;
  };
  const std::vector<std::size_t> columns = cells(u_, lines.u);
  const std::vector<std::size_t> rows = cells(v_, lines.v);
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const std::size_t i = columns[s % u_.size()];
    const std::size_t j = rows[s / u_.size()];
    const double h = lines.u[i + 1] - lines.u[i];
    const double k = lines.v[j + 1] - lines.v[j];
    f(s, SampledCell{i, j, std::fabs(h * k), form_error_of_cell(bends[s], h, k).error});
  }
}

std::vector<Counterexample> Probe::counterexamples(const FixedLines& lines,
                                                   const Tolerance& tolerance) const {
  const std::vector<SecondForm> bent = bends(tolerance);
  const dvec2 size = glm::abs(dvec2(domain_.u1 - domain_.u0, domain_.v1 - domain_.v0)) /
                     static_cast<double>(kProbes);
  std::vector<Counterexample> result;
  for_sampled_cells(lines, bent, [&](std::size_t s, const SampledCell& cell) {
    if (!(cell.error > kFarTooLarge)) return;
    result.push_back({{u_[s % u_.size()], v_[s / u_.size()]},
                      samples_[s].position,
                      size,
                      {std::fabs(bent[s].L), std::fabs(bent[s].N)},
                      cell.j * (lines.u.size() - 1) + cell.i});
  });
  return result;
}

LinearizationErrors Probe::linearization_errors(const dvec2& size,
                                                const Tolerance& tolerance) const {
  LinearizationErrors result{u_, v_, {}};
  result.values.reserve(samples_.size());
  for (const Sample& sample : samples_) {
    const dvec2 linearization_error = size * size * sample.bends / 8.0;
    result.values.push_back(is_finite(sample.position)
                                ? linearization_error / tolerance(sample.position)
                                : dvec2(kNotKnown));
  }
  return result;
}

bool Probe::is_dip(bool along_v, std::size_t line, std::size_t k) const {
  const std::array<bool, 2>& singular_ends = along_v ? singular_ends_v_ : singular_ends_u_;
  if ((k < kDipReach && singular_ends[0]) || (k + kDipReach >= kProbes && singular_ends[1])) {
    return false;
  }
  const double own = area(along_v, line, k);
  if (k > 0 && area(along_v, line, k - 1) < own) return false;  // as most are
  if (k + 1 < kProbes && area(along_v, line, k + 1) < own) return false;
  double largest = 0;
  for (std::size_t at = k - std::min(k, kDipReach); at <= std::min(k + kDipReach, kProbes - 1);
       ++at) {
    const double other = area(along_v, line, at);
    if (std::isfinite(other)) largest = std::max(largest, other);
  }
  return own < kDip * largest;
}

Dips Probe::dips() const {
  Dips dips{{}, {}, bounds_, {}, {}};
  for (std::size_t end = 0; end < 2; ++end) {
    const dvec2 corner = domain_.at(dvec2(static_cast<double>(end)));
    if (singular_ends_u_[end]) dips.edges_u.push_back(corner.x);
    if (singular_ends_v_[end]) dips.edges_v.push_back(corner.y);
  }
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const std::size_t i = s % u_.size();
    const std::size_t j = s / u_.size();
    if (is_dip(true, i, j)) dips.along_v.emplace_back(u_[i], v_[j]);
    if (is_dip(false, j, i)) dips.along_u.emplace_back(u_[i], v_[j]);
  }
  return dips;
}

/// Cells that are too large by a factor become as many: errors grow with areas.
GridForecast Probe::grid_forecast(const FixedLines& lines, const Tolerance& tolerance) const {
  const double stretch = std::fabs((domain_.u1 - domain_.u0) * (domain_.v1 - domain_.v0)) /
                         static_cast<double>(samples_.size());
  GridForecast grid_forecast;
  for_sampled_cells(lines, bends(tolerance), [&](std::size_t s, const SampledCell& cell) {
    grid_forecast.is_regular = grid_forecast.is_regular && samples_[s].regular;
    grid_forecast.worst = std::max(grid_forecast.worst, cell.error);
    grid_forecast.cells += stretch / cell.area * std::max(1.0, cell.error);
  });
  return grid_forecast;
}

double Probe::least_triangles(const Tolerance& tolerance) const {
  constexpr double kConvex = 0.3849;  // 2 / (3 sqrt 3)
  constexpr double kSaddle = 0.2236;  // 1 / (2 sqrt 5)
  const double stretch = std::fabs((domain_.u1 - domain_.u0) * (domain_.v1 - domain_.v0)) /
                         static_cast<double>(samples_.size());
  double sum = 0;
  for (const Sample& s : samples_) {
    if (s.regular) sum += (s.saddle ? kSaddle : kConvex) * s.sqrt_k / tolerance(s.position);
  }
  return sum * stretch;
}

}  // namespace saddle
