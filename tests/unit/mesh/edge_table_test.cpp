// Records of sides, on the vertices of a small root grid.
#include "mesh/tree/edge_table.h"

#include "mesh/grid/grid.h"
#include "mesh/model/mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "surface_from_text.h"

namespace saddle {
namespace {

/// A root grid of 3 x 2 cells between whole numbers.
Grid small_grid() {
  Grid grid;
  grid.u = {0, 1, 2, 3};
  grid.v = {0, 1, 2};
  grid.cells_u = 3;
  grid.cells_v = 2;
  return grid;
}

/// A vertex is numbered j * 4 + i.
class Edges : public testing::Test {
 protected:
  static Leaf root_leaf(std::uint32_t i, std::uint32_t j) {
    return {{i * kCellUnit, j * kCellUnit}, {(i + 1) * kCellUnit, (j + 1) * kCellUnit}};
  }

  Surface surface_ = height_field("u*v", {0, 3, 0, 2});
  Grid grid_ = small_grid();
  Effort effort_{surface_};
  RevisionClock revisions_{grid_};
  DyadicVertices vertices_{grid_, revisions_};
  EdgeTable edges_{grid_, vertices_, revisions_, effort_};
};

TEST_F(Edges, AreUnknownAtFirst) {
  EXPECT_FALSE(edges_.feature(0, 1));
  EXPECT_FALSE(edges_.is_searched(0, 1));
  EXPECT_FALSE(edges_.is_continuous(0, 1));
  EXPECT_FALSE(edges_.has_more(0, 1));
  EXPECT_FALSE(edges_.leads_to_pole(0, 1));
  EXPECT_FALSE(edges_.has_features());
  EXPECT_FALSE(edges_.has_poles());
}

TEST_F(Edges, CountTheVerticesOfSidesThatAreNotHalved) {
  edges_.set_feature(1, 5, EdgeFeature{FeatureKind::Jump, 1, 20, 21});
  edges_.set_feature(5, 6, EdgeFeature{FeatureKind::Jump, 5, 22, 23});
  EXPECT_EQ(edges_.vertex_count(), 4U);
  edges_.discount_feature(1, 5);
  EXPECT_EQ(edges_.vertex_count(), 2U);
  // A search that finds another feature later, or none, takes nothing away.
  edges_.set_feature(1, 5, EdgeFeature{FeatureKind::Jump, 1, 24, 25});
  EXPECT_EQ(edges_.vertex_count(), 2U);
  edges_.set_feature(1, 5, std::nullopt);
  edges_.discount_feature(1, 5);
  EXPECT_EQ(edges_.vertex_count(), 2U);
}

TEST_F(Edges, TellTheSameFromEitherEnd) {
  edges_.set_feature(5, 1, EdgeFeature{FeatureKind::Jump, 1, 20, 21});
  for (const auto& [a, b] : {Side{1, 5}, Side{5, 1}}) {
    ASSERT_TRUE(edges_.feature(a, b));
    EXPECT_EQ(edges_.feature(a, b)->beside(1), 20U);
    EXPECT_EQ(edges_.feature(a, b)->beside(5), 21U);
    EXPECT_TRUE(edges_.is_searched(a, b));
  }
}

TEST_F(Edges, KeepEachFactWhenAnotherIsFiled) {
  edges_.set_continuous(1, 2);
  EXPECT_TRUE(edges_.is_continuous(1, 2));
  EXPECT_FALSE(edges_.is_searched(1, 2));
  edges_.set_feature(1, 2, std::nullopt);
  EXPECT_TRUE(edges_.is_searched(1, 2));
  edges_.set_has_more(1, 2, dvec2(0.5, 0.25));
  edges_.set_leads_to_pole(1, 2, {dvec2(1.25, 0), dvec2(1.5, 0)});
  edges_.set_leads_to_pole(1, 2, {dvec2(9, 9), dvec2(9, 9)});
  EXPECT_TRUE(edges_.is_continuous(1, 2));
  EXPECT_TRUE(edges_.has_more(1, 2));
  EXPECT_TRUE(edges_.leads_to_pole(1, 2));
  EXPECT_EQ(edges_.pole_between(2, 1)[0], dvec2(1.25, 0));
  EXPECT_TRUE(edges_.has_poles());
  EXPECT_FALSE(edges_.feature(1, 2));
}

TEST_F(Edges, ListFeaturesInTheOrderInWhichTheyWereFound) {
  edges_.set_continuous(2, 3);
  edges_.set_feature(8, 9, std::nullopt);
  edges_.set_feature(2, 3, EdgeFeature{FeatureKind::Jump, 2, 20, 21});
  edges_.set_feature(0, 4, EdgeFeature{FeatureKind::Boundary, 0, 22, 22});
  edges_.set_feature(9, 8, EdgeFeature{FeatureKind::Crease, 8, 23, 24});
  EXPECT_EQ(edges_.sides_with_features(), (std::vector<Side>{{2, 3}, {0, 4}, {8, 9}}));
}

TEST_F(Edges, ListPolesThatWereFoundBeforeThoseThatWereCut) {
  Mesh mesh;
  mesh.uv = {dvec2(7, 0), dvec2(8, 0)};
  edges_.set_feature(0, 1, EdgeFeature{FeatureKind::Pole, 0, 0, 1});
  edges_.add_pole_beyond_face({dvec2(5, 0), dvec2(6, 0)});
  edges_.set_leads_to_pole(1, 2, {dvec2(1, 0), dvec2(2, 0)});
  const auto poles = edges_.poles(mesh);
  ASSERT_EQ(poles.size(), 3U);
  EXPECT_EQ(poles[0][0], dvec2(1, 0));
  EXPECT_EQ(poles[1][0], dvec2(5, 0));
  EXPECT_EQ(poles[2], (EdgeTable::PoleEnds{dvec2(7, 0), dvec2(8, 0)}));
}

TEST_F(Edges, CountTheVerticesOfFeatures) {
  edges_.set_feature(0, 1, EdgeFeature{FeatureKind::Boundary, 0, 20, 20});
  EXPECT_EQ(edges_.vertex_count(), 1U);
  edges_.set_feature(1, 2, EdgeFeature{FeatureKind::Jump, 1, 21, 22});
  EXPECT_EQ(edges_.vertex_count(), 3U);
  edges_.set_feature(0, 1, EdgeFeature{FeatureKind::Pole, 0, 20, 20});
  EXPECT_EQ(edges_.vertex_count(), 2U);
  edges_.discount_feature(2, 1);
  EXPECT_EQ(edges_.vertex_count(), 0U);
}

TEST_F(Edges, MarkTheRootCellsThatFeaturesCut) {
  const std::uint32_t before = revisions_.next();
  EXPECT_FALSE(revisions_.has_changed(root_leaf(0, 0), before));
  edges_.set_feature(1, 5, EdgeFeature{FeatureKind::Jump, 1, 20, 21});  // the line u = 1, v < 1
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 2; ++j) {
      const bool is_beside = i < 2 && j == 0;
      EXPECT_EQ(edges_.may_be_crossed(root_leaf(i, j)), is_beside) << i << ' ' << j;
      EXPECT_EQ(revisions_.has_changed(root_leaf(i, j), before), is_beside) << i << ' ' << j;
    }
  }
}

/// Three jumps on the side from vertex 0 to 1, with two strips between them, in parts of the side.
class PartsOfEdges : public Edges {
 protected:
  PartsOfEdges() {
    const auto add = [this](double at) { return vertices_.add_between({at * kCellUnit, 0}); };
    for (const double at : {0.1, 0.3, 0.3, 0.8}) strips_.push_back(add(at));
    jumps_.first_on_strips = strips_.front();
    jumps_.strips = 2;
    jumps_.beside_first = add(0.1);
    jumps_.beside_second = add(0.8);
  }
  std::uint32_t vertex_at(double part) {
    return vertices_.vertex({static_cast<std::uint32_t>(part * kCellUnit), 0});
  }
  void file(const EdgeFeature& jumps) {
    edges_.set_feature(0, 1, jumps);
    edges_.set_proved(0, 1);
  }

  std::vector<std::uint32_t> strips_;
  EdgeFeature jumps_{FeatureKind::Jump, 0, 0, 0};
};

TEST_F(PartsOfEdges, GetTheJumpsThatAreInThem) {
  file(jumps_);
  const std::uint32_t middle = vertex_at(0.5);
  edges_.pass_on(1, middle, 0);
  const auto near = edges_.feature(0, middle);
  const auto far = edges_.feature(middle, 1);
  ASSERT_TRUE(near && far);
  EXPECT_EQ(near->strips, 1);
  EXPECT_EQ(near->beside(0), jumps_.beside_first);
  EXPECT_EQ(near->on_strip(0, 0), (std::array{strips_[0], strips_[1]}));
  EXPECT_EQ(near->beside(middle), strips_[2]);
  EXPECT_EQ(far->strips, 0);
  EXPECT_EQ(far->beside(middle), strips_[3]);
  EXPECT_EQ(far->beside(1), jumps_.beside_second);
  // Both go on to their parts.
  const std::uint32_t quarter = vertex_at(0.25);
  edges_.pass_on(0, quarter, middle);
  EXPECT_EQ(edges_.feature(0, quarter)->beside(quarter), strips_[0]);
  EXPECT_EQ(edges_.feature(quarter, middle)->beside(quarter), strips_[1]);
  const std::uint32_t beyond = vertex_at(0.75);
  edges_.pass_on(middle, beyond, 1);
  EXPECT_TRUE(edges_.is_continuous(middle, beyond));
  EXPECT_TRUE(edges_.feature(beyond, 1));
}

TEST_F(PartsOfEdges, KeepStripsBetweenTheirJumps) {
  file(jumps_);
  const std::uint32_t fifth = vertex_at(0.1875);
  edges_.pass_on(0, fifth, 1);
  const auto far = edges_.feature(fifth, 1);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->strips, 1);
  EXPECT_EQ(far->beside(fifth), strips_[1]);
  EXPECT_EQ(far->on_strip(0, fifth), (std::array{strips_[2], strips_[3]}));
  EXPECT_EQ(far->on_strip(0, 1), (std::array{strips_[3], strips_[2]}));
  // All three are before a place near the end.
  const std::uint32_t last = vertex_at(0.875);
  edges_.set_feature(0, 1, jumps_);
  edges_.pass_on(0, last, 1);
  EXPECT_EQ(edges_.feature(0, last)->strips, 2);
  EXPECT_EQ(edges_.feature(0, last)->beside(last), jumps_.beside_second);
  EXPECT_TRUE(edges_.is_continuous(last, 1));
}

TEST_F(PartsOfEdges, AreSearchedIfAJumpIsBetweenThemOrNotAllAreKnown) {
  edges_.set_feature(0, 1, jumps_);
  const std::uint32_t middle = vertex_at(0.5);
  edges_.pass_on(0, middle, 1);
  EXPECT_FALSE(edges_.is_searched(0, middle));
  const std::uint32_t at_jump = vertices_.add_between({0.3 * kCellUnit, 0});
  edges_.set_proved(0, 1);
  edges_.pass_on(0, at_jump, 1);
  EXPECT_FALSE(edges_.is_searched(0, at_jump));
}

TEST_F(PartsOfEdges, AreContinuousIfTheWholeIs) {
  edges_.set_continuous(0, 1);
  edges_.set_proved(0, 1);
  const std::uint32_t middle = vertex_at(0.5);
  edges_.pass_on(0, middle, 1);
  EXPECT_TRUE(edges_.is_continuous(0, middle));
  EXPECT_TRUE(edges_.is_continuous(middle, 1));
  EXPECT_FALSE(edges_.is_searched(0, middle));  // for creases
}

TEST_F(Edges, PayForFeaturesAndPoles) {
  const std::size_t before = effort_.total();
  edges_.set_feature(0, 1, std::nullopt);
  edges_.set_continuous(0, 1);
  EXPECT_EQ(effort_.total(), before);
  edges_.set_feature(0, 1, EdgeFeature{FeatureKind::Jump, 0, 20, 21});
  const std::size_t one = effort_.total() - before;
  EXPECT_GT(one, 0U);
  edges_.set_leads_to_pole(1, 2, {});
  EXPECT_NEAR(static_cast<double>(effort_.total()), static_cast<double>(before + 2 * one), 1);
}

}  // namespace
}  // namespace saddle
