// What a progress bar tells of nested work.
#include "base/activity.h"

#include <gtest/gtest.h>

#include <thread>

namespace saddle {
namespace {

TEST(Activity, NestsItsNamesAndItsShares) {
  EXPECT_EQ(current_activity().what, "");
  Activity frames("frame", 4);
  frames.advance();
  EXPECT_EQ(current_activity().what, "frame 2 of 4");
  EXPECT_DOUBLE_EQ(current_activity().share, 0.25);
  {
    Activity meshing("meshing", 2);
    meshing.advance();
    EXPECT_EQ(current_activity().what, "frame 2 of 4, meshing 2 of 2");
    tell_share(0.5);
    EXPECT_DOUBLE_EQ(current_activity().share, 0.25 + 0.25 * 0.75);
  }
  EXPECT_DOUBLE_EQ(current_activity().share, 0.25);
}

TEST(Activity, WithoutANameOnlyCounts) {
  Activity surfaces("", 2);
  const Activity drawing("drawing");
  surfaces.advance();
  EXPECT_EQ(current_activity().what, "drawing");
  EXPECT_DOUBLE_EQ(current_activity().share, 0.5);
}

/// Work that tells its own share does not go back where work within it begins anew.
TEST(Activity, KeepsTheShareThatItTells) {
  Activity measuring("measuring");
  measuring.set_share(0.5);
  const Activity method("");
  EXPECT_DOUBLE_EQ(current_activity().share, 0.5);
  tell_share(0.9);
  EXPECT_DOUBLE_EQ(current_activity().share, 0.5);
  measuring.set_share(0.6);
  EXPECT_DOUBLE_EQ(current_activity().share, 0.6);
}

TEST(Activity, OfOtherThreadsIsNotTold) {
  const Activity meshing("meshing");
  std::thread([] {
    const Activity other("proving");
    tell_share(0.5);
    EXPECT_EQ(current_activity().what, "meshing");
  }).join();
  EXPECT_DOUBLE_EQ(current_activity().share, 0);
}

}  // namespace
}  // namespace saddle
