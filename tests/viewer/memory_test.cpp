// The memory that a window takes of the machine.
#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "sanitized.h"
#include "viewer/workplace.h"

namespace saddle {
namespace {

/// Pages of memory that the process has.
std::size_t pages() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident;
}

TEST_F(Workplace, GivesFreeMemoryBackWhenItRests) {
  if (kIsSanitized) GTEST_SKIP() << "the heap is the sanitizer's";
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(until(viewer, [&] { return viewer.is_tidy(); }));
  constexpr std::size_t kBlock = 8192;
  constexpr std::size_t kBlocks = 8192;
  std::vector<std::unique_ptr<char[]>> blocks;
  for (std::size_t i = 0; i < kBlocks; ++i) {
    blocks.push_back(std::make_unique<char[]>(kBlock));
  }
  blocks.erase(blocks.begin(), blocks.end() - 1);  // the heap does not end where they were
  const std::size_t before = pages();
  key(viewer, "g");
  EXPECT_FALSE(viewer.is_tidy()) << "it goes on";
  ASSERT_TRUE(until(viewer, [&] { return viewer.is_tidy(); }));
  EXPECT_LT(pages(), before - kBlocks) << "half of them at least";
}

}  // namespace
}  // namespace saddle
