#include "mesh/curve/curve.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "eval/batch.h"
#include "formula/derive.h"

namespace saddle {

ParametricCurve make_curve(Graph& graph, const Coordinates& r, double from, double to) {
  std::vector<NodeId> outputs(r.begin(), r.end());
  const std::vector<NodeId> slopes = derive(graph, r, kSymbolU);
  outputs.insert(outputs.end(), slopes.begin(), slopes.end());
  return {from, to, compile(graph, outputs), compile(graph, outputs, Powers::Whole)};
}

std::vector<CurvePoint> evaluate(const ParametricCurve& curve, std::span<const double> s) {
  constexpr std::size_t kOutputs = 6;
  const std::vector<double> v(s.size(), 0);
  std::vector<double> values(kOutputs * s.size());
  std::array<double*, kOutputs> outputs{};
  for (std::size_t k = 0; k < kOutputs; ++k) outputs[k] = values.data() + k * s.size();
  evaluate_points(curve.tape, s, v, outputs, 1);
  std::vector<CurvePoint> points(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    points[i] = {s[i],
                 {outputs[0][i], outputs[1][i], outputs[2][i]},
                 {outputs[3][i], outputs[4][i], outputs[5][i]}};
  }
  return points;
}

}  // namespace saddle
