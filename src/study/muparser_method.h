// The evaluator that programs without one of their own use: muparser, one point at a time or in
// bulk. Formulas are put back into text from their graphs, so that every surface can be read.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "formula/graph.h"

namespace saddle {

class MuparserMethod {
 public:
  /// Nothing if a formula is too long for muparser, which cannot share what formulas have in
  /// common, or needs an operation that has no text.
  static std::optional<MuparserMethod> make(const Graph& graph, const std::array<NodeId, 3>& r);
  ~MuparserMethod();
  MuparserMethod(MuparserMethod&&) noexcept;
  MuparserMethod& operator=(MuparserMethod&&) noexcept;

  /// outputs[k][i] = coordinate k at (u[i], v[i]), by a call for each point and coordinate.
  void scalar(std::span<const double> u, std::span<const double> v,
              const std::array<double*, 3>& outputs);

  /// The same by one call for each coordinate. It runs on all threads if muparser was built to.
  void bulk(std::span<const double> u, std::span<const double> v,
            const std::array<double*, 3>& outputs);

 private:
  struct Impl;
  explicit MuparserMethod(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace saddle
