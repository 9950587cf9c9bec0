#include "mesh/proof/unproved_parts.h"

#include "mesh/model/tolerances.h"

namespace saddle {

void UnprovedParts::add_gap(GapReason why, std::uint32_t patch,
                            const std::optional<ParameterBox>& part) {
  const auto number = part ? static_cast<std::uint32_t>(parts_.size()) : kNoIndex;
  gaps_.push_back({patch, why, number});
  if (part) parts_.push_back(*part);
}

void UnprovedParts::add_box(const UnprovedBox& box) {
  boxes_.push_back(box);
  if (boxes_.size() == kKeptAtATime) pass_on();
}

void UnprovedParts::pass_on() {
  take_(boxes_);
  boxes_.clear();
}

}  // namespace saddle
