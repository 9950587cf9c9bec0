#include "mesh/proof/proof_budget.h"

#include <algorithm>

#include "formula/operations.h"
#include "mesh/model/tolerances.h"
#include "mesh/model/triangle_tree.h"

namespace saddle {
namespace {

/// Boxes for a search of few boxes: 4,000, and fewer for long formulas, 1.25 million instructions.
constexpr std::size_t kMaxBoxes = 4'000;
constexpr std::size_t kMaxSteps = 1'250'000;
/// Places that a box takes: 6, and one for each 12 instructions; and a measured point.
constexpr std::size_t kPlacesPerBox = 6;
constexpr std::size_t kStepsPerPlace = 12;
constexpr std::size_t kPlacesPerPoint = 2;
/// Proofs may take kShareOfMesh of the places that their mesh took, and 16,000, about half the time
/// that the program takes to start.
constexpr double kLeastPlaces = 16'000;
/// Short levels of boxes may take 170,000 in place of 16,000: the proof of a tube around a knot
/// takes 150,000.
constexpr double kLeastPlacesOfShort = 170'000;
/// Cost of a special function, in steps.
constexpr std::size_t kSpecialSteps = 600;

}  // namespace

ProofBudget::ProofBudget(const Tape& tape, double share) : count_(tape.count), share_(share) {
  std::size_t steps = 1;
  for (const auto& part : {tape.of_u, tape.of_v, tape.of_both}) {
    for (const Instruction& instruction : part) {
      steps += is_special(instruction.op) ? kSpecialSteps : 1;
    }
  }
  of_box_ = kPlacesPerBox + steps / kStepsPerPlace;
  boxes_of_search_ = std::min(kMaxBoxes, kMaxSteps / steps);
  allow_for(0);
}

void ProofBudget::allow_for(std::size_t effort) {
  const double of_mesh = kShareOfMesh * static_cast<double>(effort);
  most_ = static_cast<std::size_t>(share_ * kLeastPlaces + of_mesh);
  most_of_short_ = static_cast<std::size_t>(share_ * kLeastPlacesOfShort + of_mesh);
}

std::size_t ProofBudget::boxes_left(bool is_short) const {
  if (is_spent(is_short)) return 0;
  return ((is_short ? most_of_short_ : most_) - spent_ - 1) / of_box_ + 1;
}

void ProofBudget::take_boxes(std::size_t count) {
  boxes_ += count;
  spent_ += count * of_box_;
}

void ProofBudget::take_points(std::size_t count) {
  spent_ += kPlacesPerPoint * count;
}

bool ProofBudget::may_visit() const {
  return kPlacesPerPoint * visited_ / kVisitsPerPoint < most_of_short_;
}

}  // namespace saddle
