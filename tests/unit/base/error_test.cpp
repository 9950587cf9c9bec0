#include "base/error.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace saddle {
namespace {

std::string formatted(const std::string& name, const std::string& text, Span span) {
  return format_error(Error(Status::Input, "wrong", {name, text, span}));
}

std::string times(int count, const std::string& text) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(Error, CarriesItsParts) {
  const Error error(Status::Nothing, "message", {"y", "text", {1, 3}}, "hint");
  EXPECT_STREQ(error.what(), "message");
  EXPECT_EQ(error.status(), Status::Nothing);
  EXPECT_EQ(error.place().text, "text");
  EXPECT_EQ(error.hint(), "hint");
}

TEST(Error, TakesOneMoreLineBelowItsHint) {
  const Error bare(Status::Machine, "message", {"y", "text", {1, 3}});
  const Error once = with_hint_line(bare, "first");
  EXPECT_EQ(once.hint(), "first");
  EXPECT_EQ(with_hint_line(once, "second").hint(), "first\nsecond");
  EXPECT_STREQ(once.what(), "message");
  EXPECT_EQ(once.status(), Status::Machine);
  EXPECT_EQ(once.place().text, "text");
}

TEST(FormatError, ShowsNameMessageTextCaretAndHint) {
  const Error error(Status::Input, "unknown name 'foo'", {"y", "cos(u)*foo(v)", {7, 10}},
                    "did you mean 'floor'?");
  EXPECT_EQ(format_error(error),
            "saddle: y: unknown name 'foo'\n"
            "  y = cos(u)*foo(v)\n"
            "             ^~~\n"
            "did you mean 'floor'?\n");
}

TEST(FormatError, ShowsAnOptionWithASpaceInPlaceOfTheEqualsSign) {
  EXPECT_EQ(formatted("--size", "800y600", {3, 4}),
            "saddle: --size: wrong\n"
            "  --size 800y600\n"
            "            ^\n");
}

TEST(FormatError, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(format_error(Error(Status::Machine, "out of memory")), "saddle: out of memory\n");
  EXPECT_EQ(formatted("u", "", {}), "saddle: u: wrong\n");
  EXPECT_EQ(formatted("", "u v", {2, 3}), "saddle: wrong\n  u v\n    ^\n");
}

TEST(FormatError, DoesNotIndentHintsOfSeveralLines) {
  const Error error(Status::Input, "wrong", {}, {"one", "two"});
  EXPECT_EQ(format_error(error), "saddle: wrong\none\ntwo\n");
}

TEST(FormatError, ShowsNoEmptyLine) {
  const Error error(Status::Input, "no surface", {"", "\n", {0, 0}, "a.toml:1:1"}, "write one");
  EXPECT_EQ(format_error(error), "saddle: a.toml:1:1: no surface\nwrite one\n");
}

TEST(FormatError, MarksAtLeastOneColumn) {
  EXPECT_EQ(formatted("z", "1+2", {1, 1}), "saddle: z: wrong\n  z = 1+2\n       ^\n");
  EXPECT_EQ(formatted("z", "1+", {2, 2}), "saddle: z: wrong\n  z = 1+\n        ^\n");
  EXPECT_EQ(formatted("z", "1+", {90, 95}), "saddle: z: wrong\n  z = 1+\n        ^\n");
  EXPECT_EQ(formatted("z", "1+2", {1, 99}), "saddle: z: wrong\n  z = 1+2\n       ^~\n");
}

TEST(FormatError, CountsCharactersAndNotBytes) {
  // Two bytes each for the name and the first character, three for the minus sign.
  EXPECT_EQ(formatted("\u03C6", "\u03C0\u2212foo", {5, 8}),
            "saddle: \u03C6: wrong\n"
            "  \u03C6 = \u03C0\u2212foo\n"
            "        ^~~\n");
}

TEST(FormatError, CountsTheColumnsOfWideAndCombiningCharacters) {
  // A wide character takes two columns, e with a combining accent one.
  EXPECT_EQ(formatted("z", "\u6F22e\u0301+q", {7, 8}),
            "saddle: z: wrong\n  z = \u6F22e\u0301+q\n          ^\n");
  EXPECT_EQ(formatted("z", "1\u6F22", {1, 4}), "saddle: z: wrong\n  z = 1\u6F22\n       ^~\n");
}

TEST(FormatError, MarksTheWholeCharacterOfASpanInsideIt) {
  EXPECT_EQ(formatted("z", "a\u03C0b", {2, 3}), "saddle: z: wrong\n  z = a\u03C0b\n       ^\n");
}

TEST(FormatError, ShowsTabsAsOneSpace) {
  EXPECT_EQ(formatted("z", "1\t+q", {3, 4}), "saddle: z: wrong\n  z = 1 +q\n         ^\n");
}

TEST(FormatError, ShowsOnlyTheLineOfTheSpan) {
  const std::string text = "one\r\ntwo+q\r\nthree";
  EXPECT_EQ(formatted("z", text, {9, 10}), "saddle: z: wrong\n  z = two+q\n          ^\n");
  EXPECT_EQ(formatted("z", text, {0, 3}), "saddle: z: wrong\n  z = one\n      ^~~\n");
  EXPECT_EQ(formatted("z", text, {13, 17}), "saddle: z: wrong\n  z = three\n       ^~~~\n");
}

TEST(FormatError, EndsTheCaretsWithTheLine) {
  EXPECT_EQ(formatted("z", "one\ntwo", {1, 6}), "saddle: z: wrong\n  z = one\n       ^~\n");
}

TEST(FormatError, NeverSendsControlCharactersToATerminal) {
  const std::string evil = "\x1B[2J\x07\u009B\u202E";
  const std::string text = format_error(Error(Status::Input, evil, {evil, evil, {0, 1}}, evil));
  for (const char c : text) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
  EXPECT_EQ(text.find("\u009B"), std::string::npos);
  EXPECT_EQ(text.find("\u202E"), std::string::npos);
}

TEST(FormatError, ShowsBytesThatAreNotUtf8AsQuestionMarks) {
  EXPECT_EQ(formatted("z", "\xFF\xC3+q", {3, 4}), "saddle: z: wrong\n  z = ?\?+q\n         ^\n");
}

// The line `  z = ` leaves 100 - 6 columns; both cuts take six of them, and 88 are shown.
TEST(FormatError, CutsALongLineAroundThePlace) {
  const std::string text = times(200, "a") + "!" + times(200, "b");
  EXPECT_EQ(formatted("z", text, {200, 201}), "saddle: z: wrong\n  z = ..." + times(43, "a") + "!" +
                                                  times(44, "b") + "...\n" +
                                                  std::string(6 + 3 + 43, ' ') + "^\n");
}

TEST(FormatError, CutsALongLineOnlyWhereItIsCutOff) {
  const std::string text = times(200, "a") + "!";
  EXPECT_EQ(formatted("z", text, {200, 201}), "saddle: z: wrong\n  z = ..." + times(87, "a") +
                                                  "!\n" + std::string(6 + 3 + 87, ' ') + "^\n");
  EXPECT_EQ(formatted("z", text, {201, 201}), "saddle: z: wrong\n  z = ..." + times(87, "a") +
                                                  "!\n" + std::string(6 + 3 + 88, ' ') + "^\n");
  EXPECT_EQ(formatted("z", text, {0, 2}),
            "saddle: z: wrong\n  z = " + times(88, "a") + "...\n      ^~\n");
}

TEST(FormatError, CutsASpanThatIsLongerThanALine) {
  const std::string text = times(300, "a");
  EXPECT_EQ(formatted("z", text, {100, 250}), "saddle: z: wrong\n  z = ..." + times(88, "a") +
                                                  "...\n         ^" + times(87, "~") + "\n");
}

TEST(FormatError, LeavesALineThatFitsWhole) {
  const std::string text = times(94, "a");
  EXPECT_EQ(formatted("z", text, {0, 1}), "saddle: z: wrong\n  z = " + text + "\n      ^\n");
}

TEST(FormatError, SurvivesEverySpanOfATextThatIsPartlyBroken) {
  const std::string text = "a\n\xE2\x88\u0301\t\u6F22\n" + times(120, "\xC3");
  for (std::size_t begin = 0; begin <= text.size() + 2; ++begin) {
    for (std::size_t end = 0; end <= text.size() + 2; ++end) {
      EXPECT_NE(formatted("z", text, {begin, end}).find('^'), std::string::npos);
    }
  }
}

TEST(FormatError, NamesCannotBeginLines) {
  const Error error(Status::Machine, "no a\nsaddle: b", {"c\nd", "", {}, "e\nf"}, "mkdir g\nh");
  EXPECT_EQ(format_error(error), "saddle: e?f: c?d: no a?saddle: b\nmkdir g?h\n");
}

TEST(CaughtError, IsTheErrorOrOneOfTheMachine) {
  const auto caught = [](const auto& thrown) {
    try {
      throw thrown;
    } catch (...) {
      return caught_error();
    }
  };
  EXPECT_EQ(caught(Error(Status::Nothing, "empty")).status(), Status::Nothing);
  EXPECT_STREQ(caught(std::bad_alloc()).what(), "out of memory");
  EXPECT_STREQ(caught(std::runtime_error("odd")).what(), "odd");
  EXPECT_EQ(caught(std::runtime_error("odd")).status(), Status::Machine);
  const auto again = std::make_error_code(std::errc::resource_unavailable_try_again);
  EXPECT_STREQ(caught(std::system_error(again)).what(), "the system starts no more threads");
}

}  // namespace
}  // namespace saddle
