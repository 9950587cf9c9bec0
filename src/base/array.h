// std::vector whose new elements are left uninitialised, for large arrays that are written once.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace saddle {

/// Leaves elements that are given no value as they are: writing zeros first would touch all of the
/// memory twice. Large blocks are asked for in huge pages: the system then clears and maps 2 MB at
/// a time in place of 4 KB, which is most of what the first touch of fresh memory costs.
template <class T>
class UninitializedAllocator {
 public:
  static_assert(std::is_trivially_destructible_v<T>);
  using value_type = T;

  UninitializedAllocator() = default;
  template <class U>
  UninitializedAllocator(const UninitializedAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) {
    if (!is_large(count)) return std::allocator<T>().allocate(count);
    void* const memory = ::operator new (count * sizeof(T), std::align_val_t{kHugePage});
    madvise(memory, count * sizeof(T), MADV_HUGEPAGE);  // a wish; ordinary pages will do
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    if (!is_large(count)) return std::allocator<T>().deallocate(memory, count);
    ::operator delete (memory, std::align_val_t{kHugePage});
  }

  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  template <class U>
  bool operator==(const UninitializedAllocator<U>&) const noexcept {
    return true;
  }

 private:
  static constexpr std::size_t kHugePage = std::size_t{1} << 21;
  /// Two pages hold at least one whole one.
  static bool is_large(std::size_t count) { return count * sizeof(T) >= 2 * kHugePage; }
};

/// resize() leaves new elements uninitialised; resize(n, value) does not.
template <class T>
using Array = std::vector<T, UninitializedAllocator<T>>;

}  // namespace saddle
