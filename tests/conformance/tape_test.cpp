// Every operation against 50 digits: the plain function, and the loops of every CPU level.
#include <gtest/gtest.h>

#include "conformance/evaluators.h"
#include "conformance/reference.h"
#include "conformance/report.h"

namespace saddle::testing {
namespace {

/// The arguments of one row, and the truth.
struct Cases {
  std::vector<Arguments> at;
  std::vector<Real> exact;
};

Cases cases_of(const Operation& row) {
  Cases cases{arguments_of(row), {}};
  for (const Arguments& at : cases.at) cases.exact.push_back(reference(row.op, at));
  return cases;
}

void expect_exact(const char* evaluator, const Operation& row, const Cases& cases,
                  const std::vector<double>& values) {
  Worst worst;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double error = error_in_ulps(row.op, cases.at[i], values[i], cases.exact[i]);
    worst.take(error, cases.at[i], values[i]);
    EXPECT_LE(error, row.ulps) << evaluator << " " << row.id << " of " << cases.at[i].a << ", "
                               << cases.at[i].b << ", " << cases.at[i].c << ": " << values[i]
                               << " is not " << cases.exact[i];
  }
  show(evaluator, row.id, row.ulps, worst);
}

TEST(Conformance, EveryOperationIsWithinItsBoundOnEveryCpuLevel) {
  for (const Operation& row : kOperations) {
    const Cases cases = cases_of(row);
    expect_exact("plain", row, cases, plain_values(row.op, cases.at));
    for (std::size_t level = 0; level < supported_level_count(); ++level) {
      const CpuLevel cpu = static_cast<CpuLevel>(level);
      expect_exact(level_name(cpu), row, cases, loop_values(cpu, row.op, cases.at));
    }
  }
}

}  // namespace
}  // namespace saddle::testing
