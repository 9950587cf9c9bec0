#include "study/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace saddle {

namespace {

/// Triangles whose points are evaluated together: some MB.
constexpr std::size_t kTriangleBlock = 4096;
/// An integral over a triangle that differs from the flat triangle's by more than this share is
/// spoilt by a derivative that goes to infinity; the flat one is then the better.
constexpr double kSpoilt = 0.1;

/// Corner weights and weight of a point of Radon's rule.
struct RadonNode {
  std::array<double, 3> corners;
  double weight;
};

std::array<RadonNode, 7> radon_rule() {
  const double root = std::sqrt(15.0);
  std::array<RadonNode, 7> nodes{};
  nodes[0] = {{1.0 / 3, 1.0 / 3, 1.0 / 3}, 9.0 / 40};
  const auto add = [&](std::size_t first, double near, double weight) {
    for (std::size_t k = 0; k < 3; ++k) {
      RadonNode& node = nodes[first + k];
      node = {{near, near, near}, weight};
      node.corners[k] = 1 - 2 * near;
    }
  };
  add(1, (6 - root) / 21, (155 - root) / 1200);
  add(4, (6 + root) / 21, (155 + root) / 1200);
  return nodes;
}

class SampleMeasurer {
 public:
  SampleMeasurer(const Surface& surface, const Mesh& mesh, const Parts& parts, unsigned threads,
                 double share)
      : surface_(surface),
        mesh_(mesh),
        parts_(parts),
        turns_over_(parts.turn_over()),
        threads_(threads),
        share_(share),
        centre_(mesh.bounds.centre()) {}

  Measures run(Covered covered) {
    integrate_triangles();
    if (covered != Covered::Part) take_domain();
    find_ranges(covered);
    return result_;
  }

 private:
  /// Takes the integrals over the domain if they are the better known ones. The triangles' ones
  /// are not known better than the two agree, as where the integrand goes to infinity.
  void take_domain() {
    Integrals all = integrate_domain(surface_, centre_, mesh_.bounds.diagonal(), threads_, share_);
    result_.evaluations += all.evaluations;
    if (surface_.flip) all.volume.value = -all.volume.value;
    if (turns_over_) all.volume = result_.volume;
    const double off = std::fabs(all.area.value - result_.area.value);
    const bool is_better =
        off <= kSpoilt * result_.area.value && all.area.error <= std::max(off, result_.area.error);
    if (is_better) {
      result_.area = all.area;
      result_.volume = all.volume;
      return;
    }
    const auto widen = [](const Estimate& other, Estimate& own) {
      own.error = std::max(own.error, std::fabs(other.value - own.value));
    };
    widen(all.area, result_.area);
    widen(all.volume, result_.volume);
  }

  void integrate_triangles() {
    for (std::size_t begin = 0; begin < mesh_.triangles.size(); begin += kTriangleBlock) {
      integrate(std::span(mesh_.triangles)
                    .subspan(begin, std::min(kTriangleBlock, mesh_.triangles.size() - begin)));
    }
    for (const auto& [part, sides] : turning_) {
      const double sign = sides.turns_over && sides.flat < 0 ? -1 : 1;
      flat_.volume += sign * sides.flat;
      result_.volume.value += sign * sides.exact;
    }
    result_.area.error = std::fabs(result_.area.value - flat_.area);
    result_.volume.error = std::fabs(result_.volume.value - flat_.volume);
  }

  void integrate(std::span<const Triangle> triangles) {
    std::vector<dvec2> uv;
    uv.reserve(triangles.size() * rule_.size());
    for (const Triangle& t : triangles) {
      for (const RadonNode& node : rule_) {
        dvec2 place(0);
        for (std::size_t k = 0; k < 3; ++k) place += node.corners[k] * mesh_.uv[t[k]];
        uv.push_back(place);
      }
    }
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
    result_.evaluations += points.size();
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      add(triangles[k], std::span(points).subspan(k * rule_.size(), rule_.size()));
    }
  }

  void add(const Triangle& t, std::span<const SurfacePoint> points) {
    const dvec3 a = mesh_.position[t[0]] - centre_;
    const dvec3 flat_area =
        0.5 * glm::cross(mesh_.position[t[1]] - centre_ - a, mesh_.position[t[2]] - centre_ - a);
    const double flat = glm::length(flat_area);
    const dvec2 side = mesh_.uv[t[1]] - mesh_.uv[t[0]];
    const dvec2 other = mesh_.uv[t[2]] - mesh_.uv[t[0]];
    const double size = 0.5 * (side.x * other.y - side.y * other.x);
    double area = 0;
    double volume = 0;
    for (std::size_t k = 0; k < rule_.size(); ++k) {
      const dvec3 across = glm::cross(points[k].r_u, points[k].r_v);
      area += rule_[k].weight * std::fabs(size) * glm::length(across);
      volume += rule_[k].weight * size * glm::dot(points[k].position - centre_, across) / 3;
    }
    const bool usable = std::fabs(area - flat) <= kSpoilt * flat && std::isfinite(volume);
    const double flat_volume = glm::dot(a, flat_area) / 3;
    result_.area.value += usable ? area : flat;
    flat_.area += flat;
    add_volume(&t - mesh_.triangles.data(), usable ? volume : flat_volume, flat_volume);
  }

  /// Where front and back change places within a part, the volume is that of its outside.
  void add_volume(std::ptrdiff_t triangle, double exact, double flat) {
    if (!turns_over_) {
      result_.volume.value += exact;
      flat_.volume += flat;
      return;
    }
    const auto t = static_cast<std::size_t>(triangle);
    const double sign = parts_.turned[t] != 0 ? -1 : 1;
    Volume& part = turning_[parts_.first[t]];
    part.turns_over = part.turns_over || parts_.turned[t] != 0;
    part.exact += sign * exact;
    part.flat += sign * flat;
  }

  void find_ranges(Covered covered) {
    std::optional<Bounds> within;
    if (covered == Covered::Part) within = mesh_.bounds;
    const ValueRanges ranges = find_extremes(surface_, mesh_.uv, within, share_, threads_);
    result_.gauss = ranges[kGauss];
    result_.mean = ranges[kMean];
    result_.extents = result_.extents_bounds = mesh_.bounds;
    if (covered == Covered::Part) return;
    for (int k = 0; k < 3; ++k) {
      const ValueRange& range = ranges[static_cast<std::size_t>(k)];
      if (range.empty()) continue;
      result_.extents.low[k] = std::min(result_.extents.low[k], range.low);
      result_.extents.high[k] = std::max(result_.extents.high[k], range.high);
      result_.extents_bounds.low[k] = range.bounds.low;
      result_.extents_bounds.high[k] = range.bounds.high;
    }
  }

  const Surface& surface_;
  const Mesh& mesh_;
  const Parts& parts_;
  bool turns_over_;
  unsigned threads_;
  double share_;
  dvec3 centre_;  // volumes are taken around it, which keeps their digits far from the origin
  std::array<RadonNode, 7> rule_ = radon_rule();
  struct {
    double area = 0;
    double volume = 0;
  } flat_;  // of the triangles themselves
  /// The volume of a part, with the front where its first triangle has it.
  struct Volume {
    double exact = 0;
    double flat = 0;
    bool turns_over = false;  ///< front and back change places within it
  };
  std::map<std::uint32_t, Volume> turning_;  // by the first triangle
  Measures result_;
};

}  // namespace

Measures measure_surface(const Surface& surface, const Mesh& mesh, const Parts& parts,
                         Covered covered, unsigned threads, double share) {
  return SampleMeasurer(surface, mesh, parts, threads, share).run(covered);
}

}  // namespace saddle
