#include "scene/model/color.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace saddle {
namespace {

std::string round_trip(const std::string& text) {
  return format_color(parse_color("c", text));
}

Error color_error(const std::string& text) {
  try {
    parse_color("--front", text);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "'" << text << "' was read as a colour";
  return {Status::Done, ""};
}

TEST(Color, ReadsHexadecimalDigits) {
  const Color color = parse_color("--front", "#3366ff80");
  EXPECT_EQ(color.r, 0x33 / 255.0);
  EXPECT_EQ(color.g, 0x66 / 255.0);
  EXPECT_EQ(color.b, 1);
  EXPECT_EQ(color.a, 0x80 / 255.0);
}

TEST(Color, DoublesTheDigitsOfTheShortForm) {
  EXPECT_EQ(round_trip("#1aF"), "#11aaff");
}

TEST(Color, KnowsCssNamesInAnyCase) {
  EXPECT_EQ(round_trip("SaddleBrown"), "#8b4513");
  EXPECT_EQ(round_trip("rebeccapurple"), "#663399");
  EXPECT_EQ(round_trip("aliceblue"), "#f0f8ff");    // the first of the table
  EXPECT_EQ(round_trip("yellowgreen"), "#9acd32");  // the last
}

TEST(Color, TakesCssAndNotX11WhereTheyDisagree) {
  EXPECT_EQ(round_trip("gray"), "#808080");
  EXPECT_EQ(round_trip("grey"), "#808080");
  EXPECT_EQ(round_trip("green"), "#008000");
  EXPECT_EQ(round_trip("maroon"), "#800000");
  EXPECT_EQ(round_trip("purple"), "#800080");
}

TEST(Color, TransparentIsBlackWithoutOpacity) {
  EXPECT_EQ(round_trip("transparent"), "#00000000");
}

TEST(Color, WritesOpacityOnlyWhereThereIsSome) {
  EXPECT_EQ(format_color({1, 0.5, 0, 1}), "#ff8000");
  EXPECT_EQ(format_color({1, 0.5, 0, 0.5}), "#ff800080");
}

TEST(Color, WritesWhatItReadsBackForEveryByte) {
  for (int byte = 0; byte < 256; ++byte) {
    const Color color{byte / 255.0, 0, 1, byte / 255.0};
    const Color back = parse_color("c", format_color(color));
    EXPECT_EQ(back.r, color.r) << byte;
    EXPECT_EQ(back.a, color.a) << byte;
  }
}

TEST(Color, ClampsWhatIsOutsideOfTheScreensRange) {
  EXPECT_EQ(format_color({-1, 2, 0.25, 7}), "#00ff40");
}

TEST(Color, PointsAtTheDigitThatIsNone) {
  const Error error = color_error("#12g456");
  EXPECT_EQ(error.status(), Status::Input);
  EXPECT_EQ(error.place().name, "--front");
  EXPECT_EQ(error.place().span.begin, 3U);
  EXPECT_EQ(error.place().span.end, 4U);
}

TEST(Color, RefusesOtherNumbersOfDigits) {
  for (const char* text : {"#", "#1", "#12", "#1234", "#12345", "#1234567", "#123456789"}) {
    EXPECT_EQ(color_error(text).status(), Status::Input) << text;
  }
}

TEST(Color, NamesTheNearestColour) {
  EXPECT_NE(color_error("saddlebrwon").hint().find("did you mean 'saddlebrown'?"),
            std::string::npos);
  EXPECT_EQ(color_error("").status(), Status::Input);
}

}  // namespace
}  // namespace saddle
