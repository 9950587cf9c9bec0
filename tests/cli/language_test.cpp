// Complex numbers, vectors and sums in each thing that the program makes of formulas.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

#include "base/file.h"
#include "cli/program.h"

namespace saddle {
namespace {

class LanguageRuns : public ProgramTest {};

const std::vector<std::vector<std::string>> kFormulas = {
    {"z=re((u+i*v)^3)"},
    {"z=im(sqrt(w^2-1))", "w=u+i*v", "u=-2:2", "v=-2:2"},
    {"xyz=c(u)+v*diff(c(u),u)", "c(s)=(cos(s),sin(s),s/4)", "v=0.1:1"},
    {"xyz=tube(k,u,r,v)", "k=(3*cos(u),2*sin(u),sin(2*u))", "r=0.4", "u=0:tau", "v=0:tau"},
    {"z=sum(sin(n*u)/n,n=1:9)*prod(cos(k*v),k=1:3)"},
};

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(LanguageRuns, GiveTheSameBytesOnEveryCpuLevel) {
  for (const std::vector<std::string>& formula : kFormulas) {
    for (const std::string level : {"sse2", "avx2", "avx512"}) {
      setenv("SADDLE_CPU", level.c_str(), 1);
      const Outcome run = saddle(with(formula, {"-q", "-o", level + ".ply"}));
      unsetenv("SADDLE_CPU");
      if (contains(run.err, "this processor does not have " + level)) continue;
      EXPECT_EQ(run.status, 0) << run.err;
      EXPECT_EQ(read_file(path(level + ".ply")), read_file(path("sse2.ply")))
          << formula[0] << level;
    }
  }
}

TEST_F(LanguageRuns, AreProvedWhereTheyAreSmooth) {
  for (const std::size_t k : {0U, 2U, 3U, 4U}) {
    const Outcome run = saddle(with(kFormulas[k], {"-o", "a.ply", "--report", "r.json"}));
    ASSERT_EQ(run.status, 0) << run.err;
    const auto report = nlohmann::json::parse(read_file(path("r.json")));
    EXPECT_EQ(report.at("surfaces").at(0).at("certified"), true) << kFormulas[k][0];
  }
}

TEST_F(LanguageRuns, HaveTheNormalOfTheFormulaInTheShader) {
  for (const std::vector<std::string>& formula : kFormulas) {
    const Outcome exact = small(with(formula, {"-q", "--shading", "exact", "-o", "exact.png"}));
    ASSERT_EQ(exact.status, 0) << exact.err;
    const Outcome pixel =
        small(with(formula, {"-q", "--reference", "exact.png", "-o", "pixel.png"}));
    EXPECT_EQ(pixel.status, 0) << formula[0] << pixel.err;
  }
}

TEST_F(LanguageRuns, AreChecked) {
  const Outcome root = saddle(with({"check"}, kFormulas[1]));
  EXPECT_TRUE(contains(root.out, "jumps       u = -0.99")) << root.out;
  EXPECT_TRUE(contains(root.out, "u = 0, v = -2:2")) << root.out;
  // A cut that ends, and goes on further away.
  const Outcome arcsine = saddle({"check", "z=im(asin(u+i*v))", "u=-3:3", "v=-2:2"});
  EXPECT_TRUE(contains(arcsine.out, "jumps       u = -3:-1.0")) << arcsine.out;
  EXPECT_TRUE(contains(arcsine.out, "; u = 1.0000")) << arcsine.out;
  const Outcome tube = saddle(with({"check"}, kFormulas[3]));
  EXPECT_TRUE(contains(tube.out, "a torus")) << tube.out;
}

TEST_F(LanguageRuns, AreCharted) {
  const Outcome run = saddle(with(with({"chart"}, kFormulas[2]), {"-q", "-o", "a.csv"}));
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string chart = read_file(path("a.csv"));
  EXPECT_TRUE(contains(chart, "\nevaluation,muparser scalar,")) << chart;
  EXPECT_TRUE(contains(chart, "\nnormals,derivative,plain,")) << chart;
}

TEST_F(LanguageRuns, ArePages) {
  for (const std::vector<std::string>& formula : kFormulas) {
    const Outcome run = saddle(with(formula, {"-q", "-o", "a.html"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(read_file(path("a.html")), "</html>"));
  }
}

}  // namespace
}  // namespace saddle
