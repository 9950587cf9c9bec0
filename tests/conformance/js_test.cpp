// Every operation in JavaScript, as pages have it, against 50 digits.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "base/file.h"
#include "conformance/evaluators.h"
#include "conformance/reference.h"
#include "conformance/report.h"
#include "export/page/page_sources.h"
#include "formula/js.h"
#include "temporary_folder.h"

namespace saddle::testing {
namespace {

/// JavaScript's own functions are not specified; those of V8 are measured to be within this.
constexpr double kMostUlps = 4;

/// Statements that compute the row's values and write them, as the bytes of doubles.
std::string script_of(const Operation& row, const std::vector<Arguments>& all,
                      const std::string& file) {
  std::string script(page_source("functions.js"));
  script += "const values = [";
  for (const auto& [a, b, c] : all) {
    script += "[" + js_number(a) + "," + js_number(b) + "," + js_number(c) + "],";
  }
  script += "].map(([a, b, c]) => " + std::string(js_text(row.op)) + ");\n";
  return script + "require('fs').writeFileSync('" + file +
         "', Buffer.from(Float64Array.from(values).buffer));\n";
}

std::vector<double> doubles_in(const std::string& file) {
  const std::string bytes = read_file(file);
  std::vector<double> values(bytes.size() / sizeof(double));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

TEST(Conformance, EveryOperationIsExactInJavaScript) {
  if (std::system("nodejs --version >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "no nodejs to run JavaScript with: apt-get install nodejs";
  }
  const TemporaryFolder folder;
  for (const Operation& row : kOperations) {
    const std::vector<Arguments> all = arguments_of(row);
    const std::string script = (folder.path() / "row.js").string();
    const std::string file = (folder.path() / "values").string();
    std::ofstream(script) << script_of(row, all, file);
    ASSERT_EQ(std::system(("nodejs " + script).c_str()), 0) << row.id;
    const std::vector<double> values = doubles_in(file);
    ASSERT_EQ(values.size(), all.size()) << row.id;
    const double bound = std::max(kMostUlps, row.ulps);
    Worst worst;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Real exact = reference(row.op, all[i]);
      const double error = error_in_ulps(row.op, all[i], values[i], exact);
      worst.take(error, all[i], values[i]);
      EXPECT_LE(error, bound) << row.id << " of " << all[i].a << ", " << all[i].b << ", "
                              << all[i].c << ": " << values[i] << " is not " << exact;
    }
    show("javascript", row.id, bound, worst);
  }
}

}  // namespace
}  // namespace saddle::testing
