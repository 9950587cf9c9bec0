#include "view/model/history.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

Scene titled(const std::string& title) {
  Scene scene;
  scene.title = title;
  return scene;
}

TEST(History, GoesBackAndForth) {
  History history;
  EXPECT_FALSE(history.undo(titled("now")));
  history.record(titled("a"), "");
  history.record(titled("b"), "");
  EXPECT_EQ(history.undo(titled("c"))->title, "b");
  EXPECT_EQ(history.undo(titled("b"))->title, "a");
  EXPECT_FALSE(history.undo(titled("a")));
  EXPECT_EQ(history.redo(titled("a"))->title, "b");
  EXPECT_EQ(history.redo(titled("b"))->title, "c");
  EXPECT_FALSE(history.redo(titled("c")));
}

TEST(History, TakesLettersTypedInARowAsOneEdit) {
  History history;
  history.record(titled("s"), "x");
  history.record(titled("si"), "x");
  history.record(titled("sin"), "x");
  EXPECT_EQ(history.undo(titled("sinh"))->title, "s");
  EXPECT_FALSE(history.undo(titled("s")));
}

TEST(History, KeepsEditsApartThatSomethingCameBetween) {
  History history;
  history.record(titled("a"), "x");
  history.end_edit();
  history.record(titled("b"), "x");
  EXPECT_EQ(history.undo(titled("c"))->title, "b");
  EXPECT_EQ(history.undo(titled("b"))->title, "a");
}

TEST(History, ForgetsWhatWasUndoneAtTheNextEdit) {
  History history;
  history.record(titled("a"), "");
  history.undo(titled("b"));
  history.record(titled("a"), "");
  EXPECT_FALSE(history.redo(titled("c")));
}

}  // namespace
}  // namespace saddle
