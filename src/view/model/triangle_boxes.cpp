#include "view/model/triangle_boxes.h"

#include <algorithm>
#include <limits>

#include "view/model/controls.h"

namespace saddle {

TriangleBoxes::TriangleBoxes(const Mesh& mesh) : triangles_(mesh.triangles.size()) {
  if (triangles_ == 0) return;
  std::vector<Bounds> boxes((triangles_ + kShare - 1) / kShare);
  for (std::size_t t = 0; t < triangles_; ++t) {
    for (const auto corner : mesh.triangles[t]) boxes[t / kShare].add(mesh.position[corner]);
  }
  levels_.push_back(std::move(boxes));
  while (levels_.back().size() > kShare) {
    const std::vector<Bounds>& below = levels_.back();
    std::vector<Bounds> above((below.size() + kShare - 1) / kShare);
    for (std::size_t i = 0; i < below.size(); ++i) above[i / kShare].add(below[i]);
    levels_.push_back(std::move(above));
  }
}

/// Between the three pairs of planes. An axis that the ray is parallel to divides by 0: the
/// infinities that come of it compare rightly, and a NaN, on a plane itself, leaves the others to
/// say.
/// Source: T. Kay, J. Kajiya, "Ray tracing complex scenes", 1986.
double TriangleBoxes::entry(const Ray& ray, const Bounds& box) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double inverse = 1 / ray.direction[k];
    const double a = (box.low[k] - ray.origin[k]) * inverse;
    const double b = (box.high[k] - ray.origin[k]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  // The box's planes are rounded: what is met on them is met.
  constexpr double kRoom = 1 + 1e-12;
  return enter <= leave * kRoom ? enter : std::numeric_limits<double>::infinity();
}

}  // namespace saddle
