// The heap in huge pages.
#include "base/heap.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace saddle {
namespace {

/// The flags that the system has for the mapping with this address, of proc(5)'s VmFlags.
std::string flags_of(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  bool inside = false;
  for (std::string line; std::getline(maps, line);) {
    std::istringstream text(line);
    std::uintptr_t begin = 0;
    std::uintptr_t end = 0;
    char dash = 0;
    if (text >> std::hex >> begin >> dash >> end && dash == '-') {
      inside = begin <= wanted && wanted < end;
    } else if (inside && line.starts_with("VmFlags:")) {
      return line + " ";
    }
  }
  return "";
}

TEST(Heap, GivesLargeBlocksFromHugePages) {
  if (!use_huge_pages()) GTEST_SKIP() << "this heap is not glibc's, or there are no huge pages";
  constexpr std::size_t kFramebuffer = std::size_t{1600} * 1200 * 4;
  const auto block = std::make_unique<char[]>(kFramebuffer);
  EXPECT_NE(flags_of(block.get() + kFramebuffer / 2).find(" hg "), std::string::npos)
      << flags_of(block.get());
}

}  // namespace
}  // namespace saddle
