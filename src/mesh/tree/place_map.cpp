#include "mesh/tree/place_map.h"
#include "mesh/grid/grid.h"

namespace saddle {

/// The slot of a key, or the free slot where it would go: linear probing. Source: D. E. Knuth, "The
/// Art of Computer Programming" 3, section 6.4: multiplicative hashing.
std::uint32_t PlaceMap::slot_of(const Table& table, std::uint32_t key) const {
  const std::uint32_t mask = ~std::uint32_t{0} >> table.shift;
  std::uint32_t slot = (key * 0x9e3779b9U) >> table.shift;  // 2^32 / golden ratio
  while (slots_[table.begin + slot].key != kEmpty && slots_[table.begin + slot].key != key) {
    slot = (slot + 1) & mask;
  }
  return table.begin + slot;
}

PlaceMap::PlaceMap(const Grid& grid)
    : pitch_(grid.u.size()), tables_(grid.u.size() * grid.v.size()) {}

const std::uint32_t* PlaceMap::find(DyadicPoint place) const {
  const Table& table = tables_[table_of(place)];
  if (table.count == 0) return nullptr;
  const Slot& slot = slots_[slot_of(table, key_of(place))];
  return slot.key == kEmpty ? nullptr : &slot.number;
}

std::uint32_t PlaceMap::find_or_insert(DyadicPoint place, std::uint32_t number) {
  Table& table = tables_[table_of(place)];
  const std::uint32_t key = key_of(place);
  std::uint32_t size = 0;
  std::uint32_t slot = 0;
  if (table.count > 0) {
    size = 1U << (32 - table.shift);
    slot = slot_of(table, key);
    if (slots_[slot].key == key) return slots_[slot].number;
  }
  if (2 * ++table.count > size) {
    grow(table);
    slot = slot_of(table, key);
  }
  slots_[slot] = {key, number};
  return number;
}

/// Doubles the slots of a table. Its new slots follow those of all tables.
void PlaceMap::grow(Table& table) {
  constexpr std::uint32_t kFirstShift = 28;
  const bool is_first = table.shift == 32;
  const Table old = table;
  table.shift = is_first ? kFirstShift : table.shift - 1;
  table.begin = static_cast<std::uint32_t>(slots_.size());
  slots_.resize(slots_.size() + (std::size_t{1} << (32 - table.shift)));
  if (is_first) return;
  for (std::uint32_t k = 0; k < 1U << (32 - old.shift); ++k) {
    const Slot slot = slots_[old.begin + k];
    if (slot.key != kEmpty) slots_[slot_of(table, slot.key)] = slot;
  }
}

}  // namespace saddle
