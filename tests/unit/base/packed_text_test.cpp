#include "base/packed_text.h"

#include <gtest/gtest.h>

#include <zlib.h>

namespace saddle {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(ZlibStream, IsInflatedToTheSameBytes) {
  std::string bytes(10000, 'x');
  bytes += "\0 and\xff another";
  const std::string packed = zlib_stream(bytes);
  EXPECT_LT(packed.size(), 200U);
  std::string again(bytes.size(), '\0');
  uLongf size = again.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(again.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  EXPECT_EQ(size, bytes.size());
  EXPECT_EQ(again, bytes);
}

}  // namespace
}  // namespace saddle
