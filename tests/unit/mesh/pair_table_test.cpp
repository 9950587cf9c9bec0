// Many pairs, against std::map.
#include "mesh/model/pair_table.h"

#include <gtest/gtest.h>

#include <map>

#include "base/random.h"

namespace saddle {
namespace {

TEST(PairTable, KeepsWhatWasFiledFirst) {
  PairTable table;
  std::map<Pair, std::uint32_t> known;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const auto a = static_cast<std::uint32_t>(200 * random_unit(2 * i));
    const auto b = 200 + static_cast<std::uint32_t>(200 * random_unit(2 * i + 1));
    EXPECT_EQ(table.contains(pair_of(a, b)), known.contains(pair_of(b, a)));
    const auto [value, is_new] = table.insert(pair_of(b, a), i);
    const auto [place, is_first] = known.try_emplace(pair_of(a, b), i);
    EXPECT_EQ(is_new, is_first);
    EXPECT_EQ(value, place->second);
  }
  EXPECT_EQ(table.size(), known.size());
  for (const auto& [pair, value] : known) EXPECT_EQ(table.find(pair), value);
  table.clear();
  EXPECT_EQ(table.size(), 0U);
  EXPECT_FALSE(table.contains(known.begin()->first));
  EXPECT_TRUE(table.insert(known.begin()->first, 7).second);
}

}  // namespace
}  // namespace saddle
