// The distances that a proof allows, on surfaces whose bounds are known exactly.
#include "mesh/proof/certify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "surface_from_text.h"

namespace saddle {
namespace {

/// |r_uu| of z = 4 u^2; the other second derivatives are 0.
constexpr double kBend = 8;
/// Bounds of derivatives are right to their last digits.
constexpr double kSlack = 1e-9;

struct Proof {
  Certification certification;
  double farthest = 0;       ///< the largest reach of the boxes whose points are measured
  std::size_t measured = 0;  ///< boxes
};

/// A proof of z = 4 u^2 over `patches` equal root cells along u in [0, 1], each a patch whose
/// points are all within the tolerance.
Proof prove_parabola(std::size_t patches, double allowed) {
  const Surface surface = height_field("4*u^2", {0, 1, 0, 1});
  std::vector<double> u;
  for (std::size_t k = 0; k <= patches; ++k) {
    u.push_back(static_cast<double>(k) / static_cast<double>(patches));
  }
  const std::array<double, 2> v = {0, 1};
  const Patches all{patches,
                    [&](std::size_t k) {
                      return Patch{{{u[k], 0}, {u[k + 1], 1}}, allowed, std::nullopt};
                    },
                    [](std::size_t k) { return k; }};
  Proof proof;
  const MeasureBoxes measure = [&](std::span<const BoundedBox> boxes) {
    for (const BoundedBox& box : boxes) proof.farthest = std::max(proof.farthest, box.reach);
    proof.measured += boxes.size();
    return std::vector<ProofOutcome>(boxes.size(), ProofOutcome::Proved);
  };
  ProofBudget budget(surface.bounds);
  const BoxHandlers handlers = {measure, [](std::span<const UnprovedBox>) {}};
  proof.certification = certify(surface, {u, v}, all, std::nullopt, handlers, budget);
  return proof;
}

/// Triangles of side h are within h^2 |r_uu| / 8.
double distance_of_triangles(std::size_t patches) {
  const double side = 1 / static_cast<double>(patches);
  return side * side * kBend / 8;
}

TEST(Certify, ProvesByBoundsAloneWhatIsWithinFourTolerances) {
  for (const std::size_t patches : {1, 4}) {
    const double distance = distance_of_triangles(patches);
    const Proof proof = prove_parabola(patches, (1 + kSlack) * distance / 4);
    EXPECT_EQ(proof.measured, 0U) << patches;
    EXPECT_TRUE(proof.certification.proof_gaps.empty()) << patches;
    EXPECT_NEAR(proof.certification.bound, distance, kSlack * distance) << patches;
  }
}

/// The other tolerance is that of the points themselves.
TEST(Certify, MeasuresWhatIsFartherAtPointsThatBoundsReachWithinThreeTolerances) {
  for (const std::size_t patches : {1, 4}) {
    const double allowed = (1 - kSlack) * distance_of_triangles(patches) / 4;
    const Proof proof = prove_parabola(patches, allowed);
    EXPECT_EQ(proof.measured, patches);
    EXPECT_LE(proof.farthest, 3 * allowed) << patches;
    EXPECT_TRUE(proof.certification.proof_gaps.empty()) << patches;
    EXPECT_EQ(proof.certification.bound, 4 * allowed) << patches;
  }
}

}  // namespace
}  // namespace saddle
