#include "mesh/sizing/grid_sizing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// Density falls by at most this factor from one sample to the next, and to no less than a
/// kDomainParts-th of the largest: a straight stretch between curved ones is not skipped in one
/// step.
constexpr double kFallOff = 0.7;
/// No stretch is denser than this many times its neighbours. At 2, surfaces that end at upright
/// tangents take up to half as many triangles as without a limit; at 3 more, others the same.
constexpr double kRise = 2;
/// Every fourth sample of a column or row, next to those of its neighbours on a slant, is enough to
/// compare ratios, and for cells that are as many samples wide.
constexpr std::size_t kEveryForRatio = 4;
/// Rounds in which cells are given a shape; the first starts from the ratio.
constexpr int kPasses = 3;
/// A loop has at least 4 cells: a polygon has no second derivatives to ask for them, and one or two
/// cells around it are flat.
constexpr double kCellsOfLoop = 4;

/// Limits each density to kRise times its neighbours'. A larger one comes from a feature narrower
/// than a stretch, or from a boundary or line at which second derivatives are infinite: the sample
/// stands for one place, not for the stretch. Both are left to local refinement.
void limit_rise(std::vector<double>& density) {
  const std::vector<double> asked = density;
  for (std::size_t i = 0; i < density.size(); ++i) {
    const double before = i > 0 ? asked[i - 1] : 0;
    const double after = i + 1 < asked.size() ? asked[i + 1] : 0;
    density[i] = std::min(density[i], kRise * std::max(before, after));
  }
}

void limit_fall_off(std::vector<double>& density) {
  const double least = *std::ranges::max_element(density) / static_cast<double>(kDomainParts);
  for (double& d : density) d = std::max(d, least);
  for (std::size_t i = 1; i < density.size(); ++i) {
    density[i] = std::max(density[i], kFallOff * density[i - 1]);
  }
  for (std::size_t i = density.size() - 1; i-- > 0;) {
    density[i] = std::max(density[i], kFallOff * density[i + 1]);
  }
}

/// Where edges meet, each takes the larger density of both; where an edge is folded, each half.
void share_density(const Seam& seam, const std::array<bool, 2>& folded,
                   std::vector<double>& density) {
  static_assert(kDomainParts % 2 == 0);
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

std::vector<SecondForm> forms_in_tolerances(const Probe& probe, const Tolerance& tolerance) {
  std::vector<SecondForm> forms;
  forms.reserve(probe.samples().size());
  const bool is_same = tolerance.is_same_everywhere();
  const double per_same = is_same ? 1 / tolerance(dvec3(0)) : 0;
  const auto per_eps_at = [&](const dvec3& p) { return is_same ? per_same : 1 / tolerance(p); };
  for (const Probe::Sample& s : probe.samples()) {
    const double per_eps = s.regular ? per_eps_at(s.position) : 0;
    forms.push_back({per_eps * s.L, per_eps * s.M, per_eps * s.N});
  }
  return forms;
}

/// The densities for the domain's edges: along them the mesh follows a curve, with all of the
/// tolerance.
SizingField sizing_of_edges(const Probe& probe, const Tolerance& tolerance) {
  const auto largest = [&](std::span<const Probe::EdgeSample> edges) {
    std::vector<double> sizing(kDomainParts, 0.0);
    for (const Probe::EdgeSample& edge : edges) {
      double& d = sizing[edge.line];
      d = std::max(d, density_for(edge.across / (2 * tolerance(edge.position))));
    }
    return sizing;
  };
  return {largest(probe.edges_along_u()), largest(probe.edges_along_v())};
}

/// Turns the densities that most samples ask for into those that the whole surface needs.
void complete(const Seams& seams, const SizingField& of_edges, SizingField& sizing) {
  const auto follow = [](const std::vector<double>& edges, std::vector<double>& lines) {
    for (std::size_t k = 0; k < lines.size(); ++k) lines[k] = std::max(lines[k], edges[k]);
  };
  limit_rise(sizing.of_u);
  limit_rise(sizing.of_v);
  follow(of_edges.of_u, sizing.of_u);
  follow(of_edges.of_v, sizing.of_v);
  share_density(seams.u, seams.folded_u, sizing.of_v);
  share_density(seams.v, seams.folded_v, sizing.of_u);
  limit_fall_off(sizing.of_u);
  limit_fall_off(sizing.of_v);
}

/// The cells between lines that are placed for these densities.
double cells_for(const Domain& d, const FixedLines& fixed, const SizingField& sizing) {
  return total_cells(Cumulative(sizing.of_u, d.u0, d.u1), fixed.u) *
         total_cells(Cumulative(sizing.of_v, d.v0, d.v1), fixed.v);
}

/// No densities have fewer cells: one between neighbouring fixed lines.
double fewest_cells(const FixedLines& fixed) {
  return static_cast<double>((fixed.u.size() - 1) * (fixed.v.size() - 1));
}

/// A ratio of cells' sides, in v and in u, and how many cells there are.
struct Ratio {
  double value;
  double cells;
};

/// The ratio for which there are the fewest cells.
Ratio best_ratio(const Probe& probe, const FixedLines& fixed, const SizingField& of_edges,
                 SampledForms forms) {
  const Domain& d = probe.domain();
  const double own_ratio = std::fabs((d.v1 - d.v0) / (d.u1 - d.u0));
  const auto cells = [&](int power) {
    SizingField sizing = forms.sizing(std::ldexp(own_ratio, power), nullptr);
    complete(probe.seams(), of_edges, sizing);
    return cells_for(d, fixed, sizing);
  };
  const double fewest = fewest_cells(fixed);
  // Sums of powers of the ratio have one valley.
  int best = 0;
  double least = cells(best);
  for (const int step : {4, 2, 1}) {
    for (const int way : {-step, step}) {
      const int before = best;
      while (least > fewest) {
        const double next = cells(best + way);
        if (!(next < least)) break;
        least = next;
        best += way;
      }
      if (best != before) break;
    }
  }
  return {std::ldexp(own_ratio, best), least};
}

/// Numbers of the cells between lines that hold some places.
std::vector<std::size_t> cells_of(std::span<const double> places, std::span<const double> lines) {
  const bool backwards = lines.front() > lines.back();
  std::vector<std::size_t> result;
  for (const double place : places) {
    const auto next = backwards ? std::ranges::upper_bound(lines, place, std::greater())
                                : std::ranges::upper_bound(lines, place);
    const auto cell = static_cast<std::size_t>(next - lines.begin() - 1);
    // In a range of few doubles a sample may be its last end.
    result.push_back(std::min(cell, lines.size() - 2));
  }
  return result;
}

}  // namespace

FixedLines fixed_lines(const Probe& probe, const FixedLines& drawn, const SingularSet& singular) {
  const Seams& seams = probe.seams();
  const auto through = [&](int axis, std::vector<double> lines) {
    for (const dvec2& uv : singular.points) lines.push_back(uv[axis]);
    for (const dvec2& uv : singular.without_limit) lines.push_back(uv[axis]);
    return lines;
  };
  const auto with = [](const std::vector<double>& lines, const std::vector<double>& more,
                       const Seam& seam, const std::array<bool, 2>& folded) {
    const std::vector<double> shared = shared_lines(seam, lines);
    std::vector<double> all = with_lines(shared, more, seam, folded);
    return all.size() <= shared.size() + kMostAddedLines ? all : shared;
  };
  return {with(drawn.u, through(0, singular.lines_u), seams.v, seams.folded_v),
          with(drawn.v, through(1, singular.lines_v), seams.u, seams.folded_u)};
}

SizingField sizing_field(const Probe& probe, const FixedLines& fixed, const Tolerance& tolerance) {
  const std::vector<SecondForm> forms = forms_in_tolerances(probe, tolerance);
  std::vector<std::uint8_t> regular;
  regular.reserve(forms.size());
  for (const Probe::Sample& s : probe.samples()) regular.push_back(s.regular ? 1 : 0);
  const SizingField edges = sizing_of_edges(probe, tolerance);
  const auto every = [&](std::size_t step) {
    return SampledForms(forms, regular, kDomainParts, kDomainParts, step);
  };
  SampledForms some = every(kEveryForRatio);
  const auto [ratio, cells] = best_ratio(probe, fixed, edges, some);
  const bool is_coarse =
      kEveryForRatio * kEveryForRatio * cells <= static_cast<double>(forms.size());
  SampledForms samples = is_coarse ? std::move(some) : every(1);
  SizingField sizing;
  for (int k = 0; k < kPasses; ++k) {
    sizing = samples.sizing(ratio, k > 0 ? &sizing : nullptr);
    complete(probe.seams(), edges, sizing);
    if (cells_for(probe.domain(), fixed, sizing) <= fewest_cells(fixed)) break;
  }
  return sizing;
}

FixedLines place_lines(const Probe& probe, const FixedLines& fixed, const SizingField& sizing,
                       double times) {
  const Domain& d = probe.domain();
  const auto closer = [times](std::vector<double> lines, bool is_loop, double range) {
    const double least = is_loop ? kCellsOfLoop / std::fabs(range) : 0;
    for (double& density : lines) density = std::max(times * density, least);
    return lines;
  };
  const auto& [u, v, folded_u, folded_v] = probe.seams();
  return {
      place_between(Cumulative(closer(sizing.of_u, u.closed, d.u1 - d.u0), d.u0, d.u1), fixed.u, v),
      place_between(Cumulative(closer(sizing.of_v, v.closed, d.v1 - d.v0), d.v0, d.v1), fixed.v,
                    u)};
}

std::vector<Counterexample> find_counterexamples(const Probe& probe, const FixedLines& lines,
                                                 const Tolerance& tolerance) {
  const std::vector<SecondForm> forms = forms_in_tolerances(probe, tolerance);
  const Domain& d = probe.domain();
  const dvec2 size = glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0)) / static_cast<double>(kDomainParts);
  const std::vector<std::size_t> columns = cells_of(probe.u(), lines.u);
  const std::vector<std::size_t> rows = cells_of(probe.v(), lines.v);
  std::vector<Counterexample> result;
  std::size_t s = 0;
  for (const std::size_t j : rows) {
    const double k = lines.v[j + 1] - lines.v[j];
    for (const std::size_t i : columns) {
      const SecondForm& form = forms[s];
      const double h = lines.u[i + 1] - lines.u[i];
      // The lines are too far apart for one cell alone, whose own samples might not show it.
      if (form_error_of_cell(form, h, k).error > kMostSafety) {
        result.push_back({probe.uv(s),
                          probe.samples()[s].position,
                          size,
                          {std::fabs(form.L), std::fabs(form.N)},
                          j * (lines.u.size() - 1) + i});
      }
      ++s;
    }
  }
  return result;
}

}  // namespace saddle
