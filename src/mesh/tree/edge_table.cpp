#include "mesh/tree/edge_table.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/model/mesh.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Searches that may be in vain at first: waves have sides as steep as cliffs, or many jumps on
/// each.
constexpr std::size_t kSoughtInVain = 128;

}  // namespace

bool SearchCount::may_be_found(std::size_t for_each) const {
  return sought <= kSoughtInVain + for_each * found;
}

/// The cut of a side, which has none of its parts if it is new.
EdgeCut& EdgeTable::add_cut(std::uint32_t a, std::uint32_t b) {
  EdgeFacts& facts = facts_of(a, b);
  if (facts.cut == 0) {
    cuts_.push_back({side_of(a, b), {}});
    facts.cut = static_cast<std::uint32_t>(cuts_.size());
  }
  return cuts_[facts.cut - 1];
}

std::optional<EdgeFeature> EdgeTable::find_feature(std::uint32_t a, std::uint32_t b) const {
  const EdgeCut* const found = cut(a, b);
  return found != nullptr ? found->feature : std::nullopt;
}

void EdgeTable::set_feature(std::uint32_t a, std::uint32_t b, std::optional<EdgeFeature> feature) {
  EdgeFacts& facts = facts_of(a, b);
  facts.is_searched = 1;
  if (!feature && facts.cut == 0) return;
  EdgeCut& edge = add_cut(a, b);
  if (!edge.is_halved && edge.feature) vertex_count_ -= edge.feature->count_new_vertices();
  edge.feature = feature;
  if (!feature) return;
  if (!edge.is_halved) vertex_count_ += feature->count_new_vertices();
  has_features_ = true;
  has_pole_features_ = has_pole_features_ || feature->kind == FeatureKind::Pole;
  has_jumps_ = has_jumps_ || feature->kind == FeatureKind::Jump;
  vertices_.mark_beside_feature(a);
  vertices_.mark_beside_feature(b);
  effort_.add_discontinuities(1);
  const dvec2 middle = 0.5 * (vertices_.place_between(a) + vertices_.place_between(b));
  crossed_cells_.add(middle);
  revisions_.mark(middle);
}

void EdgeTable::discount_feature(std::uint32_t a, std::uint32_t b) {
  if (!feature(a, b)) return;
  EdgeCut& edge = add_cut(a, b);
  if (!edge.is_halved) vertex_count_ -= edge.feature->count_new_vertices();
  edge.is_halved = true;
}

void EdgeTable::pass_on(std::uint32_t from, std::uint32_t middle, std::uint32_t to) {
  const EdgeFacts whole = facts(from, to);
  if (whole.is_proved == 0) return;
  const EdgeCut* const at = cut_of(whole);
  if (at == nullptr || !at->feature || at->feature->is_continuous()) {
    pass_on_part(from, middle, std::nullopt);
    return pass_on_part(middle, to, std::nullopt);
  }
  const EdgeFeature jumps = *at->feature;  // a copy: cuts move
  if (jumps.kind != FeatureKind::Jump) return;
  const std::uint32_t first = jumps.first;
  const std::uint32_t second = first == from ? to : from;
  const dvec2 begin = vertices_.place_between(first);
  const double part = glm::distance(begin, vertices_.place_between(middle));
  const double same = kSame * glm::distance(begin, vertices_.place_between(second));
  std::uint32_t before = 0;  // jumps before the middle
  bool is_at_middle = false;
  jumps.for_jumps(first, [&](std::uint32_t beside, std::uint32_t) {
    const double at = glm::distance(begin, vertices_.place_between(beside));
    is_at_middle = is_at_middle || std::fabs(at - part) <= same;
    if (at < part) ++before;
  });
  if (is_at_middle) return;
  const std::uint32_t after = jumps.strips + 1U - before;
  std::optional<EdgeFeature> near;
  std::optional<EdgeFeature> far;
  if (before > 0) {
    near = jumps;
    near->strips = static_cast<std::uint8_t>(before - 1);
    if (after > 0) near->beside_second = jumps.first_on_strips + 2 * (before - 1);
  }
  if (after > 0) {
    far = jumps;
    far->first = middle;
    far->strips = static_cast<std::uint8_t>(after - 1);
    if (before > 0) {
      far->beside_first = jumps.first_on_strips + 2 * (before - 1) + 1;
      far->first_on_strips = jumps.first_on_strips + 2 * before;
    }
  }
  pass_on_part(first, middle, near);
  pass_on_part(middle, second, far);
}

/// A part without a jump may have a crease.
void EdgeTable::pass_on_part(std::uint32_t a, std::uint32_t b,
                             const std::optional<EdgeFeature>& jumps) {
  EdgeFacts& part = facts_of(a, b);
  if (part.is_searched != 0 || part.is_continuous != 0) return;
  part.is_proved = 1;
  if (jumps) {
    set_feature(a, b, jumps);
  } else {
    part.is_continuous = 1;
  }
}

void EdgeTable::set_leads_to_pole(std::uint32_t a, std::uint32_t b, const PoleEnds& ends) {
  EdgeCut& edge = add_cut(a, b);
  if (edge.pole != kNoIndex) return;
  edge.pole = static_cast<std::uint32_t>(poles_.size());
  poles_.push_back(ends);
  effort_.add_discontinuities(1);
}

std::vector<EdgeTable::PoleEnds> EdgeTable::poles(const Mesh& mesh) const {
  std::vector<PoleEnds> poles = poles_;
  poles.insert(poles.end(), poles_beyond_faces_.begin(), poles_beyond_faces_.end());
  for (const EdgeCut& cut : cuts_) {
    const auto& feature = cut.feature;
    if (!feature || feature->kind != FeatureKind::Pole) continue;
    poles.push_back({mesh.uv[feature->beside_first], mesh.uv[feature->beside_second]});
  }
  return poles;
}

std::vector<Side> EdgeTable::sides_with_features() const {
  std::vector<Side> result;
  for (const EdgeCut& cut : cuts_) {
    if (cut.feature) result.push_back(cut.side);
  }
  return result;
}

}  // namespace saddle
