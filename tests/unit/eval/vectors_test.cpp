#include "eval/vectors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/vec.h"

namespace saddle {
namespace {

std::vector<double> steps(std::size_t count, double by) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = by * static_cast<double>(i) - 1;
  return values;
}

/// Columns of which one is a number that stands for all.
struct TestVectors {
  std::vector<double> x = steps(600, 0.1);
  std::vector<double> y = steps(600, 1 / 3.0);
  double z = 1 / 7.0;
  std::array<Operand, 3> columns() const {
    return {{{x.data(), true}, {y.data(), true}, {&z, false}}};
  }
  dvec3 unit(std::size_t i) const { return dvec3(x[i], y[i], z) * (1 / length(i)); }
  double length(std::size_t i) const { return std::sqrt(x[i] * x[i] + y[i] * y[i] + z * z); }
};

/// Calls `check` with the loops of each CPU level and numbers of vectors around those of a block.
template <class Check>
void on_every_level(Check check) {
  for (std::size_t level = 0; level < supported_level_count(); ++level) {
    for (const std::size_t count : {1U, 3U, 256U, 257U, 600U}) {
      check(vector_loops(static_cast<CpuLevel>(level)), count);
    }
  }
}

TEST(VectorLoops, LayColumnsOneAfterTheOther) {
  const TestVectors vectors;
  on_every_level([&](const VectorLoops& loops, std::size_t count) {
    std::vector<double> to(3 * count + 1, -5);
    loops.interleave(vectors.columns().data(), count, to.data());
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(to[3 * i], vectors.x[i]);
      ASSERT_EQ(to[3 * i + 1], vectors.y[i]);
      ASSERT_EQ(to[3 * i + 2], vectors.z);
    }
    EXPECT_EQ(to[3 * count], -5) << "wrote past the end";
  });
}

TEST(VectorLoops, MakeVectorsUnit) {
  const TestVectors vectors;
  on_every_level([&](const VectorLoops& loops, std::size_t count) {
    TestVectors units = vectors;  // x and y are written in place
    std::vector<double> z(count + 1, -5);
    std::vector<double> lengths(count + 1, -5);
    const std::array to = {units.x.data(), units.y.data(), z.data()};
    loops.normalize(units.columns().data(), count, -1, to.data(), lengths.data());
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(dvec3(units.x[i], units.y[i], z[i]), -vectors.unit(i));
      ASSERT_EQ(lengths[i], vectors.length(i));
    }
    EXPECT_EQ(z[count], -5) << "wrote past the end";
    EXPECT_EQ(lengths[count], -5) << "wrote past the end";
    if (count < vectors.x.size()) {
      EXPECT_EQ(units.x[count], vectors.x[count]) << "wrote past the end";
    }
  });
}

TEST(VectorLoops, MakeVectorsUnitAtAnyScale) {
  on_every_level([](const VectorLoops& loops, std::size_t) {
    for (const double scale : {1e-300, 1e-200, 1e-150, 1e-100, 1.0, 1e100, 1e153, 1e200, 1e300}) {
      const std::array<double, 3> vector = {2 * scale, -1 * scale, 2 * scale};
      const std::array<Operand, 3> columns = {
          {{&vector[0], true}, {&vector[1], true}, {&vector[2], true}}};
      std::array<double, 3> unit{};
      double length = 0;
      std::array<float, 3> position{};
      std::array<float, 3> normal{};
      loops.normalize(columns.data(), 1, 1, std::array{&unit[0], &unit[1], &unit[2]}.data(),
                      &length);
      loops.floats(columns.data(), columns.data(), 1, position.data(), normal.data());
      const dvec3 expected = dvec3(2, -1, 2) / 3.0;
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(unit[static_cast<std::size_t>(k)], expected[k], 1e-15) << scale;
        EXPECT_NEAR(normal[static_cast<std::size_t>(k)], expected[k], 1e-7) << scale;
      }
      EXPECT_NEAR(length / scale, 3, 1e-14) << scale;
    }
  });
}

TEST(VectorLoops, RoundPositionsAndUnitNormalsToFloat) {
  const TestVectors vectors;
  const std::array positions = {vectors.columns()[2], vectors.columns()[0], vectors.columns()[1]};
  on_every_level([&](const VectorLoops& loops, std::size_t count) {
    std::vector<float> position(3 * count + 1, -5);
    std::vector<float> normal(3 * count + 1, -5);
    loops.floats(positions.data(), vectors.columns().data(), count, position.data(), normal.data());
    for (std::size_t i = 0; i < count; ++i) {
      const dvec3 expected[] = {{vectors.z, vectors.x[i], vectors.y[i]}, vectors.unit(i)};
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(position[3 * i + static_cast<std::size_t>(k)],
                  static_cast<float>(expected[0][k]));
        ASSERT_EQ(normal[3 * i + static_cast<std::size_t>(k)], static_cast<float>(expected[1][k]));
      }
    }
    EXPECT_EQ(position[3 * count], -5) << "wrote past the end";
    EXPECT_EQ(normal[3 * count], -5) << "wrote past the end";
  });
}

}  // namespace
}  // namespace saddle
