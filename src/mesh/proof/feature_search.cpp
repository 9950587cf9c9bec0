#include "mesh/proof/feature_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "base/numbers.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// The sample of a box, in shares of its sides: at dyadic places formulas have values of their own.
const dvec2 kSample(0.5129, 0.4733);

dvec2 sample_of(const ParameterBox& box) {
  return glm::mix(box.low, box.high, kSample);
}

/// The first of many ranked numbers.
class FirstRanked {
 public:
  explicit FirstRanked(std::size_t count) : count_(count) {}

  void add(double rank, std::size_t number) {
    if (count_ == 0) return;
    ranked_.emplace_back(rank, number);
    if (ranked_.size() == 2 * count_) drop_others();
  }
  std::vector<std::pair<double, std::size_t>> sorted() {
    drop_others();
    std::ranges::sort(ranked_);
    return std::move(ranked_);
  }

 private:
  void drop_others() {
    if (ranked_.size() <= count_) return;
    const auto end = ranked_.begin() + static_cast<std::ptrdiff_t>(count_);
    std::ranges::nth_element(ranked_, end);
    ranked_.erase(end, ranked_.end());
  }

  std::size_t count_;
  std::vector<std::pair<double, std::size_t>> ranked_;
};

}  // namespace

std::vector<SearchedPart> FeatureSearch::widest(
    std::size_t most, std::size_t others, std::size_t count,
    const std::function<SearchedPart(std::size_t)>& part) {
  FirstRanked wide(most);
  FirstRanked within(others);
  for (std::size_t k = 0; k < count; ++k) {
    const SearchedPart of = part(k);
    const Bounds hull = hulls_.over(of.box);
    const double room = of.scale * room_beyond(of.around, hull);
    const double length = of.scale * hull.diagonal();
    room > least_ ? wide.add(-room, k) : within.add(-length, k);
  }
  std::vector<SearchedPart> kept;
  for (const auto& [room, k] : wide.sorted()) kept.push_back(part(k));
  for (const auto& [length, k] : within.sorted()) {
    kept.push_back(part(k));
    kept.back().sticks_out = false;
  }
  return kept;
}

double FeatureSearch::limit() const {
  return kMatters * std::max(least_, worst_.distance);
}

/// The surface over a box is within half of the diagonal of its bounds from their middle.
double FeatureSearch::bound_over(const SearchedPart& part, const ParameterBox& box) {
  const std::span<const Interval> of = enclosure_.enclose(box);
  const Bounds hull = hull_of(of);
  const double room = part.scale * room_beyond(part.around, hull);
  if (part.sticks_out && room <= least_) return 0;
  if (least_defined(of) == Defined::No) return 0;
  if (clip_ && is_beyond(*clip_, std::array{hull.low, hull.high})) return 0;
  const double radius = 0.5 * hull.diagonal();
  if (!std::isfinite(radius)) return kInfinity;
  // Among many sheets an exact distance takes a visit of most.
  const double known = std::max(limit() / part.scale - radius, kFarApart * hull.diagonal());
  return part.scale * (distance_(part, box.middle(), hull.centre(), known) + radius);
}

std::array<FeatureSearch::Node, 2> FeatureSearch::halves(const Node& node) {
  const auto boxes = halves_of(node.box, node.depth % 2);
  const auto half = [&](const ParameterBox& box) {
    return Node{node.part, box, node.depth + 1, bound_over(*node.part, box)};
  };
  return {half(boxes[0]), half(boxes[1])};
}

void FeatureSearch::keep(const Node& node) {
  if (!(node.bound > limit()) || node.depth >= 2 * kHalvingsToNearly) return;
  open_.push_back(node);
  std::ranges::push_heap(open_, std::ranges::less(), &Node::bound);
}

std::vector<double> FeatureSearch::distances_of(std::span<const Sample> samples) const {
  std::vector<dvec2> uv(samples.size());
  std::ranges::transform(samples, uv.begin(), &Sample::uv);
  const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
  std::vector<double> result(samples.size(), 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Sample& sample = samples[k];
    const dvec3& p = points[k];
    if (!is_seen(clip_, p)) continue;
    const double known = sample.known / sample.part->scale;
    result[k] = sample.part->scale * distance_(*sample.part, sample.uv, p, known);
  }
  return result;
}

/// On a line the surface may have a value of its own, as sign(u) has at 0: the smaller distance of
/// a sample and of a place beside it counts.
std::vector<double> FeatureSearch::measure(std::span<const Sample> samples) const {
  std::vector<double> result = distances_of(samples);
  std::vector<std::size_t> farther;  // numbers of samples
  std::vector<Sample> beside;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!(result[k] > samples[k].known)) continue;
    farther.push_back(k);
    beside.push_back(samples[k]);
    beside.back().uv = glm::mix(samples[k].uv, samples[k].part->box.middle(), kNearly);
  }
  const std::vector<double> found = distances_of(beside);
  for (std::size_t i = 0; i < farther.size(); ++i)
    result[farther[i]] = std::min(result[farther[i]], found[i]);
  return result;
}

std::vector<PlacedError> FeatureSearch::dive(std::span<const SearchedPart> parts) {
  std::vector<PlacedError> found(parts.size());
  std::vector<Node> nodes;
  for (const SearchedPart& part : parts)
    nodes.push_back({&part, part.box, 0, bound_over(part, part.box)});
  for (int depth = 0; depth < 2 * kHalvingsToNearly && surface_.may_go_on(); ++depth) {
    std::vector<std::size_t> active;
    std::vector<Sample> samples;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const double known = std::max(least_, found[k].distance);
      if (!(nodes[k].bound > kMatters * known)) continue;
      const auto [first, second] = halves(nodes[k]);
      const bool is_second = second.bound > first.bound;
      nodes[k] = is_second ? second : first;
      keep(is_second ? first : second);
      active.push_back(k);
      samples.push_back({nodes[k].part, sample_of(nodes[k].box), known});
    }
    if (active.empty()) break;
    const std::vector<double> distances = measure(samples);
    for (std::size_t i = 0; i < active.size(); ++i) {
      PlacedError& of = found[active[i]];
      if (!(distances[i] > of.distance)) continue;
      of = {distances[i], samples[i].uv};
      if (of.distance > worst_.distance) worst_ = of;
    }
  }
  return found;
}

PlacedError FeatureSearch::climb_on_lines(std::span<const SearchedPart> parts,
                                          std::span<const PlacedError> found, std::size_t most,
                                          const std::function<bool()>& may_go_on) {
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [found](std::size_t k) { return found[k].distance; });
  order.resize(std::min(order.size(), most));
  std::erase_if(order, [found](std::size_t k) { return !(found[k].distance > 0); });
  for (auto rest = std::span<const std::size_t>(order); !rest.empty();) {
    std::vector<Climb> climbs;
    const auto some = rest.first(std::min(rest.size(), kFirstSearched));
    rest = rest.subspan(some.size());
    for (const std::size_t k : some) {
      const dvec2 step = kClose * parts[k].box.size();
      for (const int axis : {0, 1}) climbs.push_back({&parts[k], axis, found[k], step[axis]});
    }
    climb(climbs, may_go_on);
  }
  return worst_;
}

void FeatureSearch::climb(std::span<Climb> climbs, const std::function<bool()>& may_go_on) {
  const ParameterBox domain = box_of(surface_.domain);
  for (int round = 0; round < kHalvingsToNearly && may_go_on(); ++round) {
    std::vector<SearchedPart> lines;
    for (const Climb& climb : climbs) {
      for (const double way : {-climb.step, climb.step}) {
        lines.push_back(*climb.part);
        lines.back().sticks_out = false;
        dvec2 reach = climb.part->box.size();
        dvec2 middle = climb.best.uv;
        middle[climb.axis] += way;
        reach[climb.axis] = 0;
        lines.back().box = {nearest_in(domain, middle - reach), nearest_in(domain, middle + reach)};
      }
    }
    const std::vector<PlacedError> on_lines = dive(lines);
    open_.clear();
    for (std::size_t k = 0; k < climbs.size(); ++k) {
      Climb& climb = climbs[k];
      const double before = climb.best.distance;
      for (const PlacedError& on_line : std::span(on_lines).subspan(2 * k, 2)) {
        if (on_line.distance > climb.best.distance) climb.best = on_line;
      }
      climb.step *= climb.best.distance > before ? 2 : 0.5;
    }
  }
}

PlacedError FeatureSearch::search(std::size_t boxes) {
  for (std::size_t tested = 0; tested < boxes && !open_.empty();) {
    std::vector<Sample> samples;
    std::vector<Node> next;
    while (samples.size() < kSearchedTogether && !open_.empty()) {
      std::ranges::pop_heap(open_, std::ranges::less(), &Node::bound);
      const Node node = open_.back();
      open_.pop_back();
      if (!(node.bound > limit())) {
        open_.clear();
        break;
      }
      tested += 2;
      for (const Node& half : halves(node)) {
        if (!(half.bound > limit())) continue;
        next.push_back(half);
        samples.push_back({half.part, sample_of(half.box), std::max(least_, worst_.distance)});
      }
    }
    const std::vector<double> distances = measure(samples);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (distances[k] > worst_.distance) worst_ = {distances[k], samples[k].uv};
    }
    for (const Node& node : next) keep(node);
  }
  return worst_;
}

}  // namespace saddle
