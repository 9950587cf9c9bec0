#include "base/deflate.h"

#include <gtest/gtest.h>

#include <zlib.h>

namespace saddle {
namespace {

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
