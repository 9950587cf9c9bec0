#include "mesh/model/proof_gap.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

struct GapText {
  const char* name;
  const char* words;
};

/// In the order of GapReason.
constexpr std::array kTexts = {
    GapText{"rim", "the surface ends there"},
    GapText{"jump", "it jumps"},
    GapText{"pole", "it goes to infinity"},
    GapText{"no limit", "each way leads to another place"},
    GapText{"singular point", "a point has no normal of its own"},
    GapText{"crease", "it has a crease"},
    GapText{"may be undefined",
            "bounds of the formula do not exclude that it is undefined somewhere"},
    GapText{"may jump", "bounds of the formula do not exclude a jump"},
    GapText{"endless derivatives", "second derivatives are endless or do not exist"},
    GapText{"wide bounds", "second derivatives are too large, or their bounds too wide"},
    GapText{"limit of work", "a proof would take more work than it is worth"},
    GapText{"left out", "triangles have no area in double precision and are left out"},
    GapText{"limit of triangles", "--max-triangles stopped refinement"},
    GapText{"off", "the mesh is off by more than its tolerance there"},
    GapText{"not tried", "nothing was proved of this mesh"},
};

}  // namespace

std::string name_of(GapReason why) {
  return kTexts[static_cast<std::size_t>(why)].name;
}

std::string words_for(GapReason why) {
  return kTexts[static_cast<std::size_t>(why)].words;
}

ProofGap united(const ProofGap& a, const ProofGap& b) {
  return {{a.why, glm::min(a.low, b.low), glm::max(a.high, b.high)},
          a.share + b.share,
          a.visible + b.visible,
          std::max(a.width, b.width),
          std::max(a.room, b.room),
          a.room < b.room ? b.worst : a.worst};
}

bool GapBox::contains(const dvec2& uv) const {
  return glm::all(glm::lessThanEqual(glm::min(low, high), uv)) &&
         glm::all(glm::lessThanEqual(uv, glm::max(low, high)));
}

void GapReasons::give_to(std::span<GapBox> places) {
  const auto u_of = [](const Named& named) { return named.uv.x; };
  std::ranges::sort(named_, {}, u_of);
  for (GapBox& place : places) {
    if (!follows_from_bounds(place.why)) continue;
    const auto [low, high] = std::minmax(place.low.x, place.high.x);
    std::size_t first = named_.size();
    auto at = std::ranges::lower_bound(named_, low, {}, u_of);
    for (; at != named_.end() && at->uv.x <= high; ++at) {
      if (at->order >= first || !place.contains(at->uv)) continue;
      first = at->order;
      place.why = at->why;
    }
  }
}

void MergedGaps::add(const ProofGap& gap) {
  Boxes& boxes = boxes_[gap.why];
  boxes.resize(kDomainParts * kDomainParts);
  const Cell a = cell_at(gap.low);
  const Cell b = cell_at(gap.high);
  const Cell first = {std::min(a[0], b[0]), std::min(a[1], b[1])};
  const Cell last = {std::max(a[0], b[0]), std::max(a[1], b[1])};
  for (std::size_t j = first[1]; j <= last[1]; ++j) {
    for (std::size_t i = first[0]; i <= last[0]; ++i) {
      ProofGap part = gap;
      part.low = glm::min(gap.low, gap.high);
      part.high = glm::max(gap.low, gap.high);
      // The share of a box that lies in several cells counts once.
      if (i != first[0] || j != first[1]) part.share = part.visible = 0;
      auto& box = boxes[j * kDomainParts + i];
      box = box ? united(*box, part) : part;
    }
  }
}

/// The connected components of the boxes of each reason: those in the same or in neighbouring cells
/// are united.
std::vector<ProofGap> MergedGaps::take() {
  std::vector<ProofGap> result;
  for (auto& [why, boxes] : boxes_) {
    for (std::size_t cell = 0; cell < boxes.size(); ++cell) {
      if (boxes[cell]) result.push_back(flood(cell, boxes));
    }
  }
  if (result.size() > kMaxListed) result.resize(kMaxListed);
  return result;
}

MergedGaps::Cell MergedGaps::cell_at(const dvec2& uv) const {
  const dvec2 part = (uv - dvec2(domain_.u0, domain_.v0)) /
                     dvec2(domain_.u1 - domain_.u0, domain_.v1 - domain_.v0);
  const auto index = [](double x) {
    return static_cast<std::size_t>(std::clamp(x * kDomainParts, 0.0, kDomainParts - 1.0));
  };
  return {index(part.x), index(part.y)};
}

/// Removes the component of a cell and returns its box.
ProofGap MergedGaps::flood(std::size_t start, Boxes& boxes) {
  ProofGap whole = *boxes[start];
  whole.share = whole.visible = 0;
  std::vector<std::size_t> open = {start};
  while (!open.empty()) {
    const std::size_t cell = open.back();
    open.pop_back();
    if (!boxes[cell]) continue;
    whole = united(whole, *boxes[cell]);
    boxes[cell].reset();
    const std::size_t i = cell % kDomainParts;
    const std::size_t j = cell / kDomainParts;
    for (std::size_t b = j == 0 ? 0 : j - 1; b <= std::min(j + 1, kDomainParts - 1); ++b) {
      for (std::size_t a = i == 0 ? 0 : i - 1; a <= std::min(i + 1, kDomainParts - 1); ++a) {
        if (boxes[b * kDomainParts + a]) open.push_back(b * kDomainParts + a);
      }
    }
  }
  return whole;
}

}  // namespace saddle
