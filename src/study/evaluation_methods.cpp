#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "base/random.h"
#include "eval/batch.h"
#include "mesh/grid/grid.h"
#include "study/methods.h"
#include "study/muparser_method.h"
#include "surface/parameter_box.h"

namespace saddle {
namespace {

/// Positions on a grid of so many intervals each way: a fine mesh's worth.
constexpr std::size_t kIntervals = 384;
/// So many of its vertices are compared with the truth.
constexpr std::size_t kCompared = 1000;

/// The grid, as lines and as a point for each vertex.
struct Samples {
  std::vector<double> line_u, line_v;
  std::vector<double> u, v;
};

Samples sample(const Domain& domain) {
  Samples s;
  s.line_u = even_lines(domain.u0, domain.u1, kIntervals);
  s.line_v = even_lines(domain.v0, domain.v1, kIntervals);
  for (const double v : s.line_v) {
    s.u.insert(s.u.end(), s.line_u.begin(), s.line_u.end());
    s.v.insert(s.v.end(), s.line_u.size(), v);
  }
  return s;
}

/// The reference for the outputs of a method.
struct Reference {
  std::vector<std::size_t> vertices;
  std::vector<TruePosition> truth;
  double last_place = 0;  ///< unit of errors
};

Reference make_reference(const Subject& subject, const Samples& samples) {
  Reference result;
  std::vector<dvec2> uv;
  for (std::size_t k = 0; k < kCompared; ++k) {
    const double place = random_unit(k) * static_cast<double>(samples.u.size());
    result.vertices.push_back(static_cast<std::size_t>(place));
    uv.emplace_back(samples.u[result.vertices.back()], samples.v[result.vertices.back()]);
  }
  result.truth = subject.truth.positions(uv, subject.threads);
  double largest = 0;
  for (const TruePosition& p : result.truth) {
    if (!is_finite(p.value)) continue;
    const dvec3 size = glm::abs(p.value);
    largest = std::max({largest, size.x, size.y, size.z});
  }
  result.last_place = std::nextafter(largest, HUGE_VAL) - largest;
  return result;
}

using Outputs = std::array<std::vector<double>, 3>;

/// The largest error, in last places; infinite where a position is missing that there is.
double error_of(const Outputs& outputs, const Reference& reference) {
  double worst = 0;
  for (std::size_t k = 0; k < reference.vertices.size(); ++k) {
    const TruePosition& truth = reference.truth[k];
    if (!is_finite(truth.value)) continue;
    for (int c = 0; c < 3; ++c) {
      const double computed = outputs[static_cast<std::size_t>(c)][reference.vertices[k]];
      const double off = std::fabs((computed - truth.value[c]) - truth.rest[c]);
      worst = std::max(worst, std::isfinite(off) ? off : HUGE_VAL);
    }
  }
  return worst / reference.last_place;
}

std::string threads_text(unsigned threads) {
  return std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

/// One, two, four ... threads, up to all that may be used.
std::vector<unsigned> thread_counts(unsigned allowed) {
  const unsigned all = allowed == 0 ? available_threads() : allowed;
  std::vector<unsigned> counts;
  for (unsigned n = 1; n < all; n *= 2) counts.push_back(n);
  counts.push_back(all);
  return counts;
}

}  // namespace

std::vector<Measurement> measure_evaluation(const Subject& subject, const StudyProgress& progress) {
  const std::vector<unsigned> counts = thread_counts(subject.threads);
  PanelProgress bar(progress, 2 + 2 * counts.size());
  const Samples samples = sample(subject.bound.domain);
  const Reference reference = make_reference(subject, samples);
  const Tape tape = compile(subject.bound.graph, subject.bound.r);
  Outputs outputs;
  for (std::vector<double>& column : outputs) column.resize(samples.u.size());
  const std::array<double*, 3> to = {outputs[0].data(), outputs[1].data(), outputs[2].data()};

  std::vector<Measurement> result;
  const auto measure = [&](const char* method, const std::string& setting,
                           const std::function<void()>& work) {
    bar.next(method, setting);
    const Timing time = time_repeatedly(work);
    Measurement m{StudyPanel::Evaluation,       method, setting, time,
                  error_of(outputs, reference), "ulp",  {}};
    m.no_answer = std::isinf(m.error);
    result.push_back(m);
  };
  if (auto muparser = MuparserMethod::make(subject.bound.graph, subject.bound.r)) {
    measure("muparser scalar", threads_text(1),
            [&] { muparser->scalar(samples.u, samples.v, to); });
    // Debian's muparser takes all processors for bulk work.
    measure("muparser bulk", threads_text(available_threads()),
            [&] { muparser->bulk(samples.u, samples.v, to); });
  }
  for (const unsigned n : counts) {
    measure("tape", threads_text(n), [&] { evaluate_points(tape, samples.u, samples.v, to, n); });
  }
  for (const unsigned n : counts) {
    measure("tape hoisted", threads_text(n),
            [&] { evaluate_grid(tape, samples.line_u, samples.line_v, to, n); });
  }
  return result;
}

}  // namespace saddle
