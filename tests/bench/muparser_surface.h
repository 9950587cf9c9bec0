// A surface as programs without derivatives evaluate it: muparser, and normals from central
// differences.
#pragma once

#include <muParser.h>

#include <array>
#include <vector>

#include "base/vec.h"
#include "bench_surfaces.h"

namespace saddle {

class MuparserSurface {
 public:
  static constexpr double kStep = 1e-5;

  explicit MuparserSurface(const BenchSurface& formula) {
    for (std::size_t k = 0; k < 3; ++k) {
      parsers_[k].DefineConst("pi", kPi);
      parsers_[k].DefineVar("u", &u_);
      parsers_[k].DefineVar("v", &v_);
      parsers_[k].SetExpr(std::array{formula.x, formula.y, formula.z}[k]);
    }
  }

  dvec3 position(double u, double v) {
    u_ = u;
    v_ = v;
    return {parsers_[0].Eval(), parsers_[1].Eval(), parsers_[2].Eval()};
  }

  dvec3 normal(double u, double v) {
    const dvec3 by_u = position(u + kStep, v) - position(u - kStep, v);
    const dvec3 by_v = position(u, v + kStep) - position(u, v - kStep);
    return glm::normalize(glm::cross(by_u, by_v));
  }

 private:
  std::array<mu::Parser, 3> parsers_;
  double u_ = 0;
  double v_ = 0;
};

/// The same with muparser's bulk mode: arrays of u and v in, arrays of x, y, z out.
class MuparserBulkSurface {
 public:
  MuparserBulkSurface(const BenchSurface& formula, std::size_t count) : u_(count), v_(count) {
    for (std::size_t k = 0; k < 3; ++k) {
      parsers_[k].DefineConst("pi", kPi);
      parsers_[k].DefineVar("u", u_.data());
      parsers_[k].DefineVar("v", v_.data());
      parsers_[k].SetExpr(std::array{formula.x, formula.y, formula.z}[k]);
    }
  }

  /// Positions at (u[i] + du, v[i] + dv).
  std::array<std::vector<double>, 3> positions(const std::vector<double>& u,
                                               const std::vector<double>& v, double du, double dv) {
    for (std::size_t i = 0; i < u_.size(); ++i) {
      u_[i] = u[i] + du;
      v_[i] = v[i] + dv;
    }
    std::array<std::vector<double>, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
      result[k].resize(u_.size());
      parsers_[k].Eval(result[k].data(), static_cast<int>(u_.size()));
    }
    return result;
  }

 private:
  std::array<mu::Parser, 3> parsers_;
  std::vector<double> u_, v_;
};

}  // namespace saddle
