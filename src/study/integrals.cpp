#include "study/integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Rectangles each way to begin with, and the fewest: the halves of 24 x 24 have 192 x 240 points.
constexpr std::size_t kFirstRectangles = 24;
constexpr std::size_t kFewestRectangles = 4;
/// Points that may be evaluated: some tenths of a second.
constexpr std::size_t kMostPoints = 600'000;
/// Differences that together are no more than this share are rounding.
constexpr double kRounded = 1e-12;
/// In each round those are halved whose differences are at least this part of the largest.
constexpr double kWorst = 1.0 / 16;

/// Where the surface is not defined everywhere: panels of u to begin with; samples of a line of v,
/// between which one end of a defined part may be; panels of such a part.
constexpr std::size_t kFirstPanels = 8;
constexpr std::size_t kLineSamples = 64;
constexpr std::size_t kLinePanels = 8;
/// An area by lines that is off by no more than this share is taken: six digits and some more.
constexpr double kGoodArea = 1e-8;

/// A place in [-1, 1] and its weight; the weights add up to 1.
struct GaussNode {
  double place, weight;
};

/// Different numbers of points along u and v: no point of a square is on its diagonal.
constexpr std::array<GaussNode, 4> kAlongU = {{{-0.86113631159405258, 0.17392742256872693},
                                               {-0.33998104358485626, 0.32607257743127307},
                                               {0.33998104358485626, 0.32607257743127307},
                                               {0.86113631159405258, 0.17392742256872693}}};
constexpr std::array<GaussNode, 5> kAlongV = {{{-0.90617984593866399, 0.11846344252809454},
                                               {-0.53846931010568309, 0.23931433524968324},
                                               {0.0, 0.28444444444444444},
                                               {0.53846931010568309, 0.23931433524968324},
                                               {0.90617984593866399, 0.11846344252809454}}};
constexpr std::size_t kPoints = kAlongU.size() * kAlongV.size();

struct Sums {
  double area = 0;
  double volume = 0;
};

struct Cell {
  ParameterBox rectangle;
  Sums sums;
  std::array<std::array<Sums, 2>, 2> halves;  ///< of each axis
  Estimate area, volume;
  double error = 0;  ///< by which cells are compared
  int axis = 0;      ///< the one to halve
};

/// Area and volume per unit of parameters at a point; nothing where one is not finite.
std::optional<Sums> integrand(const SurfacePoint& point, const dvec3& centre) {
  const dvec3 across = glm::cross(point.r_u, point.r_v);
  const Sums sums = {glm::length(across), glm::dot(point.position - centre, across) / 3};
  if (!std::isfinite(sums.area) || !std::isfinite(sums.volume)) return std::nullopt;
  return sums;
}

void add_to(Integrals& sum, const Integrals& part, double weight = 1) {
  sum.area.value += weight * part.area.value;
  sum.area.error += weight * part.area.error;
  sum.volume.value += weight * part.volume.value;
  sum.volume.error += weight * part.volume.error;
}

/// Integrals over the defined parts of lines of constant u, whose ends bisection finds. A
/// substitution with slopes of 0 at the ends makes 1 / sqrt(distance) smooth there.
class LineIntegrator {
 public:
  LineIntegrator(const Surface& surface, const dvec3& centre, unsigned threads, std::size_t most)
      : surface_(surface), threads_(threads), centre_(centre), most_points_(most) {}

  Integrals run() {
    const Domain& d = surface_.domain;
    const std::vector<double> ends = even_lines(d.u0, d.u1, kFirstPanels);
    for (std::size_t k = 0; k < kFirstPanels; ++k) add(ends[k], ends[k + 1]);
    while (evaluations_ < most_points_) {
      const auto worst = std::ranges::max_element(panels_, {}, &Panel::error);
      const double middle = 0.5 * worst->low + 0.5 * worst->high;
      if (!(worst->error > kRounded * total().area.value)) break;
      if (middle == worst->low || middle == worst->high) break;
      const Panel panel = *worst;
      panels_.erase(worst);
      add(panel.low, middle);
      add(middle, panel.high);
    }
    return total();
  }

 private:
  struct Panel {
    double low, high;
    Integrals sum;
    double error;  ///< of the area that halving may mend
  };

  Integrals total() const {
    Integrals all;
    for (const Panel& panel : panels_) add_to(all, panel.sum);
    all.evaluations = evaluations_;
    return all;
  }

  std::vector<std::optional<Sums>> integrands(const std::vector<dvec2>& uv) {
    evaluations_ += uv.size();
    std::vector<std::optional<Sums>> result;
    result.reserve(uv.size());
    for (const SurfacePoint& point : evaluate(surface_, uv, threads_)) {
      result.push_back(integrand(point, centre_));
    }
    return result;
  }

  /// The ends of what is defined along a line, in pairs.
  std::vector<double> defined_ends(double u) {
    const Domain& d = surface_.domain;
    std::vector<dvec2> uv;
    for (const double v : even_lines(d.v0, d.v1, kLineSamples)) uv.emplace_back(u, v);
    const auto found = integrands(uv);
    std::vector<double> ends;
    if (found.front()) ends.push_back(d.v0);
    for (std::size_t k = 0; k < kLineSamples; ++k) {
      if (found[k].has_value() == found[k + 1].has_value()) continue;
      ends.push_back(found[k] ? last_defined(u, uv[k].y, uv[k + 1].y)
                              : last_defined(u, uv[k + 1].y, uv[k].y));
    }
    if (found.back()) ends.push_back(d.v1);
    return ends;
  }

  double last_defined(double u, double defined, double undefined) {
    for (;;) {
      const double middle = 0.5 * defined + 0.5 * undefined;
      if (middle == defined || middle == undefined) return defined;
      (integrands({dvec2(u, middle)})[0] ? defined : undefined) = middle;
    }
  }

  Integrals line(double u) {
    Integrals result;
    const std::vector<double> ends = defined_ends(u);
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) add_part(u, ends[k], ends[k + 1], result);
    return result;
  }

  void add_part(double u, double low, double high, Integrals& to) {
    const Sums fine = part(u, low, high, kAlongV);
    const Sums coarse = part(u, low, high, kAlongU);
    to.area.value += fine.area;
    to.area.error += std::fabs(fine.area - coarse.area);
    to.volume.value += fine.volume;
    to.volume.error += std::fabs(fine.volume - coarse.volume);
  }

  template <std::size_t Count>
  Sums part(double u, double low, double high, const std::array<GaussNode, Count>& rule) {
    std::vector<dvec2> uv;
    std::vector<double> weights;
    for (std::size_t k = 0; k < kLinePanels; ++k) {
      for (const GaussNode& node : rule) {
        const double s = (static_cast<double>(k) + 0.5 + 0.5 * node.place) / kLinePanels;
        const double way = s * s * (3 - 2 * s);
        uv.emplace_back(u, low * (1 - way) + high * way);
        weights.push_back(node.weight / kLinePanels * 6 * s * (1 - s) * std::fabs(high - low));
      }
    }
    const auto found = integrands(uv);
    Sums sums;
    for (std::size_t k = 0; k < uv.size(); ++k) {
      if (!found[k]) continue;
      sums.area += weights[k] * found[k]->area;
      sums.volume += weights[k] * found[k]->volume;
    }
    return sums;
  }

  Integrals over(double low, double high) {
    Integrals sum;
    for (const GaussNode& node : kAlongV) {
      add_to(sum, line(0.5 * (low + high) + 0.5 * (high - low) * node.place),
             node.weight * std::fabs(high - low));
    }
    return sum;
  }

  void add(double low, double high) {
    const double middle = 0.5 * low + 0.5 * high;
    const Integrals whole = over(low, high);
    Integrals sum = over(low, middle);
    add_to(sum, over(middle, high));
    const double off = std::fabs(sum.area.value - whole.area.value);
    sum.area.error += off;
    sum.volume.error += std::fabs(sum.volume.value - whole.volume.value);
    panels_.push_back({low, high, sum, off});
  }

  const Surface& surface_;
  unsigned threads_;
  dvec3 centre_;
  std::size_t most_points_;
  std::vector<Panel> panels_;
  std::size_t evaluations_ = 0;
};

class Integrator {
 public:
  Integrator(const Surface& surface, const dvec3& centre, double size, unsigned threads,
             double share)
      : surface_(surface), threads_(threads), centre_(centre), size_(size), share_(share) {}

  Integrals run() {
    begin();
    std::optional<Integrals> by_lines;
    if (has_holes_) {
      by_lines = LineIntegrator(surface_, centre_, threads_, most_points_).run();
      if (by_lines->area.error <= kGoodArea * by_lines->area.value) return *by_lines;
    }
    Integrals all = total();
    while (evaluations_ < most_points_ && error_of(all) > kRounded * std::fabs(all.area.value)) {
      if (!halve_worst()) break;
      all = total();
    }
    if (by_lines && by_lines->area.error < all.area.error) all = *by_lines;
    all.evaluations = evaluations_ + (by_lines ? by_lines->evaluations : 0);
    return all;
  }

 private:
  double error_of(const Integrals& all) const {
    return std::max(all.area.error, size_ > 0 ? all.volume.error / size_ : 0);
  }

  void begin() {
    const Domain& d = surface_.domain;
    const std::size_t count =
        std::max(kFewestRectangles, static_cast<std::size_t>(std::sqrt(share_) * kFirstRectangles));
    const auto at = [count](double first, double last, std::size_t k) {
      const double part = static_cast<double>(k) / static_cast<double>(count);
      return first * (1 - part) + last * part;
    };
    std::vector<ParameterBox> rectangles;
    for (std::size_t j = 0; j < count; ++j) {
      for (std::size_t i = 0; i < count; ++i) {
        rectangles.push_back({{at(d.u0, d.u1, i), at(d.v0, d.v1, j)},
                              {at(d.u0, d.u1, i + 1), at(d.v0, d.v1, j + 1)}});
      }
    }
    const std::vector<Sums> sums = integrate(rectangles);
    std::vector<Cell> cells(rectangles.size());
    for (std::size_t k = 0; k < rectangles.size(); ++k) {
      cells[k].rectangle = rectangles[k];
      cells[k].sums = sums[k];
    }
    add(std::move(cells));
  }

  /// Gauss's rule for each of some rectangles; what is not defined counts as 0.
  std::vector<Sums> integrate(const std::vector<ParameterBox>& rectangles) {
    std::vector<dvec2> uv;
    uv.reserve(rectangles.size() * kPoints);
    for (const ParameterBox& rectangle : rectangles) {
      const dvec2 middle = 0.5 * rectangle.low + 0.5 * rectangle.high;
      const dvec2 half = 0.5 * (rectangle.high - rectangle.low);
      for (const GaussNode& v : kAlongV) {
        for (const GaussNode& u : kAlongU) uv.push_back(middle + half * dvec2(u.place, v.place));
      }
    }
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
    evaluations_ += points.size();
    std::vector<Sums> result;
    result.reserve(rectangles.size());
    for (std::size_t k = 0; k < rectangles.size(); ++k) {
      const dvec2 size = rectangles[k].high - rectangles[k].low;
      Sums sums;
      for (std::size_t n = 0; n < kPoints; ++n) {
        const double weight =
            kAlongU[n % kAlongU.size()].weight * kAlongV[n / kAlongU.size()].weight;
        add_point(points[k * kPoints + n], weight * std::fabs(size.x * size.y), sums);
      }
      result.push_back(sums);
    }
    return result;
  }

  void add_point(const SurfacePoint& point, double weight, Sums& sums) {
    const std::optional<Sums> found = integrand(point, centre_);
    if (!found) {
      has_holes_ = true;
      return;
    }
    sums.area += weight * found->area;
    sums.volume += weight * found->volume;
  }

  /// Adds cells whose own sums are known.
  void add(std::vector<Cell> cells) {
    std::vector<ParameterBox> rectangles;
    for (const Cell& cell : cells) {
      for (int axis = 0; axis < 2; ++axis) {
        for (std::size_t which = 0; which < 2; ++which) {
          rectangles.push_back(halves_of(cell.rectangle, axis)[which]);
        }
      }
    }
    const std::vector<Sums> sums = integrate(rectangles);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (std::size_t n = 0; n < 4; ++n) cells[k].halves[n / 2][n % 2] = sums[4 * k + n];
      compare(cells[k]);
      cells_.push_back(cells[k]);
    }
  }

  /// Halves tell how far off the whole is, along each axis for itself.
  void compare(Cell& cell) const {
    const auto differences = [&cell](double Sums::*which) {
      std::array<double, 2> result{};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto& [first, second] = cell.halves[axis];
        result[axis] = first.*which + second.*which - cell.sums.*which;
      }
      return result;
    };
    const auto estimate = [](double value, const std::array<double, 2>& off) {
      return Estimate{value + off[0] + off[1], std::fabs(off[0]) + std::fabs(off[1])};
    };
    const auto area = differences(&Sums::area);
    const auto volume = differences(&Sums::volume);
    cell.area = estimate(cell.sums.area, area);
    cell.volume = estimate(cell.sums.volume, volume);
    std::array<double, 2> off{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      off[axis] = std::max(std::fabs(area[axis]), size_ > 0 ? std::fabs(volume[axis]) / size_ : 0);
    }
    cell.axis = off[0] >= off[1] ? 0 : 1;
    const double low = cell.rectangle.low[cell.axis];
    const double high = cell.rectangle.high[cell.axis];
    const double middle = 0.5 * low + 0.5 * high;
    cell.error = middle == low || middle == high ? 0 : off[0] + off[1];
  }

  /// Whether there is a cell to halve.
  bool halve_worst() {
    double worst = 0;
    for (const Cell& cell : cells_) worst = std::max(worst, cell.error);
    if (!(worst > 0)) return false;
    std::vector<Cell> halves;
    const auto take = [&](const Cell& cell) {
      const bool is_taken =
          cell.error >= kWorst * worst && evaluations_ + halves.size() * 4 * kPoints < most_points_;
      if (!is_taken) return false;
      for (std::size_t which = 0; which < 2; ++which) {
        Cell half;
        half.rectangle = halves_of(cell.rectangle, cell.axis)[which];
        half.sums = cell.halves[static_cast<std::size_t>(cell.axis)][which];
        halves.push_back(half);
      }
      return true;
    };
    std::erase_if(cells_, take);
    add(std::move(halves));
    return true;
  }

  Integrals total() const {
    Integrals all;
    for (const Cell& cell : cells_) add_to(all, {cell.area, cell.volume});
    return all;
  }

  const Surface& surface_;
  unsigned threads_;
  dvec3 centre_;
  double size_, share_;
  std::size_t most_points_ = static_cast<std::size_t>(share_ * kMostPoints);
  std::vector<Cell> cells_;
  std::size_t evaluations_ = 0;
  bool has_holes_ = false;  // some points are not defined
};

}  // namespace

Integrals integrate_domain(const Surface& surface, const dvec3& centre, double size,
                           unsigned threads, double share) {
  return Integrator(surface, centre, size, threads, share).run();
}

}  // namespace saddle
