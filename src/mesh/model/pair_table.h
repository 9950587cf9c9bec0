// A hash table from pairs of corners or points to small values, for millions of pairs: open
// addressing in one array, where std::unordered_map allocates memory for each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace saddle {

/// Two corners or two points, the smaller number first; never a number with itself.
using Pair = std::uint64_t;

inline Pair pair_of(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return (Pair{low} << 32) | high;
}

template <class Value>
class PairMap {
 public:
  std::size_t size() const { return size_; }

  /// Inserts `value` unless the pair has a value. Returns the pair's value, and whether it is new.
  std::pair<Value, bool> insert(Pair pair, Value value = {}) {
    const auto [slot, is_new] = slot_for(pair, value);
    return {slot->value, is_new};
  }

  /// The pair's value, `Value()` if it is new. Holds until the next pair is inserted.
  Value& operator[](Pair pair) { return slot_for(pair, {}).first->value; }

  std::optional<Value> find(Pair pair) const {
    if (size_ == 0) return std::nullopt;
    const Slot& slot = slots_[place_of(pair)];
    return slot.pair == kNone ? std::nullopt : std::optional(slot.value);
  }

  bool contains(Pair pair) const { return find(pair).has_value(); }

  void clear() {
    slots_.clear();
    size_ = 0;
  }

 private:
  /// No pair: a number with itself.
  static constexpr Pair kNone = ~Pair{0};
  static constexpr std::size_t kFirstSlots = 64;  // a power of 2, as all sizes are

  struct Slot {
    Pair pair = kNone;
    Value value = {};
  };

  /// The pair's slot, with `value` if it is new, and whether it is.
  std::pair<Slot*, bool> slot_for(Pair pair, Value value) {
    // At most half of the slots are taken, so that searches are short.
    if (2 * (size_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[place_of(pair)];
    const bool is_new = slot.pair == kNone;
    if (is_new) {
      slot = {pair, value};
      ++size_;
    }
    return {&slot, is_new};
  }

  /// The pair's slot, or the free one where it would be inserted. Source: D. E. Knuth, "The Art of
  /// Computer Programming" 3, section 6.4: multiplicative hashing, linear probing.
  std::size_t place_of(Pair pair) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = ((pair * 0x9E3779B97F4A7C15ULL) >> 32) & mask;
    while (slots_[place].pair != kNone && slots_[place].pair != pair) place = (place + 1) & mask;
    return place;
  }

  void grow() {
    std::vector<Slot> old(std::max(kFirstSlots, 2 * slots_.size()));
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.pair != kNone) slots_[place_of(slot.pair)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

using PairTable = PairMap<std::uint32_t>;

}  // namespace saddle
