#include "base/heap.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#endif

namespace saddle {

#ifdef __GLIBC__

namespace {

/// The heap's step of growth, and the size from which allocations get memory of their own:
/// a picture of 800x600 with its surface needs less. It costs addresses; memory is what is touched.
constexpr int kHeapStep = 64 << 20;
constexpr std::uintptr_t kHugePage = std::uintptr_t{2} << 20;
/// The size of a large array: smaller ones are taken and freed often, and each of their pages would
/// cost an interruption every time.
constexpr int kLargeArray = kHugePage;
/// The main heap, of huge pages, and one for other threads: where all share one, they wait for each
/// other. Each heap more takes kHeapStep of what --max-memory allows.
constexpr int kMostHeaps = 2;

std::uintptr_t next_huge_page(std::uintptr_t address) {
  return (address + kHugePage - 1) / kHugePage * kHugePage;
}

/// Advises the system to use huge pages where whole ones fit. Returns whether it will.
bool advise_huge_pages(std::uintptr_t start, std::uintptr_t end) {
  const std::uintptr_t first = next_huge_page(start);
  const std::uintptr_t last = end / kHugePage * kHugePage;
  return first < last && madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE) == 0;
}

}  // namespace

bool use_huge_pages() {
  if (mallopt(M_MMAP_THRESHOLD, kHeapStep) == 0 || mallopt(M_TRIM_THRESHOLD, 2 * kHeapStep) == 0 ||
      mallopt(M_TOP_PAD, kHeapStep) == 0 || mallopt(M_ARENA_MAX, kMostHeaps) == 0) {
    return false;
  }
  // More than the heap has left: it grows by a step.
  void* const block = std::malloc(std::size_t{256} << 10);
  const auto start = reinterpret_cast<std::uintptr_t>(block);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  std::free(block);
  if (block == nullptr || start >= end || end - start > 2 * std::uintptr_t{kHeapStep}) return false;
  if (!advise_huge_pages(start, end)) return false;
  // Memory before the first huge page is never used: it would be got by small pages.
  static const void* const unused = std::malloc(next_huge_page(start) - start);
  return unused != nullptr;
}

void prefer_huge_pages(void* block, std::size_t bytes) {
  if (bytes < kHugePage) return;
  const auto start = reinterpret_cast<std::uintptr_t>(block);
  advise_huge_pages(start, start + bytes);
}

void set_large_arrays_apart() {
  mallopt(M_MMAP_THRESHOLD, kLargeArray);
  malloc_trim(0);
}

void give_back_free_memory() {
  malloc_trim(0);
}

#else

bool use_huge_pages() {
  return false;
}

void prefer_huge_pages(void* /*block*/, std::size_t /*bytes*/) {}

void set_large_arrays_apart() {}

void give_back_free_memory() {}

#endif

void reserve_stack() {
  constexpr rlim_t kReserved = rlim_t{1} << 20;
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0) return;
  const rlim_t bytes = std::min(kReserved, limit.rlim_cur / 2);
  *static_cast<volatile char*>(__builtin_alloca(bytes)) = 0;  // its lowest byte
}

}  // namespace saddle
