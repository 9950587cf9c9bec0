#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "base/format.h"
#include "eval/batch.h"
#include "mesh/grid/grid.h"
#include "study/methods.h"
#include "surface/parameter_box.h"

namespace saddle {
namespace {

/// Normals on a grid of so many intervals each way; those of every kStride-th vertex are compared.
constexpr std::size_t kNormalIntervals = 192;
constexpr std::size_t kStride = 8;
/// A normal that is missing is as wrong as one can be.
constexpr double kMissing = 180;

const std::array<double, 11> kDifferenceSteps = {1e-1, 1e-2, 1e-3, 1e-4,  1e-5, 1e-6,
                                                 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
constexpr const char* kDifferences = "central differences";
/// Times that the grid of faces is finer than the grid of normals.
const std::array<std::size_t, 4> kFiner = {1, 2, 4, 8};

using Column = std::vector<double>;

struct Lines {
  std::vector<double> u, v;
  std::size_t count() const { return u.size() * v.size(); }
};

Lines lines(const Domain& d, std::size_t intervals) {
  return {even_lines(d.u0, d.u1, intervals), even_lines(d.v0, d.v1, intervals)};
}

/// Runs a tape on the grid: a column for each output.
std::vector<Column> run(const Tape& tape, const Lines& at, unsigned threads) {
  std::vector<Column> columns(tape.outputs.size(), Column(at.count()));
  std::vector<double*> to;
  to.reserve(columns.size());
  for (Column& column : columns) to.push_back(column.data());
  evaluate_grid(tape, at.u, at.v, to, threads);
  return columns;
}

template <class Columns>
dvec3 vector_at(const Columns& columns, std::size_t first, std::size_t i) {
  return {columns[first][i], columns[first + 1][i], columns[first + 2][i]};
}

/// The cell that a vertex of the grid belongs to: the next one, or the last of its row.
std::size_t cell_of(std::size_t line) {
  return std::min(line, kNormalIntervals - 1);
}

Approach approach(const Lines& at, std::size_t i, std::size_t j) {
  const std::size_t ci = cell_of(i);
  const std::size_t cj = cell_of(j);
  return {{at.u[i], at.v[j]}, {0.5 * (at.u[ci] + at.u[ci + 1]), 0.5 * (at.v[cj] + at.v[cj + 1])}};
}

class NormalStudy {
 public:
  NormalStudy(const Subject& subject, const StudyProgress& progress)
      : subject_(subject),
        progress_(progress, kDifferenceSteps.size() + kFiner.size() + 2),
        at_(lines(subject.bound.domain, kNormalIntervals)),
        positions_(compile(subject.bound.graph, subject.bound.r)),
        normals_(kNormalIntervals + 1, std::vector<dvec3>(kNormalIntervals + 1)) {
    std::vector<Approach> approaches;
    for (std::size_t j = 0; j <= kNormalIntervals; j += kStride) {
      for (std::size_t i = 0; i <= kNormalIntervals; i += kStride) {
        approaches.push_back(approach(at_, i, j));
      }
    }
    truth_ = subject.truth.normals(approaches, subject.threads);
  }

  std::vector<Measurement> measure() {
    const Timing time =
        time_repeatedly([&] { differences(kDifferenceSteps[0]); });  // the same for any h
    for (const double h : kDifferenceSteps) {
      const std::string setting = "h=" + rounded(h, kSettingDigits);
      progress_.next(kDifferences, setting);
      differences(h);
      add(kDifferences, setting, time);
    }
    for (const std::size_t finer : kFiner) {
      const std::string n = std::to_string(finer * kNormalIntervals);
      add("mean of faces", n + "x" + n, [&] { mean_of_faces(finer); });
    }
    add("derivative", "plain", [&] { derivatives(); });
    add("derivative with limits", "one-sided", [&] { limits(); });
    return std::move(result_);
  }

 private:
  void add(const char* method, const std::string& setting, const std::function<void()>& work) {
    progress_.next(method, setting);
    add(method, setting, time_repeatedly(work));
  }
  void add(const char* method, const std::string& setting, const Timing& time) {
    Measurement m{StudyPanel::Normals, method, setting, time, error(), "degrees", {}};
    m.no_answer = m.error >= kMissing;
    result_.push_back(m);
  }

  double error() const {
    double worst = 0;
    std::size_t k = 0;
    for (std::size_t j = 0; j <= kNormalIntervals; j += kStride) {
      for (std::size_t i = 0; i <= kNormalIntervals; i += kStride, ++k) {
        if (!truth_[k]) continue;
        const double off = degrees_between(normals_[j][i], *truth_[k]);
        worst = std::max(worst, is_finite(normals_[j][i]) ? off : kMissing);
      }
    }
    return worst;
  }

  template <class F>
  void set_normals(F normal) {
    for (std::size_t j = 0; j <= kNormalIntervals; ++j) {
      for (std::size_t i = 0; i <= kNormalIntervals; ++i) normals_[j][i] = normal(i, j);
    }
  }

  /// The positions on the grid moved by a step.
  std::vector<Column> moved(double du, double dv) const {
    Lines there = at_;
    for (double& u : there.u) u += du;
    for (double& v : there.v) v += dv;
    return run(positions_, there, subject_.threads);
  }

  /// `h` is a share of the ranges.
  void differences(double h) {
    const Domain& d = subject_.bound.domain;
    const double du = h * (d.u1 - d.u0);
    const double dv = h * (d.v1 - d.v0);
    const std::array<std::vector<Column>, 4> around = {moved(du, 0), moved(-du, 0), moved(0, dv),
                                                       moved(0, -dv)};
    set_normals([&](std::size_t i, std::size_t j) {
      const std::size_t k = j * at_.u.size() + i;
      return glm::normalize(glm::cross(vector_at(around[0], 0, k) - vector_at(around[1], 0, k),
                                       vector_at(around[2], 0, k) - vector_at(around[3], 0, k)));
    });
  }

  /// The mean of the normals of the faces around each vertex, weighted by their areas.
  void mean_of_faces(std::size_t finer) {
    const Lines fine = lines(subject_.bound.domain, finer * kNormalIntervals);
    const std::vector<Column> p = run(positions_, fine, subject_.threads);
    const std::size_t last = finer * kNormalIntervals;
    const auto position = [&](std::size_t i, std::size_t j) {
      return vector_at(p, 0, j * fine.u.size() + i);
    };
    /// Twice the area vector of the cell's two faces.
    const auto face = [&](std::size_t i, std::size_t j) {
      return glm::cross(position(i + 1, j + 1) - position(i, j),
                        position(i, j + 1) - position(i + 1, j));
    };
    set_normals([&](std::size_t i, std::size_t j) {
      dvec3 sum(0);
      const std::size_t fi = finer * i;
      const std::size_t fj = finer * j;
      for (std::size_t cj = fj > 0 ? fj - 1 : 0; cj <= std::min(fj, last - 1); ++cj) {
        for (std::size_t ci = fi > 0 ? fi - 1 : 0; ci <= std::min(fi, last - 1); ++ci) {
          const dvec3 area = face(ci, cj);
          if (is_finite(area)) sum += area;
        }
      }
      return glm::normalize(sum);
    });
  }

  void derivatives() {
    const NormalColumns n = normals();
    set_normals([&](std::size_t i, std::size_t j) {
      return vector_at(n, kNormalColumn, j * at_.u.size() + i);
    });
  }

  /// As meshes do it: where |r_u x r_v| is small beside what is around, the limit from inside.
  void limits() {
    const NormalColumns n = normals();
    const std::size_t row = at_.u.size();
    std::vector<std::array<std::size_t, 2>> singular;
    set_normals([&](std::size_t i, std::size_t j) {
      const std::size_t k = j * row + i;
      const std::size_t inner = cell_of(j) * row + cell_of(i);
      double square_u = 0;  // largest |r_u|^2, |r_v|^2 of the cell
      double square_v = 0;
      for (const std::size_t corner : {inner, inner + 1, inner + row, inner + row + 1}) {
        square_u = std::fmax(square_u, n[kSquareUColumn][corner]);
        square_v = std::fmax(square_v, n[kSquareVColumn][corner]);
      }
      const dvec3 normal = vector_at(n, kNormalColumn, k);
      const bool regular = n[kAreaColumn][k] > kDegenerateCross * std::sqrt(square_u * square_v);
      if (!regular || !is_finite(normal)) singular.push_back({i, j});
      return normal;
    });
    std::vector<Approach> approaches;
    approaches.reserve(singular.size());
    for (const auto& [i, j] : singular) approaches.push_back(approach(at_, i, j));
    const auto found = limit_normals(subject_.surface, approaches, subject_.threads);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const dvec3 none(std::nan(""));
      const dvec3 normal = found[k].normal.value_or(none);
      normals_[singular[k][1]][singular[k][0]] = subject_.surface.flip ? -normal : normal;
    }
  }

  NormalColumns normals() const {
    return evaluate_normals_on_grid(subject_.surface, at_.u, at_.v, subject_.threads);
  }

  const Subject& subject_;
  PanelProgress progress_;
  Lines at_;
  Tape positions_;
  std::vector<std::vector<dvec3>> normals_;  ///< along r_u x r_v, by row and column
  std::vector<std::optional<dvec3>> truth_;
  std::vector<Measurement> result_;
};

}  // namespace

std::vector<Measurement> measure_normals(const Subject& subject, const StudyProgress& progress) {
  return NormalStudy(subject, progress).measure();
}

}  // namespace saddle
