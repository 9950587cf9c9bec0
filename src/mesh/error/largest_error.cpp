#include "mesh/error/largest_error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include <glm/common.hpp>

#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/sizing/effort.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// The search climbs from the worst kMostFollowed leaves. Bounds are followed in up to kMostOpen
/// leaves of each kind, then over up to 8,192 boxes, or the share that the surface may have.
constexpr std::size_t kMostBoxes = 8192;

/// The search, from the largest known error down.
class ErrorSearch {
 public:
  ErrorSearch(const ParameterBox& domain, double tolerance, const WholeMeshError& whole,
              const PlacedError& known)
      : domain_(domain), tolerance_(tolerance), whole_(whole), worst_(known) {}

  const PlacedError& worst() const { return worst_; }

  /// Measures leaves at their places.
  void measure(std::span<const SuspectLeaf> leaves, const WholeMeshSearch& how) {
    std::vector<SearchedPart> parts;
    std::vector<std::size_t> ends;  // of each part's places
    std::vector<WholeMeshError::Place> places;
    for (const SuspectLeaf& suspect : leaves) {
      parts.push_back(how.part(suspect.leaf));
      const SearchedPart& part = parts.back();
      for (const dvec2& uv : how.places(suspect.leaf))
        places.push_back({uv, part.triangles, worst_.distance / part.scale});
      ends.push_back(places.size());
    }
    const std::vector<double> found = whole_.distances(places);
    std::size_t k = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const SearchedPart& part = parts[i];
      // A part without triangles may go on in leaves without vertices.
      const ParameterBox& box = part.triangles.empty() ? domain_ : part.box;
      WholeMeshError::Climb start{{0, part.box.middle()}, box, part.triangles};
      for (; k < ends[i]; ++k) {
        if (found[k] > start.best.distance) start.best = {found[k], places[k].uv};
      }
      take(start.best, part.scale);
      starts_.push_back({start, part.scale});
    }
  }

  /// Measures leaves, sorted by their errors, that may be farther off than what is known: others
  /// need be known no better. `ends`: whether to stop, by the largest error so far.
  void measure_worst(std::span<const SuspectLeaf> leaves, const WholeMeshSearch& how,
                     const std::function<bool(double)>& ends) {
    const auto may_be_worst = [this](const SuspectLeaf& leaf) {
      return leaf.has_moved || leaf.error > worst_.distance;
    };
    for (std::size_t next = 0, at_once = kMostFollowed; next < leaves.size();
         next += std::exchange(at_once, kInBatch)) {
      const auto some = leaves.subspan(next, std::min(at_once, leaves.size() - next));
      if (std::ranges::none_of(some, may_be_worst)) continue;
      measure(some, how);
      if (ends(worst_.distance)) break;
    }
  }

  /// From so many leaves at most.
  void climb(std::size_t most) {
    std::ranges::stable_sort(starts_, std::ranges::greater(), &Start::error);
    std::vector<WholeMeshError::Climb> climbs;
    for (const Start& start : std::span(starts_).first(std::min(most, starts_.size())))
      climbs.push_back(start.climb);
    whole_.climb(climbs);
    for (std::size_t k = 0; k < climbs.size(); ++k) take(climbs[k].best, starts_[k].scale);
    starts_.clear();
  }

  /// Adds triangles that climb_on_mesh() measures.
  void measure_triangles(const SearchedPart& part) {
    if (part.scale != 1) return;
    for (const Triangle& t : part.triangles) on_mesh_.push_back(&t);
  }
  /// The error that is found, if it is larger.
  void take(const PlacedError& found, double scale) {
    if (scale * found.distance > worst_.distance) worst_ = {scale * found.distance, found.uv};
  }
  void climb_on_mesh() { take(whole_.from_mesh(on_mesh_, worst_.distance, tolerance_), 1); }

 private:
  struct Start {
    WholeMeshError::Climb climb;
    double scale;
    double error() const { return scale * climb.best.distance; }
  };

  ParameterBox domain_;
  double tolerance_;
  const WholeMeshError& whole_;
  PlacedError worst_;
  std::vector<Start> starts_;
  std::vector<const Triangle*> on_mesh_;
};

/// The points, and other work as points, that a surface has taken; 0 if they are not counted.
double work_of(const Surface& surface) {
  const auto& count = surface.tangents.count;
  return count ? static_cast<double>(count->with_work()) : 0;
}

/// The work that a surface may have taken once a mesh that is off is searched. Where sheets lie
/// close together, all parts would take ten times the work of the mesh: as many are searched as a
/// share of that allows, or of what any mesh may take.
double work_with_search(const Surface& surface, double share) {
  const double of_mesh = std::max(work_of(surface), share * double{kLeastEffort});
  return work_of(surface) + kShareOfMesh * of_mesh;
}

}  // namespace

PlacedError largest_error(const Surface& surface, std::span<SuspectLeaf> suspects,
                          std::span<const SearchedPart> others, KnownHulls& hulls,
                          const WholeMeshSearch& how) {
  const double most_work = work_with_search(surface, how.share);
  const auto is_at_limit = [&] { return work_of(surface) > most_work; };
  const WholeMeshError* whole = nullptr;  // made before several threads ask for distances
  const auto distance = [&whole](const SearchedPart& part, const dvec2& uv, const dvec3& position,
                                 double known) {
    return whole->distance({uv, part.triangles, known}, position);
  };
  FeatureSearch features(surface, hulls, distance, how.tolerance, how.clip, how.threads);
  // Features that do not stick out are looked for in a mesh that is off anyway.
  const auto shared = [&how](std::size_t most) {
    return static_cast<std::size_t>(std::ceil(how.share * static_cast<double>(most)));
  };
  const bool is_off = std::ranges::any_of(
      suspects, [&](const SuspectLeaf& leaf) { return leaf.error > how.tolerance; });
  std::vector<SearchedPart> parts =
      features.widest(shared(kMostOpen), is_off ? shared(kMostFollowed) : 0, others.size(),
                      [others](std::size_t k) { return others[k]; });
  if (suspects.empty() && parts.empty()) return {};
  whole = &how.whole();
  std::ranges::stable_sort(suspects, std::ranges::greater(), &SuspectLeaf::error);
  for (const SuspectLeaf& suspect : suspects.first(std::min(shared(kMostOpen), suspects.size()))) {
    parts.push_back(how.part(suspect.leaf));
    parts.back().sticks_out = false;
  }
  auto rest = std::span<const SearchedPart>(parts);
  std::vector<PlacedError> in_parts;
  const auto follow = [&](const auto& may_go_on) {
    while (!rest.empty() && may_go_on()) {
      const auto some = rest.first(std::min(rest.size(), kMostFollowed));
      rest = rest.subspan(some.size());
      std::ranges::copy(features.dive(some), std::back_inserter(in_parts));
    }
    return features.search(may_go_on() ? shared(kMostBoxes) : 0);
  };
  const PlacedError followed =
      follow([&] { return surface.may_go_on() && !(is_off && is_at_limit()); });
  ErrorSearch search(box_of(surface.domain), how.tolerance, *whole, followed);
  search.measure_worst(suspects, how, [&](double worst) {
    return !surface.may_go_on() || (is_at_limit() && worst > how.tolerance);
  });
  if (!surface.may_go_on()) return search.worst();
  search.climb(shared(kMostFollowed));
  for (const SuspectLeaf& suspect : suspects) search.measure_triangles(how.part(suspect.leaf));
  for (const SearchedPart& part : others) search.measure_triangles(part);
  search.climb_on_mesh();
  // A leaf that is off by its own triangles may be near others.
  const bool is_within = !(search.worst().distance > how.tolerance);
  if (is_within && !rest.empty()) search.take(follow([&] { return surface.may_go_on(); }), 1);
  if (followed.distance > how.tolerance) {
    const auto may_go_on = [&] { return surface.may_go_on() && !is_at_limit(); };
    search.take(features.climb_on_lines(parts, in_parts, shared(kMostFollowed), may_go_on), 1);
  }
  return search.worst();
}

}  // namespace saddle
