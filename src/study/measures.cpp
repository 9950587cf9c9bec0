#include "study/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "study/climb.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Triangles whose points are evaluated together: some MB.
constexpr std::size_t kTriangleBlock = 4096;
/// An integral over a triangle that differs from the flat triangle's by more than this share is
/// spoilt by a derivative that goes to infinity; the flat one is then the better.
constexpr double kSpoilt = 0.1;
/// |r_u x r_v| below this part of |r_u| |r_v|, and tangents below this part of the usual, cost
/// curvatures more than half of their digits.
constexpr double kWellConditioned = 1e-3;
constexpr double kShortTangent = 1e-5;
/// A curvature that a search from a vertex finds may be larger by this part of the largest; one
/// that is more so grows toward a place where there is none.
constexpr double kBetweenVertices = 0.25;
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

/// The median length of a tangent.
double usual_length(const std::vector<SurfacePoint>& points, dvec3 SurfacePoint::*tangent) {
  std::vector<double> lengths;
  for (const SurfacePoint& p : points) {
    if (is_finite(p.*tangent)) lengths.push_back(safe_length(p.*tangent));
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + std::ssize(lengths) / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

class SampleMeasurer {
 public:
  SampleMeasurer(const Surface& surface, const Mesh& mesh, unsigned threads)
      : surface_(surface), mesh_(mesh), threads_(threads), centre_(mesh.bounds.centre()) {}

  Measures run(Covered covered) {
    integrate_triangles();
    result_.extents = mesh_.bounds;
    if (covered != Covered::Part) take_domain();
    if (covered == Covered::Whole) extend();
    add_curvatures();
    return result_;
  }

 private:
  /// Takes the integrals over the domain if they are the better known ones. The triangles' ones
  /// are not known better than the two agree, as where the integrand goes to infinity.
  void take_domain() {
    Integrals all = integrate_domain(surface_, centre_, mesh_.bounds.diagonal(), threads_);
    result_.evaluations += all.evaluations;
    if (surface_.flip) all.volume.value = -all.volume.value;
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
    result_.volume.value += usable ? volume : flat_volume;
    flat_.area += flat;
    flat_.volume += flat_volume;
  }

  /// The largest values of `value` at the mesh's vertices, and from there on.
  Peak largest(const ValuesAt& value, std::span<const double> at_vertices) const {
    const auto best = std::ranges::max_element(
        at_vertices, [](double a, double b) { return a < b || (std::isnan(a) && !std::isnan(b)); });
    return climb(surface_.domain,
                 {mesh_.uv[static_cast<std::size_t>(best - at_vertices.begin())], *best}, value);
  }

  void extend() {
    for (int k = 0; k < 3; ++k) {
      for (const double sign : {1.0, -1.0}) {
        const ValuesAt value = [&](std::span<const dvec2> uv) {
          std::vector<double> numbers;
          for (const SurfacePoint& p : evaluate(surface_, uv, 1)) {
            numbers.push_back(sign * p.position[k]);
          }
          return numbers;
        };
        std::vector<double> at_vertices;
        for (const dvec3& p : mesh_.position) at_vertices.push_back(sign * p[k]);
        const double farthest = sign * largest(value, at_vertices).value;
        dvec3& corner = sign > 0 ? result_.extents.high : result_.extents.low;
        if (std::isfinite(farthest)) corner[k] = farthest;
      }
    }
  }

  /// Curvatures; Gauss and mean are NaN where they would have lost most of their digits.
  std::vector<Curvature> curvatures(std::span<const dvec2> uv,
                                    std::span<const SurfacePoint> points) const {
    std::vector<Curvature> result = evaluate_curvature(surface_, uv, threads_);
    for (std::size_t k = 0; k < uv.size(); ++k) {
      const double size_u = safe_length(points[k].r_u);
      const double size_v = safe_length(points[k].r_v);
      const dvec3 across = glm::cross(points[k].r_u / size_u, points[k].r_v / size_v);
      const bool usable = glm::length(across) > kWellConditioned &&
                          size_u >= kShortTangent * usual_u_ && size_v >= kShortTangent * usual_v_;
      if (!usable) result[k].gauss = result[k].mean = std::nan("");
    }
    return result;
  }

  static std::vector<double> numbers(std::span<const Curvature> curvatures,
                                     double Curvature::*which) {
    std::vector<double> result;
    result.reserve(curvatures.size());
    for (const Curvature& c : curvatures) {
      result.push_back(std::isfinite(c.*which) ? c.*which : std::nan(""));
    }
    return result;
  }

  void add_curvatures() {
    const std::vector<SurfacePoint> points = evaluate(surface_, mesh_.uv, threads_);
    usual_u_ = usual_length(points, &SurfacePoint::r_u);
    usual_v_ = usual_length(points, &SurfacePoint::r_v);
    result_.evaluations += points.size();
    const std::vector<Curvature> all = curvatures(mesh_.uv, points);
    add_curvature(&Curvature::gauss, numbers(all, &Curvature::gauss), result_.gauss);
    add_curvature(&Curvature::mean, numbers(all, &Curvature::mean), result_.mean);
  }

  void add_curvature(double Curvature::*which, const std::vector<double>& at_vertices,
                     Extremes& range) const {
    for (const double x : at_vertices) {
      if (!std::isnan(x)) range.add(x);
    }
    if (range.empty()) return;
    const double most = kBetweenVertices * std::max(std::fabs(range.low), std::fabs(range.high));
    for (const double sign : {1.0, -1.0}) {
      const auto turned = [sign](std::vector<double> numbers) {
        for (double& x : numbers) x *= sign;
        return numbers;
      };
      const ValuesAt value = [&](std::span<const dvec2> uv) {
        return turned(numbers(curvatures(uv, evaluate(surface_, uv, threads_)), which));
      };
      double& end = sign > 0 ? range.high : range.low;
      const double found = sign * largest(value, turned(at_vertices)).value;
      if (std::fabs(found - end) <= most) end = found;
    }
  }

  const Surface& surface_;
  const Mesh& mesh_;
  unsigned threads_;
  dvec3 centre_;  // volumes are taken around it, which keeps their digits far from the origin
  std::array<RadonNode, 7> rule_ = radon_rule();
  double usual_u_ = 0;  // lengths of tangents
  double usual_v_ = 0;
  struct {
    double area = 0;
    double volume = 0;
  } flat_;  // of the triangles themselves
  Measures result_;
};

}  // namespace

Measures measure_surface(const Surface& surface, const Mesh& mesh, Covered covered,
                         unsigned threads) {
  return SampleMeasurer(surface, mesh, threads).run(covered);
}

}  // namespace saddle
