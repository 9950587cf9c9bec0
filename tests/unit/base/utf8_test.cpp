#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace saddle {
namespace {

std::vector<char32_t> decode_all(std::string_view text) {
  std::vector<char32_t> codes;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = decode_utf8(text, at);
    codes.push_back(c.code);
    at += c.bytes;
  }
  return codes;
}

using Codes = std::vector<char32_t>;
constexpr char32_t kBad = kReplacementCharacter;

TEST(Utf8, DecodesOneToFourBytes) {
  EXPECT_EQ(decode_all("a\xCF\x80\xE2\x88\x92\xF0\x9F\x98\x80"),
            (Codes{U'a', 0x3C0, 0x2212, 0x1F600}));
}

TEST(Utf8, DecodesTheFirstAndTheLastCodeOfEachLength) {
  EXPECT_EQ(decode_all("\x7F"), (Codes{0x7F}));
  EXPECT_EQ(decode_all("\xC2\x80\xDF\xBF"), (Codes{0x80, 0x7FF}));
  EXPECT_EQ(decode_all("\xE0\xA0\x80\xEF\xBF\xBF"), (Codes{0x800, 0xFFFF}));
  EXPECT_EQ(decode_all("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF"), (Codes{0x10000, 0x10FFFF}));
}

TEST(Utf8, ReplacesEachByteThatBeginsNoCharacter) {
  EXPECT_EQ(decode_all("\x80z"), (Codes{kBad, U'z'}));                         // continuation alone
  EXPECT_EQ(decode_all("\xCFz"), (Codes{kBad, U'z'}));                         // not continued
  EXPECT_EQ(decode_all("\xE2\x88"), (Codes{kBad, kBad}));                      // cut off
  EXPECT_EQ(decode_all("\xC0\xAF"), (Codes{kBad, kBad}));                      // overlong
  EXPECT_EQ(decode_all("\xE0\x80\xAF"), (Codes{kBad, kBad, kBad}));            // overlong
  EXPECT_EQ(decode_all("\xED\xA0\x80"), (Codes{kBad, kBad, kBad}));            // surrogate
  EXPECT_EQ(decode_all("\xF4\x90\x80\x80"), (Codes{kBad, kBad, kBad, kBad}));  // past the end
  EXPECT_EQ(decode_all("\xFF"), (Codes{kBad}));
}

TEST(Utf8, KnowsTheColumnsOfCharacters) {
  EXPECT_EQ(display_width(U'a'), 1);
  EXPECT_EQ(display_width(0x3C0), 1);    // pi
  EXPECT_EQ(display_width(0x2212), 1);   // minus
  EXPECT_EQ(display_width(0x301), 0);    // combining acute accent
  EXPECT_EQ(display_width(0x36F), 0);    // last of its range
  EXPECT_EQ(display_width(0x370), 1);    // one past it
  EXPECT_EQ(display_width(0x6F22), 2);   // a Chinese character
  EXPECT_EQ(display_width(0x1F600), 2);  // emoji
  EXPECT_EQ(display_width(0x10FFFF), 1);
}

}  // namespace
}  // namespace saddle
