#include "view/model/history.h"

#include <gtest/gtest.h>

#include <utility>

namespace saddle {
namespace {

State titled(const std::string& title) {
  State state;
  state.scene.title = title;
  return state;
}

PastState step(const std::string& title, bool has_camera = false) {
  return {titled(title), has_camera};
}

TEST(History, GoesBackAndForth) {
  History history;
  EXPECT_FALSE(history.undo(titled("now")));
  history.record(step("a"), "");
  history.record(step("b"), "");
  EXPECT_EQ(history.undo(titled("c"))->state.scene.title, "b");
  EXPECT_EQ(history.undo(titled("b"))->state.scene.title, "a");
  EXPECT_FALSE(history.undo(titled("a")));
  EXPECT_EQ(history.redo(titled("a"))->state.scene.title, "b");
  EXPECT_EQ(history.redo(titled("b"))->state.scene.title, "c");
  EXPECT_FALSE(history.redo(titled("c")));
}

TEST(History, TakesLettersTypedInARowAsOneEdit) {
  History history;
  history.record(step("s"), "x");
  history.record(step("si"), "x");
  history.record(step("sin"), "x");
  EXPECT_EQ(history.undo(titled("sinh"))->state.scene.title, "s");
  EXPECT_FALSE(history.undo(titled("s")));
}

TEST(History, KeepsEditsApartThatSomethingCameBetween) {
  History history;
  history.record(step("a"), "x");
  history.end_edit();
  history.record(step("b"), "x");
  EXPECT_EQ(history.undo(titled("c"))->state.scene.title, "b");
  EXPECT_EQ(history.undo(titled("b"))->state.scene.title, "a");
}

TEST(History, ForgetsWhatWasUndoneAtTheNextEdit) {
  History history;
  history.record(step("a"), "");
  history.undo(titled("b"));
  history.record(step("a"), "");
  EXPECT_FALSE(history.redo(titled("c")));
}

TEST(History, TellsWhetherACameraBelongsToAStepBothWays) {
  History history;
  history.record(step("a"), "");
  history.record(step("b", true), "");
  EXPECT_TRUE(history.undo(titled("c"))->has_camera);
  EXPECT_FALSE(history.undo(titled("b"))->has_camera);
  EXPECT_FALSE(history.redo(titled("a"))->has_camera);
  EXPECT_TRUE(history.redo(titled("b"))->has_camera);
}

TEST(History, HasAnotherVersionAfterEachChange) {
  History history;
  std::size_t last = history.version();
  const auto is_another = [&] { return std::exchange(last, history.version()) != last; };
  history.record(step("a"), "x");
  EXPECT_TRUE(is_another());
  history.record(step("b"), "x");
  EXPECT_TRUE(is_another()) << "also within one step";
  history.undo(titled("c"));
  EXPECT_TRUE(is_another());
  history.redo(titled("a"));
  EXPECT_TRUE(is_another());
  history.redo(titled("c"));
  EXPECT_FALSE(is_another());
}

}  // namespace
}  // namespace saddle
