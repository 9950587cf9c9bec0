// Vertex numbers by dyadic points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tree/leaf.h"

namespace saddle {

struct Grid;

/// A map from places to vertices, for places that are not on the root grid. Each root cell has a
/// hash table of its own, with open addressing. Look-ups go cell by cell, so that successive ones
/// stay in the cache. Source: D. E. Knuth, "The Art of Computer Programming" 3, section 6.4.
class PlaceMap {
 public:
  explicit PlaceMap(const Grid& grid);
  /// The number stored for a place, or nullptr; valid until the next find_or_insert().
  const std::uint32_t* find(DyadicPoint place) const;
  /// The number stored for a place; stores this one if there is none.
  std::uint32_t find_or_insert(DyadicPoint place, std::uint32_t number);
  /// Removes a place that is stored.
  void erase(DyadicPoint place);

 private:
  struct Slot {
    std::uint32_t key = kEmpty;  ///< the place within its cell
    std::uint32_t number = 0;
  };
  /// Slots of a cell, 2^(32 - shift) from `begin` on, or none. No mesh has 2^26 vertices in a cell.
  struct Table {
    std::uint32_t begin = 0;
    std::uint32_t count : 26 = 0;
    std::uint32_t shift : 6 = 32;
  };
  /// The key of the corner of a root cell, which is on the root grid.
  static constexpr std::uint32_t kEmpty = 0;

  std::size_t table_of(DyadicPoint place) const {
    return place.v / kCellUnit * pitch_ + place.u / kCellUnit;
  }
  static std::uint32_t key_of(DyadicPoint place) {
    return (place.u % kCellUnit) * kCellUnit + place.v % kCellUnit;
  }
  static std::uint32_t home_of(const Table& table, std::uint32_t key);
  std::uint32_t slot_of(const Table& table, std::uint32_t key) const;
  void resize(Table& table, std::uint32_t shift);
  std::uint32_t take_slots(std::uint32_t shift);
  void give_back_slots(const Table& table) { free_[table.shift].push_back(table.begin); }

  std::size_t pitch_;
  std::vector<Table> tables_;  // of root cells, and of the lines at the far ends
  std::vector<Slot> slots_;    // of all tables
  std::array<std::vector<std::uint32_t>, 32> free_;  // first slots, by the shift of their table
};

}  // namespace saddle
