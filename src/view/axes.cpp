#include "view/axes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace saddle {
namespace {

constexpr int kTicks = 5;
/// Of ticks and of the way to their labels, as a share of the box's diagonal.
constexpr double kTickLength = 0.015;
constexpr double kLabelDistance = 0.04;

void append_line(const dvec3& a, const dvec3& b, Mesh& marks) {
  const auto first = static_cast<std::uint32_t>(marks.position.size());
  for (const dvec3& p : {a, b}) {
    marks.position.push_back(p);
    marks.normal.push_back({0, 0, 1});
    marks.bounds.add(p);
  }
  marks.lines.push_back({first, first + 1});
}

std::string text_of(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// An edge that gets ticks: its axis, the corner it begins at, and the way out of the box.
struct Edge {
  int axis;
  dvec3 begin;
  dvec3 out;
};

/// From the usual side, where x goes to the right and y away, these are in front or at the left.
std::array<Edge, 3> edges_with_ticks(const Bounds& b) {
  return {Edge{0, b.low, {0, -1, 0}}, Edge{1, {b.high.x, b.low.y, b.low.z}, {1, 0, 0}},
          Edge{2, b.low, {-1, 0, 0}}};
}

void append_box(const Bounds& box, Mesh& marks) {
  const std::array<dvec3, 2> ends{box.low, box.high};
  const auto corner = [&](unsigned i) {
    return dvec3(ends[i & 1U].x, ends[i >> 1U & 1U].y, ends[i >> 2U & 1U].z);
  };
  for (unsigned i = 0; i < 8; ++i) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((i >> axis & 1U) == 0) append_line(corner(i), corner(i | 1U << axis), marks);
    }
  }
}

}  // namespace

std::vector<double> ticks(double low, double high, int count) {
  const double length = high - low;
  if (!(length > 0) || !std::isfinite(length)) return {};
  const double rough = length / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough) step = factor * power;
  }
  std::vector<double> result;
  const double first = std::ceil(low / step);
  for (int i = 0; (first + i) * step <= high && i <= 2 * count; ++i) {
    result.push_back((first + i) * step + 0.0);  // no -0
  }
  return result;
}

std::vector<AxisLabel> append_axes(const Bounds& box, Mesh& marks) {
  if (box.empty()) return {};
  append_box(box, marks);
  constexpr std::array kNames{"x", "y", "z"};
  const double size = box.diagonal();
  std::vector<AxisLabel> labels;
  for (const Edge& edge : edges_with_ticks(box)) {
    dvec3 place = edge.begin;
    for (const double value : ticks(box.low[edge.axis], box.high[edge.axis], kTicks)) {
      place[edge.axis] = value;
      append_line(place, place + kTickLength * size * edge.out, marks);
      labels.push_back({place + kLabelDistance * size * edge.out, text_of(value)});
    }
    place[edge.axis] = box.centre()[edge.axis];
    labels.push_back({place + 2.2 * kLabelDistance * size * edge.out,
                      kNames[static_cast<std::size_t>(edge.axis)]});
  }
  return labels;
}

}  // namespace saddle
