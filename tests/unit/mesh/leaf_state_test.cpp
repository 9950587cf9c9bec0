// The transitions of a leaf's state.
#include "mesh/tree/leaf_state.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace saddle {
namespace {

static_assert(std::is_trivially_copyable_v<LeafState> && sizeof(LeafState) == 1);

/// A state with each cut.
LeafState cut_by(LeafCut cut) {
  LeafState state;
  if (cut == LeafCut::Boundary || cut == LeafCut::BoundaryAndFeature) state.cross_boundary();
  if (cut == LeafCut::Feature || cut == LeafCut::BoundaryAndFeature) {
    state.set_features(true, false);
  }
  return state;
}

TEST(LeafState, BeginsWholeAndActive) {
  const LeafState state;
  EXPECT_TRUE(state.is_whole());
  EXPECT_FALSE(state.is_on_boundary());
  EXPECT_FALSE(state.is_cut_by_feature());
  EXPECT_FALSE(state.leads_to_pole());
  EXPECT_FALSE(state.is_left_out());
  EXPECT_EQ(state.progress(), LeafProgress::Active);
  EXPECT_TRUE(state.may_be_halved());
}

TEST(LeafState, KeepsBoundaryAndFeatureApart) {
  for (const bool on_boundary : {false, true}) {
    for (const bool has_feature : {false, true}) {
      const LeafCut cut = on_boundary
                              ? (has_feature ? LeafCut::BoundaryAndFeature : LeafCut::Boundary)
                              : (has_feature ? LeafCut::Feature : LeafCut::Nothing);
      LeafState state = cut_by(cut);
      EXPECT_EQ(state.cut(), cut);
      EXPECT_EQ(state.is_on_boundary(), on_boundary);
      EXPECT_EQ(state.is_cut_by_feature(), has_feature);
      EXPECT_EQ(state.is_whole(), !on_boundary && !has_feature);
      state.forget_boundary();
      EXPECT_FALSE(state.is_on_boundary());
      EXPECT_EQ(state.is_cut_by_feature(), has_feature);
      state = cut_by(cut);
      state.set_features(false, false);
      EXPECT_EQ(state.is_on_boundary(), on_boundary);
      EXPECT_FALSE(state.is_cut_by_feature());
    }
  }
}

TEST(LeafState, TakesAPoleForTheBoundary) {
  LeafState state;
  state.set_features(true, true);
  EXPECT_TRUE(state.leads_to_pole());
  state.take_pole_for_boundary();
  EXPECT_EQ(state.cut(), LeafCut::Boundary);
  EXPECT_FALSE(state.leads_to_pole());
}

TEST(LeafState, KeepsAJumpThatEndsAtTheBoundary) {
  LeafState state = cut_by(LeafCut::Feature);
  state.take_pole_for_boundary();
  EXPECT_EQ(state.cut(), LeafCut::BoundaryAndFeature);
}

TEST(LeafState, KeepsAnUncutPoleBesideTheBoundary) {
  LeafState state;
  state.set_features(false, true);
  state.cross_boundary();
  EXPECT_EQ(state.cut(), LeafCut::Boundary);
  EXPECT_TRUE(state.leads_to_pole());
}

TEST(LeafState, StopsForGood) {
  LeafState frozen = cut_by(LeafCut::Boundary);
  frozen.freeze();
  EXPECT_EQ(frozen.progress(), LeafProgress::Frozen);
  EXPECT_FALSE(frozen.may_be_halved());
  EXPECT_FALSE(frozen.oscillates());
  EXPECT_EQ(frozen.cut(), LeafCut::Boundary);
}

TEST(LeafState, KeepsAnOscillationAsTheReason) {
  LeafState state;
  state.stop_at_oscillation();
  state.freeze();
  EXPECT_TRUE(state.oscillates());
  EXPECT_FALSE(state.may_be_halved());
}

TEST(LeafState, KeepsTheRestWhenLeftOut) {
  LeafState state = cut_by(LeafCut::Feature);
  state.stop_at_oscillation();
  state.leave_out();
  EXPECT_TRUE(state.is_left_out());
  EXPECT_TRUE(state.oscillates());
  EXPECT_EQ(state.cut(), LeafCut::Feature);
}

}  // namespace
}  // namespace saddle
