#include "base/base64.h"

#include <gtest/gtest.h>

#include <string>

namespace saddle {
namespace {

// Source: RFC 4648, section 10.
TEST(Base64, HasTheVectorsOfItsStandard) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
}

TEST(Base64, GivesAllBytesBack) {
  std::string bytes;
  for (int length = 0; length < 300; ++length) {
    EXPECT_EQ(bytes_of_base64(base64_of(bytes)), bytes);
    bytes += static_cast<char>(length * 37);
  }
}

TEST(Base64, RefusesOtherText) {
  for (const char* text : {"Z", "Zg", "Zg=", "Z===", "=Zg=", "Zg==Zg==", "Zg\n=", "Zm9*"}) {
    EXPECT_FALSE(bytes_of_base64(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace saddle
