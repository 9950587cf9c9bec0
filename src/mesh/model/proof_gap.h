// Where it is not proved that a mesh shows all of its surface, and why not.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"
#include "surface/surface.h"

namespace saddle {

/// What stands against a proof.
enum class GapReason : std::uint8_t {
  Boundary,       ///< the surface ends there
  Jump,           ///< it jumps
  Pole,           ///< it goes to infinity
  NoLimit,        ///< each way to a point leads elsewhere
  Crease,         ///< its normal jumps
  Singular,       ///< a point without a normal of its own
  Undefined,      ///< bounds cannot exclude that it is undefined somewhere
  Discontinuous,  ///< nor that it jumps
  Nonsmooth,      ///< second derivatives are endless or do not exist
  Wide,       ///< bounds of second derivatives are too wide, or these are large along the surface
  Work,       ///< as many boxes as are worth it did not do
  Triangles,  ///< the limit of triangles came first
  NotTried,   ///< nothing was to be proved, or samples kept failing
};

/// One word or two for a report, and what to tell a reader.
std::string name_of(GapReason add_gap);
std::string words_for(GapReason add_gap);

/// A box of parameters without a proof; low may be the larger where a range runs backwards.
struct ProofGap {
  GapReason why;
  dvec2 low, high;

  bool contains(const dvec2& uv) const;
};

/// Places at which something was found that stands against a proof.
class GapReasons {
 public:
  /// Of those in one box the reason that was added first counts.
  void add(GapReason why, const dvec2& uv) { named_.push_back({why, uv, named_.size()}); }
  /// Gives boxes without a reason better than what bounds say that of a place in them.
  void give_to(std::span<ProofGap> places);

 private:
  struct Named {
    GapReason why;
    dvec2 uv;
    std::size_t order;
  };
  std::vector<Named> named_;
};

/// The same with boxes that touch or nearly do made one, if their reason is the same: at most
/// kMaxListed, in the order of reasons.
std::vector<ProofGap> merged(std::span<const ProofGap> places, const Domain& domain);

}  // namespace saddle
