#include "study/integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Rectangles in each direction to begin with: their halves have 256 x 320 points.
constexpr std::size_t kFirstRectangles = 32;
/// Points that may be evaluated: some tenths of a second.
constexpr std::size_t kMostPoints = 600'000;
/// Differences that together are no more than this share are rounding.
constexpr double kRounded = 1e-12;
/// In each round those are halved whose differences are at least this part of the largest.
constexpr double kWorst = 1.0 / 16;

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

class Integrator {
 public:
  Integrator(const Surface& surface, const dvec3& centre, double size, unsigned threads)
      : surface_(surface), threads_(threads), centre_(centre), size_(size) {}

  Integrals run() {
    begin();
    Integrals all = total();
    while (evaluations_ < kMostPoints && error_of(all) > kRounded * std::fabs(all.area.value)) {
      if (!halve_worst()) break;
      all = total();
    }
    all.evaluations = evaluations_;
    return all;
  }

 private:
  double error_of(const Integrals& all) const {
    return std::max(all.area.error, size_ > 0 ? all.volume.error / size_ : 0);
  }

  void begin() {
    const Domain& d = surface_.domain;
    const auto at = [](double first, double last, std::size_t k) {
      const double part = static_cast<double>(k) / kFirstRectangles;
      return first * (1 - part) + last * part;
    };
    std::vector<ParameterBox> rectangles;
    for (std::size_t j = 0; j < kFirstRectangles; ++j) {
      for (std::size_t i = 0; i < kFirstRectangles; ++i) {
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

  void add_point(const SurfacePoint& point, double weight, Sums& sums) const {
    const dvec3 across = glm::cross(point.r_u, point.r_v);
    const double area = glm::length(across);
    const double volume = glm::dot(point.position - centre_, across) / 3;
    if (!std::isfinite(area) || !std::isfinite(volume)) return;
    sums.area += weight * area;
    sums.volume += weight * volume;
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
          cell.error >= kWorst * worst && evaluations_ + halves.size() * 4 * kPoints < kMostPoints;
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
    const auto add = [](const Estimate& part, Estimate& sum) {
      sum.value += part.value;
      sum.error += part.error;
    };
    for (const Cell& cell : cells_) {
      add(cell.area, all.area);
      add(cell.volume, all.volume);
    }
    return all;
  }

  const Surface& surface_;
  unsigned threads_;
  dvec3 centre_;
  double size_;
  std::vector<Cell> cells_;
  std::size_t evaluations_ = 0;
};

}  // namespace

Integrals integrate_domain(const Surface& surface, const dvec3& centre, double size,
                           unsigned threads) {
  return Integrator(surface, centre, size, threads).run();
}

}  // namespace saddle
