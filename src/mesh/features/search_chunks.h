// Searches of many lines on several threads: some lines at a time, always the same ones together.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <span>
#include <type_traits>

#include "base/parallel.h"

namespace saddle {

/// The results of search(some, work) for chunks of so many items, one for each item, in their
/// order. Adds to `work` what the searches add to counts of their own.
template <class Item, class Search>
auto search_chunks(std::span<const Item> items, std::size_t chunk, unsigned threads,
                   std::size_t& work, const Search& search) {
  using Results = std::invoke_result_t<Search, std::span<const Item>, std::size_t&>;
  Results results(items.size());
  std::atomic<std::size_t> total = 0;
  const auto search_some = [&](std::size_t begin, std::size_t end) {
    std::size_t own = 0;
    Results some = search(items.subspan(begin, end - begin), own);
    std::ranges::move(some, results.begin() + static_cast<std::ptrdiff_t>(begin));
    total += own;
  };
  parallel_chunks(items.size(), chunk, threads, search_some);
  work += total;
  return results;
}

}  // namespace saddle
