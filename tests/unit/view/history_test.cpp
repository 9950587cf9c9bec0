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

PastState step(const std::string& title, bool is_work = true) {
  return {titled(title), is_work};
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

TEST(History, KeepsWhatCanBeDoneAgainWhileSomeoneLooksAround) {
  History history;
  history.record(step("a"), "");
  history.undo(titled("b"));
  history.record(step("a", false), "drag");
  EXPECT_EQ(history.redo(titled("a, from elsewhere"))->state.scene.title, "b");
  EXPECT_EQ(history.undo(titled("b"))->state.scene.title, "a, from elsewhere");
  EXPECT_EQ(history.undo(titled("a, from elsewhere"))->state.scene.title, "a");
}

TEST(History, HasNoOtherVersionAfterALookFromElsewhere) {
  History history;
  history.record(step("a"), "");
  const std::size_t version = history.version();
  history.record(step("b", false), "drag");
  history.undo(titled("b, from elsewhere"));
  history.redo(titled("b"));
  EXPECT_EQ(history.version(), version);
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
