#include "mesh/proof/feature_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "base/numbers.h"
#include "base/parallel.h"
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
  std::vector<SearchedPart> some;
  std::vector<ParameterBox> boxes;
  for (std::size_t first = 0; first < count; first += some.size()) {
    some.clear();
    boxes.clear();
    for (std::size_t k = first; k < std::min(first + kInBatch, count); ++k) {
      some.push_back(part(k));
      boxes.push_back(some.back().box);
    }
    const std::vector<Bounds> hulls = hulls_.over(boxes, threads_);
    for (std::size_t i = 0; i < some.size(); ++i) {
      const double room = some[i].scale * room_beyond(some[i].around, hulls[i]);
      const double length = some[i].scale * hulls[i].diagonal();
      room > least_ ? wide.add(-room, first + i) : within.add(-length, first + i);
    }
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
double FeatureSearch::bound_over(const SearchedPart& part, const ParameterBox& box,
                                 SurfaceEnclosure& enclosure) const {
  const std::span<const Interval> of = enclosure.enclose(box);
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

std::vector<std::array<FeatureSearch::Node, 2>> FeatureSearch::halves_of_each(
    std::span<const Node> nodes) {
  std::vector<std::array<Node, 2>> halves(nodes.size());
  enclosures_.in_chunks(nodes.size(), kFirstSearched, threads_,
                        [&](SurfaceEnclosure& enclosure, std::size_t begin, std::size_t end) {
                          for (std::size_t k = begin; k < end; ++k) {
                            const Node& node = nodes[k];
                            const auto boxes = halves_of(node.box, node.depth % 2);
                            for (std::size_t i = 0; i < 2; ++i)
                              halves[k][i] = {node.part, boxes[i], node.depth + 1,
                                              bound_over(*node.part, boxes[i], enclosure)};
                          }
                        });
  return halves;
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
  parallel_chunks(points.size(), kFirstSearched, threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Sample& sample = samples[k];
      const dvec3& p = points[k];
      if (!is_seen(clip_, p)) continue;
      const double known = sample.known / sample.part->scale;
      result[k] = sample.part->scale * distance_(*sample.part, sample.uv, p, known);
    }
  });
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
  std::unique_ptr<SurfaceEnclosure> enclosure = enclosures_.take();
  for (const SearchedPart& part : parts)
    nodes.push_back({&part, part.box, 0, bound_over(part, part.box, *enclosure)});
  enclosures_.give_back(std::move(enclosure));
  for (int depth = 0; depth < 2 * kHalvingsToNearly && surface_.may_go_on(); ++depth) {
    std::vector<std::size_t> active;
    std::vector<Node> halved;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (!(nodes[k].bound > kMatters * std::max(least_, found[k].distance))) continue;
      active.push_back(k);
      halved.push_back(nodes[k]);
    }
    const auto halves = halves_of_each(halved);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < active.size(); ++i) {
      const auto& [first, second] = halves[i];
      const bool is_second = second.bound > first.bound;
      Node& node = nodes[active[i]];
      node = is_second ? second : first;
      keep(is_second ? first : second);
      samples.push_back(
          {node.part, sample_of(node.box), std::max(least_, found[active[i]].distance)});
    }
    if (active.empty()) break;
    take_larger(samples, active, found);
  }
  return found;
}

/// Measures samples, and keeps the larger distances: `numbers` of the samples among `found`.
void FeatureSearch::take_larger(std::span<const Sample> samples,
                                std::span<const std::size_t> numbers,
                                std::span<PlacedError> found) {
  const std::vector<double> distances = measure(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    PlacedError& of = found[numbers[i]];
    if (!(distances[i] > of.distance)) continue;
    of = {distances[i], samples[i].uv};
    if (of.distance > worst_.distance) worst_ = of;
  }
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
    std::vector<Node> some;
    while (some.size() < kSearchedTogether && !open_.empty()) {
      std::ranges::pop_heap(open_, std::ranges::less(), &Node::bound);
      const Node node = open_.back();
      open_.pop_back();
      if (!(node.bound > limit())) {
        open_.clear();
        break;
      }
      some.push_back(node);
    }
    tested += 2 * some.size();
    std::vector<Sample> samples;
    std::vector<Node> next;
    for (const auto& halves : halves_of_each(some)) {
      for (const Node& half : halves) {
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
