#include "mesh/tree/edge_table.h"
#include "mesh/model/mesh.h"

namespace saddle {

namespace {

/// Searches that may be in vain at first: waves have sides as steep as cliffs, or many jumps on
/// each.
constexpr std::size_t kSoughtInVain = 128;

}  // namespace

bool SearchCount::may_be_found(std::size_t for_each) const {
  return sought <= kSoughtInVain + for_each * found;
}

EdgeRecord& EdgeTable::record(std::uint32_t a, std::uint32_t b) {
  const auto [at, is_new] =
      places_.insert(pair_of(a, b), static_cast<std::uint32_t>(records_.size()));
  if (is_new) records_.push_back({side_of(a, b), {}});
  return records_[at];
}

std::optional<EdgeFeature> EdgeTable::find_feature(std::uint32_t a, std::uint32_t b) const {
  const EdgeRecord* const record = find(a, b);
  return record != nullptr ? record->feature : std::nullopt;
}

void EdgeTable::set_feature(std::uint32_t a, std::uint32_t b, std::optional<EdgeFeature> feature) {
  EdgeRecord& edge = record(a, b);
  if (!edge.is_searched) searched_.push_back(static_cast<std::uint32_t>(&edge - records_.data()));
  edge.is_searched = true;
  if (!edge.is_halved && edge.feature) vertex_count_ -= edge.feature->count_new_vertices();
  edge.feature = feature;
  if (!feature) return;
  if (!edge.is_halved) vertex_count_ += feature->count_new_vertices();
  has_features_ = true;
  has_pole_features_ = has_pole_features_ || feature->kind == FeatureKind::Pole;
  vertices_.mark_beside_feature(a);
  vertices_.mark_beside_feature(b);
  effort_.add_discontinuities(1);
  const dvec2 middle = 0.5 * (vertices_.place_between(a) + vertices_.place_between(b));
  crossed_cells_.add(middle);
  revisions_.mark(middle);
}

void EdgeTable::discount_feature(std::uint32_t a, std::uint32_t b) {
  if (!feature(a, b)) return;
  EdgeRecord& edge = record(a, b);
  if (!edge.is_halved) vertex_count_ -= edge.feature->count_new_vertices();
  edge.is_halved = true;
}

void EdgeTable::set_leads_to_pole(std::uint32_t a, std::uint32_t b, const PoleEnds& ends) {
  EdgeRecord& edge = record(a, b);
  if (edge.pole != kNoIndex) return;
  edge.pole = static_cast<std::uint32_t>(poles_.size());
  poles_.push_back(ends);
  effort_.add_discontinuities(1);
}

std::vector<EdgeTable::PoleEnds> EdgeTable::poles(const Mesh& mesh) const {
  std::vector<PoleEnds> poles = poles_;
  poles.insert(poles.end(), poles_beyond_faces_.begin(), poles_beyond_faces_.end());
  for (const std::uint32_t number : searched_) {
    const auto& feature = records_[number].feature;
    if (!feature || feature->kind != FeatureKind::Pole) continue;
    poles.push_back({mesh.uv[feature->beside_first], mesh.uv[feature->beside_second]});
  }
  return poles;
}

std::vector<Side> EdgeTable::sides_with_features() const {
  std::vector<Side> result;
  for (const std::uint32_t number : searched_) {
    if (records_[number].feature) result.push_back(records_[number].side);
  }
  return result;
}

}  // namespace saddle
