#include "mesh/tree/place_map.h"

#include <algorithm>
#include <utility>

#include "mesh/grid/grid.h"

namespace saddle {

namespace {

/// A table begins with 2^(32 - 30) = 4 slots, for the three places that a root cell owns when all
/// of its samples are stored. Larger tables are full when half of their slots are taken.
constexpr std::uint32_t kFirstShift = 30;
/// A table shrinks to half of its slots when less than a quarter of them are taken.
constexpr std::uint32_t kSparse = 4;

std::uint32_t most_places(std::uint32_t slots) {
  return slots == 1U << (32 - kFirstShift) ? slots - 1 : slots / 2;
}

}  // namespace

/// The slot of a key within its table, if no other has it: multiplicative hashing.
std::uint32_t PlaceMap::home_of(const Table& table, std::uint32_t key) {
  return (key * 0x9e3779b9U) >> table.shift;  // 2^32 / golden ratio
}

/// The slot of a key, or the free slot where it would go: linear probing.
std::uint32_t PlaceMap::slot_of(const Table& table, std::uint32_t key) const {
  const std::uint32_t mask = ~std::uint32_t{0} >> table.shift;
  std::uint32_t slot = home_of(table, key);
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
  if (++table.count > most_places(size)) {
    resize(table, std::min<std::uint32_t>(table.shift - 1, kFirstShift));
    slot = slot_of(table, key);
  }
  slots_[slot] = {key, number};
  return number;
}

void PlaceMap::erase(DyadicPoint place) {
  Table& table = tables_[table_of(place)];
  const std::uint32_t mask = ~std::uint32_t{0} >> table.shift;
  std::uint32_t gap = slot_of(table, key_of(place)) - table.begin;
  // Keys behind the gap move into it if a search for them would pass it.
  for (std::uint32_t next = (gap + 1) & mask;; next = (next + 1) & mask) {
    const Slot& slot = slots_[table.begin + next];
    if (slot.key == kEmpty) break;
    const std::uint32_t from_home = (next - home_of(table, slot.key)) & mask;
    if (from_home < ((next - gap) & mask)) continue;
    slots_[table.begin + gap] = slot;
    gap = next;
  }
  slots_[table.begin + gap] = {};
  table.count -= 1U;
  if (table.count == 0) {
    give_back_slots(table);
    table = {};
  } else if (kSparse * table.count <= mask && table.shift < kFirstShift) {
    resize(table, table.shift + 1);
  }
}

/// Empty slots for a table of this shift.
std::uint32_t PlaceMap::take_slots(std::uint32_t shift) {
  std::vector<std::uint32_t>& known = free_[shift];
  if (!known.empty()) {
    const std::uint32_t begin = known.back();
    known.pop_back();
    return begin;
  }
  const auto begin = static_cast<std::uint32_t>(slots_.size());
  slots_.resize(slots_.size() + (std::size_t{1} << (32 - shift)));
  return begin;
}

/// Gives a table 2^(32 - shift) slots.
void PlaceMap::resize(Table& table, std::uint32_t shift) {
  const Table old = table;
  table.shift = shift;
  table.begin = take_slots(shift);
  if (old.shift == Table().shift) return;  // it had no slots
  for (std::uint32_t k = 0; k < 1U << (32 - old.shift); ++k) {
    const Slot slot = std::exchange(slots_[old.begin + k], {});
    if (slot.key != kEmpty) slots_[slot_of(table, slot.key)] = slot;
  }
  give_back_slots(old);
}

}  // namespace saddle
