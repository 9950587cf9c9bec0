// Many places, stored and removed, against std::map.
#include "mesh/tree/place_map.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "base/random.h"
#include "mesh/grid/grid.h"

namespace saddle {
namespace {

/// A place in a grid of 2 x 2 cells, one of 400, and not on the grid.
DyadicPoint random_place(std::uint64_t number) {
  const auto at = [](double random) {
    const auto step = static_cast<std::uint32_t>(20 * random);
    return step * (kCellUnit / 10) + 1;
  };
  return {at(random_unit(2 * number)), at(random_unit(2 * number + 1))};
}

TEST(PlaceMap, ForgetsWhatIsErased) {
  Grid grid;
  grid.u = grid.v = {0, 1, 2};
  grid.cells_u = grid.cells_v = 2;
  PlaceMap places(grid);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  for (std::uint32_t i = 0; i < 40000; ++i) {
    const DyadicPoint place = random_place(i);
    const auto key = std::pair(place.u, place.v);
    const auto found = known.find(key);
    const std::uint32_t* const number = places.find(place);
    ASSERT_EQ(number != nullptr, found != known.end());
    if (number != nullptr) {
      ASSERT_EQ(*number, found->second);
    }
    // Tables grow for 2000 steps, then shrink, and so on.
    const bool is_growing = i / 2000 % 2 == 0;
    if (is_growing || number == nullptr) {
      const auto [at, is_new] = known.try_emplace(key, i);
      ASSERT_EQ(places.find_or_insert(place, i), at->second);
    } else {
      places.erase(place);
      known.erase(key);
    }
    if (!is_growing && number == nullptr) {
      places.erase(place);
      known.erase(key);
    }
  }
  EXPECT_FALSE(known.empty());
}

}  // namespace
}  // namespace saddle
