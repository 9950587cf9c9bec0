#include "mesh/proof/jump_search.h"

#include <algorithm>

#include "mesh/model/tolerances.h"
#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// The result of a search of a box, and the parts that it took.
struct Search {
  bool may_jump = false;
  std::size_t parts = 0;
};

/// Whether bounds exclude a jump.
bool excludes_jump(std::span<const Interval> bounds) {
  return least_defined(bounds) == Defined::No ||
         std::ranges::all_of(bounds, [](const Interval& a) { return a.continuous; });
}

Search search(const JumpBox& whole, SurfaceEnclosure& enclosure) {
  struct Part {
    ParameterBox box;
    int depth;
  };
  Search result;
  std::vector<Part> open = {{whole.box, 0}};
  // Depth first: a line of jumps is met after few parts more than kMaxBrokenDepth.
  while (!open.empty()) {
    if (result.parts == kMostOpen) {
      result.may_jump = true;
      break;
    }
    const Part part = open.back();
    open.pop_back();
    ++result.parts;
    const std::span<const Interval> bounds = enclosure.enclose(part.box);
    if (excludes_jump(bounds) || hull_of(bounds).diagonal() <= whole.least) continue;
    if (part.depth == kMaxBrokenDepth) {
      result.may_jump = least_defined(bounds) == Defined::Yes;
      if (result.may_jump) break;
      continue;
    }
    for (const ParameterBox& half : halves_of(part.box, part.depth % 2))
      open.push_back({half, part.depth + 1});
  }
  return result;
}

}  // namespace

std::vector<std::uint8_t> cells_that_may_jump(const Surface& surface, const RootLines& root,
                                              ProofBudget& budget) {
  const std::size_t cells_u = root.u.size() - 1;
  std::vector<std::uint8_t> may_jump(cells_u * (root.v.size() - 1), 0);
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  BoxSubdivision<RootCells> search({all_cells(root)});
  while (!search.open().empty() && !budget.is_spent(true)) {
    search.test([&](const RootCells& cells) {
      budget.take_boxes(1);
      if (excludes_jump(enclosure.enclose(cells.box_in(root)))) return ProofOutcome::Proved;
      if (!cells.is_one()) return ProofOutcome::Open;
      may_jump[cells.first_v * cells_u + cells.first_u] = 1;
      return ProofOutcome::Refuted;
    });
    search.halve_each(halve_cells);
  }
  return may_jump;
}

std::vector<std::size_t> find_may_jump(const Surface& surface, std::span<const JumpBox> boxes,
                                       ProofBudget& budget, unsigned threads) {
  SurfaceEnclosures enclosures(surface, Bounded::Position);
  std::vector<std::size_t> found;
  std::vector<Search> searches;
  for (std::size_t first = 0; first < boxes.size() && !budget.is_spent(true); first += kInBatch) {
    const auto some = boxes.subspan(first, std::min(kInBatch, boxes.size() - first));
    searches.assign(some.size(), {});
    enclosures.in_chunks(some.size(), kSearchedTogether, threads,
                         [&](SurfaceEnclosure& enclosure, std::size_t begin, std::size_t end) {
                           for (std::size_t k = begin; k < end; ++k)
                             searches[k] = search(some[k], enclosure);
                         });
    for (std::size_t k = 0; k < some.size(); ++k) {
      budget.take_boxes(searches[k].parts);
      if (searches[k].may_jump) found.push_back(first + k);
    }
  }
  return found;
}

}  // namespace saddle
