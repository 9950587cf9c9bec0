// saddle chart: what it writes, and what it refuses.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "base/image_png.h"
#include "cli/program.h"

namespace saddle {
namespace {

/// A row's cells by column.
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result(1);
  for (const char c : line) {
    if (c == ',') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

std::vector<Row> rows_of(std::istream& in) {
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "panel,method,setting,milliseconds,error,unit,promise,triangles,pareto");
  const std::vector<std::string> names = cells(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = cells(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = values.at(k);
    rows.push_back(row);
  }
  return rows;
}

class ChartCommand : public ProgramTest {};

TEST_F(ChartCommand, MeasuresEveryMethodAndDrawsTheChart) {
  // A cone: its apex is a singular point in the middle of the range.
  const Outcome run = saddle({"chart", "x=v*cos(u)", "y=v*sin(u)", "z=v", "u=0:tau", "-s", "96x72",
                              "--samples", "60x40", "-o", "a.csv", "-o", "a.png", "-o", "a.svg"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");  // no progress bar in a pipe
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(files(), (std::vector<std::string>{"a.csv", "a.png", "a.svg"}));
  EXPECT_GE(read_png(path("a.png")).image.width, 1200);

  std::ifstream in(path("a.csv"));
  std::set<std::string> methods;
  std::set<std::string> with_samples;  // panels that have the grid of --samples
  std::map<std::string, double> worst;
  for (const Row& row : rows_of(in)) {
    const std::string method = row.at("panel") + "/" + row.at("method");
    methods.insert(method);
    if (row.at("setting") == "60x40") with_samples.insert(method);
    EXPECT_GT(std::stod(row.at("milliseconds")), 0);
    EXPECT_FALSE(row.at("method") == "least triangles");  // a cone needs none: it is developable
    EXPECT_TRUE(row.at("pareto") == "0" || row.at("pareto") == "1");
    worst[method] = std::max(worst[method], std::stod(row.at("error")));
  }
  for (const char* const method :
       {"evaluation/muparser scalar", "evaluation/muparser bulk", "evaluation/tape",
        "evaluation/tape hoisted", "normals/central differences", "normals/mean of faces",
        "normals/derivative", "normals/derivative with limits", "mesh/uniform", "mesh/adaptive",
        "mesh/adaptive certified", "image/per vertex", "image/per pixel", "image/exact normal",
        "image/uniform grid", "image/supersampling"}) {
    EXPECT_TRUE(methods.contains(method)) << method;
  }
  EXPECT_EQ(with_samples, (std::set<std::string>{"image/uniform grid", "mesh/uniform"}));
  EXPECT_LT(worst["evaluation/tape hoisted"], 4);
  EXPECT_GT(worst["normals/derivative"], 1);  // the apex
  EXPECT_LT(worst["normals/derivative with limits"], 1e-9);
}

TEST_F(ChartCommand, SaysWhichPackageHasGnuplotBeforeItMeasuresAnything) {
  const std::string path_before = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const Outcome run = saddle({"chart", "torus", "-o", "a.svg"});
  setenv("PATH", path_before.c_str(), 1);
  const std::string said = error_of(run, 1);
  EXPECT_TRUE(contains(said, "gnuplot")) << said;
  EXPECT_TRUE(contains(said, "gnuplot-nox")) << said;
  EXPECT_TRUE(files().empty());
}

TEST_F(ChartCommand, RefusesWhatIsNoChart) {
  EXPECT_TRUE(contains(error_of(saddle({"chart", "torus"}), 2), "where the chart goes"));
  EXPECT_TRUE(contains(error_of(saddle({"chart", "torus", "-o", "a.ply"}), 2), ".svg .png .csv"));
  EXPECT_TRUE(contains(error_of(saddle({"chart", "torus", "-o", "-"}), 2), "--format csv"));
  EXPECT_TRUE(contains(error_of(saddle({"chart", "toru", "-o", "a.csv"}), 2), "torus"));
  EXPECT_TRUE(contains(error_of(saddle({"chart", "torus", "-o", "no/a.csv"}), 1), "no/a.csv"));
  EXPECT_TRUE(contains(error_of(saddle({"chart", "torus", "--tolerance", "1px", "-o", "a.csv"}), 2),
                       "--tolerance"));
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace saddle
