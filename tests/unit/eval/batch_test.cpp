// Tapes give what the graph says, on grids and lists of points, for any number of threads; tiles
// cover a grid.
#include "eval/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "formula/derive.h"
#include "graph_value.h"
#include "random_formula.h"

namespace saddle {
namespace {

std::vector<double> steps(double from, double by, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = from + by * static_cast<double>(i);
  return values;
}

struct Grid {
  std::vector<double> u, v;
};

std::vector<double> on_grid(const Tape& tape, const Grid& grid, unsigned threads) {
  std::vector<double> out(grid.u.size() * grid.v.size());
  evaluate_grid(tape, grid.u, grid.v, std::vector<double*>{out.data()}, threads);
  return out;
}

std::vector<double> on_points(const Tape& tape, const Grid& grid, unsigned threads) {
  std::vector<double> u;
  std::vector<double> v;
  for (const double row : grid.v) {
    u.insert(u.end(), grid.u.begin(), grid.u.end());
    v.insert(v.end(), grid.u.size(), row);
  }
  std::vector<double> out(u.size());
  evaluate_points(tape, u, v, std::vector<double*>{out.data()}, threads);
  return out;
}

/// Equal to the bit; one NaN is as good as another, since the sum of two may be either.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::memcmp(&x, &y, sizeof x) == 0 || (std::isnan(x) && std::isnan(y));
  });
}

/// Powers are products in a tape and pow() in the graph: some ULP, more after cancellation.
constexpr double kPowerRounding = 1e-9;

bool close(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) == std::isnan(b);
  return a == b || std::fabs(a - b) <= kPowerRounding * (1 + std::fabs(a));
}

TEST(Batch, CountsPoints) {
  Graph graph;
  Tape tape = compile(graph, std::array{testing::parse(graph, "u*v")});
  const Tape copy = [&tape] {
    tape.count = std::make_shared<PointCount>();
    return tape;
  }();
  const Grid grid = {steps(0, 1, 9), steps(0, 1, 8)};
  on_grid(tape, grid, 3);
  EXPECT_EQ(tape.count->total(), 72U);
  on_points(copy, grid, 3);
  EXPECT_EQ(tape.count->total(), 2 * 72U) << "copies share the count";
}

TEST(Batch, ComputesWhatTheGraphSays) {
  testing::RandomFormula random(3);
  const Grid grid = {steps(-2.9, 0.61, 9), steps(-1.7, 0.43, 8)};
  for (int i = 0; i < 300; ++i) {
    Graph graph;
    const std::string text = random(1 + i % 5);
    const NodeId root = testing::parse(graph, text);
    // A power inside a step or a comparison may fall on the other side of it.
    if (text.find('^') != std::string::npos && text.find_first_of("<>=!r&|?") != std::string::npos)
      continue;
    const std::vector<double> values = on_grid(compile(graph, std::vector{root}), grid, 1);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double u = grid.u[k % grid.u.size()];
      const double v = grid.v[k / grid.u.size()];
      ASSERT_TRUE(close(testing::value(graph, root, u, v), values[k]))
          << text << " at " << u << ", " << v << ": " << values[k];
    }
  }
}

TEST(Batch, GivesTheSameBitsOnGridsAndPointsForAnyNumberOfThreads) {
  // Larger than a block each way, and more than one chunk.
  const Grid grid = {steps(-3, 0.011, 700), steps(-2, 0.013, 300)};
  for (const char* text : {"u", "v", "2", "sin(u)+1", "cos(v)", "sin(u)*cos(v)/(2+u*v)", "u^3*v^-2",
                           "sqrt(u)+ln(v)", "if(u>v,atan2(u,v),2)"}) {
    Graph graph;
    const Tape tape = compile(graph, std::vector{testing::parse(graph, text)});
    const std::vector<double> reference = on_grid(tape, grid, 1);
    EXPECT_TRUE(same_bits(reference, on_grid(tape, grid, 2))) << text;
    EXPECT_TRUE(same_bits(reference, on_grid(tape, grid, 5))) << text;
    EXPECT_TRUE(same_bits(reference, on_points(tape, grid, 1))) << text;
    EXPECT_TRUE(same_bits(reference, on_points(tape, grid, 3))) << text;
  }
}

TEST(GridTiling, CoversEveryCellOnce) {
  for (const auto& [cells_u, cells_v] : {std::pair{1, 1}, {7, 3}, {8, 16}, {17, 9}, {1, 30}}) {
    const GridTiling tiling(static_cast<std::size_t>(cells_u), static_cast<std::size_t>(cells_v),
                            8);
    std::vector<int> covered(static_cast<std::size_t>(cells_u * cells_v), 0);
    for (std::size_t k = 0; k < tiling.count(); ++k) {
      const GridTile tile = tiling.tile(k);
      EXPECT_EQ(tile.index, k);
      for (std::size_t j = tile.row; j + 1 < tile.row + tile.rows; ++j) {
        for (std::size_t i = tile.column; i + 1 < tile.column + tile.columns; ++i) {
          ++covered.at(j * static_cast<std::size_t>(cells_u) + i);
        }
      }
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), cells_u * cells_v);
  }
}

TEST(EvaluateTiles, HandsOutTheBitsOfTheWholeGrid) {
  Graph graph;
  const std::vector<NodeId> outputs = {testing::parse(graph, "sin(u)*cos(v)"),
                                       testing::parse(graph, "exp(u)"),
                                       testing::parse(graph, "v^3"), testing::parse(graph, "2")};
  const Tape tape = compile(graph, outputs);
  const std::vector<double> u = steps(-1, 0.1, 39);
  const std::vector<double> v = steps(-1, 0.13, 21);
  std::vector<std::vector<double>> whole(4, std::vector<double>(u.size() * v.size()));
  evaluate_grid(tape, u, v,
                std::vector{whole[0].data(), whole[1].data(), whole[2].data(), whole[3].data()});
  std::atomic<std::size_t> seen = 0;
  evaluate_tiles(tape, u, v, GridTiling(38, 20, 8), 2, [&](TileRows& rows) {
    std::size_t expected_row = rows.tile().row;
    while (rows.next()) {
      ASSERT_EQ(rows.row(), expected_row++);
      for (std::size_t k = 0; k < 4; ++k) {
        const Operand& from = rows.outputs()[k];
        for (std::size_t i = 0; i < rows.tile().columns; ++i) {
          const std::size_t vertex = rows.row() * u.size() + rows.tile().column + i;
          ASSERT_EQ(from.data[from.varies ? i : 0], whole[k][vertex]) << k;
        }
      }
      seen += rows.tile().columns;
    }
    EXPECT_EQ(expected_row, rows.tile().row + rows.tile().rows);
  });
  // Four inner borders each way, shared by two tiles.
  EXPECT_EQ(seen, (39 + 4) * (21 + 2));
}

TEST(Tape, RunsWhatDependsOnOneParameterOncePerColumnOrRow) {
  Graph graph;
  const Tape tape = compile(graph, std::vector{testing::parse(graph, "(2+cos(v))*cos(u)")});
  EXPECT_EQ(tape.of_u.size(), 1U);
  EXPECT_EQ(tape.of_v.size(), 2U);
  EXPECT_EQ(tape.of_both.size(), 1U);
}

TEST(Tape, ReusesSlots) {
  Graph graph;
  std::string text = "u*v";
  for (int i = 0; i < 50; ++i) text = "sin(" + text + ")";
  EXPECT_EQ(compile(graph, std::vector{testing::parse(graph, text)}).slots_both, 1U);
}

TEST(Tape, ComputesSineAndCosineOfTheSameArgumentAtOnce) {
  for (const char* text : {"sin(u*v)*cos(u*v)", "cos(u*v)-sin(u*v)"}) {
    Graph graph;
    const NodeId root = testing::parse(graph, text);
    const Tape tape = compile(graph, std::vector{root});
    ASSERT_EQ(tape.of_both.size(), 3U) << text;
    EXPECT_TRUE(tape.of_both[1].cosine.has_value());
    const Grid grid = {steps(-2, 0.7, 9), steps(0.1, 0.3, 5)};
    const std::vector<double> values = on_grid(tape, grid, 1);
    for (std::size_t k = 0; k < values.size(); ++k) {
      EXPECT_NEAR(values[k],
                  testing::value(graph, root, grid.u[k % grid.u.size()], grid.v[k / grid.u.size()]),
                  4 * std::numeric_limits<double>::epsilon());
    }
  }
}

TEST(Tape, TurnsWholePowersIntoProducts) {
  Graph graph;
  const Tape tape = compile(graph, std::vector{testing::parse(graph, "u^7+u^-2+u^0.5")});
  for (const Instruction& instruction : tape.of_u) EXPECT_NE(instruction.op, Op::Pow);
  EXPECT_EQ(on_grid(tape, {{4}, {0}}, 1)[0], 16384 + 1.0 / 16 + 2);
}

}  // namespace
}  // namespace saddle
