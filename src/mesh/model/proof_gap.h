// Proof gaps: boxes of parameters where it is not proved that a mesh shows all of its surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"
#include "surface/surface.h"

namespace saddle {

/// Why there is no proof.
enum class GapReason : std::uint8_t {
  Boundary,       ///< the surface ends there
  Jump,           ///< it jumps
  Pole,           ///< it goes to infinity
  NoLimit,        ///< each way to a point leads elsewhere
  Singular,       ///< a point without a normal of its own
  Crease,         ///< its normal jumps
  Undefined,      ///< bounds cannot exclude that it is undefined somewhere
  Discontinuous,  ///< bounds cannot exclude that it jumps somewhere
  Nonsmooth,      ///< second derivatives are infinite or do not exist
  Wide,       ///< bounds of second derivatives are too wide, or these are large along the surface
  Work,       ///< the budget of boxes ended
  Flat,       ///< triangles without area were left out
  Triangles,  ///< the limit of triangles came first
  Off,        ///< a search found the mesh off by more than its tolerance
  NotTried,   ///< no proof was asked for, or samples kept failing
};

/// One word or two for the report.
std::string name_of(GapReason why);
/// The end of a sentence about the surface.
std::string words_for(GapReason why);

/// Whether bounds alone are the reason: they do not say what is there.
constexpr bool follows_from_bounds(GapReason why) {
  return why >= GapReason::Crease && why <= GapReason::Work;
}

/// A box of parameters without a proof; low may be the larger where a range runs backwards.
struct GapBox {
  GapReason why;
  dvec2 low, high;

  bool contains(const dvec2& uv) const;
};

/// The same, and how large a feature it may hide.
struct ProofGap : GapBox {
  double share = 0;    ///< of the domain that has no proof: at most that of the box
  double visible = 0;  ///< of the domain: where bounds leave room for a visible feature
  double width = 0;    ///< in parameters: such a feature is narrower
  double room = 0;     ///< largest distance of a feature from the mesh, by bounds
  dvec2 worst{0};      ///< where `room` is
};

/// Places with a known reason for a gap.
class GapReasons {
 public:
  /// The reason that was added first is the one of a box that holds several places.
  void add(GapReason why, const dvec2& uv) { named_.push_back({why, uv, named_.size()}); }
  /// Gives boxes whose reason follows from bounds alone the reason of a place in them.
  void give_to(std::span<GapBox> places);

 private:
  struct Named {
    GapReason why;
    dvec2 uv;
    std::size_t order;
  };
  std::vector<Named> named_;
};

/// The gap around two gaps: sums of shares, the larger width and room.
ProofGap united(const ProofGap& a, const ProofGap& b);

/// Unites boxes of one reason that touch, or nearly do: the sum of their shares, the largest width
/// and room.
class MergedGaps {
 public:
  explicit MergedGaps(const Domain& domain) : domain_(domain) {}

  void add(const ProofGap& gap);
  /// At most kMaxListed, in the order of reasons.
  std::vector<ProofGap> take();

 private:
  /// Cells of a grid over the domain, with the box around what is in each.
  using Boxes = std::vector<std::optional<ProofGap>>;
  using Cell = std::array<std::size_t, 2>;

  Cell cell_at(const dvec2& uv) const;
  static ProofGap flood(std::size_t start, Boxes& boxes);

  Domain domain_;
  std::map<GapReason, Boxes> boxes_;
};

}  // namespace saddle
