#include "mesh/curve/curve_mesher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "eval/enclose.h"
#include "mesh/curve/between.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// First chords. A part of the curve that is shorter in s, and that no bound finds, is missed.
constexpr int kFirstChords = 128;
/// Halvings of a chord both of whose ends are undefined: a part between them that is defined.
constexpr int kBlindHalvings = 3;
/// Samples keep this share of the tolerance, so that bounds can prove the whole of it.
constexpr double kSampled = 0.75;
/// A chord of which one step between samples takes more than this share may be a jump.
constexpr double kMostStep = 0.8;
/// Radians between the tangents at the ends of a part of a tube: normals between are a blend.
constexpr double kMostTurn = 0.35;
/// Cut ends that are so many times as far away as most of the first samples are beside a pole.
constexpr double kFar = 1e6;
/// Squares of larger coordinates come near to the range of doubles: nothing is there.
constexpr double kHuge = 1e100;
/// Boxes of a proof for each chord, and at least.
constexpr std::size_t kBoxesPerChord = 32;
constexpr std::size_t kLeastBoxes = 10'000;

double distance_to_chord(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 way = b - a;
  const double square = glm::dot(way, way);
  const double share = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
  return glm::length(p - (a + share * way));
}

/// The angle between two tangents; 0 where one has no direction.
double turn(const dvec3& a, const dvec3& b) {
  const double lengths = glm::length(a) * glm::length(b);
  if (!(lengths > 0) || !std::isfinite(lengths)) return 0;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// A point with what is known of the way to the next one.
struct Node {
  CurvePoint point;
  bool there = false;  ///< defined, and in the clip box
  bool open = true;    ///< the chord to the next node is not good yet
  bool cut = false;    ///< there is no chord
  bool known = false;  ///< a place was found that is too far from the chord
  int halvings = 0;
  double error = 0;  ///< of the chord
};

class CurveMesher {
 public:
  CurveMesher(const ParametricCurve& curve, const CurveRequest& request)
      : curve_(curve),
        request_(request),
        low_(std::min(curve.from, curve.to)),
        high_(std::max(curve.from, curve.to)) {}

  CurveMesh run() {
    start();
    do {
      while (halve_open_chords()) {
      }
    } while (search_by_bounds());
    take_cuts();
    make_chains();
    return std::move(result_);
  }

 private:
  std::vector<CurvePoint> sample(const std::vector<double>& s) {
    result_.evaluations += s.size();
    return evaluate(curve_, s);
  }

  bool is_there(const CurvePoint& p) const {
    const dvec3 size = glm::abs(p.position);
    return size.x < kHuge && size.y < kHuge && size.z < kHuge &&
           (!request_.clip || request_.clip->contains(p.position));
  }

  double tolerance(const dvec3& a, const dvec3& b) {
    const double least = request_.tolerance(0.5 * (a + b), 0.5 * glm::length(b - a));
    result_.tolerance = result_.tolerance > 0 ? std::min(result_.tolerance, least) : least;
    return least;
  }

  void start() {
    std::vector<double> s;
    for (int i = 0; i <= kFirstChords; ++i) {
      const double share = static_cast<double>(i) / kFirstChords;
      s.push_back(low_ * (1 - share) + high_ * share);
    }
    std::vector<double> sizes;
    for (const CurvePoint& p : sample(s)) {
      nodes_.push_back({p, is_there(p)});
      if (nodes_.back().there) sizes.push_back(glm::length(p.position));
    }
    nodes_.back().open = false;
    if (sizes.empty()) return;
    const auto most = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 3 / 4);
    std::ranges::nth_element(sizes, most);
    size_ = *most;
  }

  /// Returns false if no chord was open.
  bool halve_open_chords() {
    std::vector<double> s;
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (!nodes_[i].open) continue;
      const double a = nodes_[i].point.s;
      const double b = nodes_[i + 1].point.s;
      // Uneven, so that no period keeps step with them.
      for (const double share : {0.29, 0.5, 0.77}) {
        s.push_back(between(a, b, share, nodes_[i].halvings));
      }
    }
    if (s.empty()) return false;
    if (nodes_.size() + s.size() / 3 > request_.max_points) {
      result_.reached_limit = true;
      for (Node& node : nodes_) node.open = false;
      return false;
    }
    const std::vector<CurvePoint> samples = sample(s);
    std::vector<Node> next;
    next.reserve(nodes_.size() + s.size() / 3);
    std::size_t k = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      next.push_back(nodes_[i]);
      if (!nodes_[i].open) continue;
      const std::span<const CurvePoint> inner(&samples[k], 3);
      k += 3;
      Node& node = next.back();
      node.open = !is_good(node, nodes_[i + 1], inner) || std::exchange(node.known, false);
      const double middle = inner[1].s;
      if (!node.open) continue;
      if (middle == node.point.s || middle == nodes_[i + 1].point.s) {
        node.open = false;  // the last doubles
        continue;
      }
      ++node.halvings;
      Node half{inner[1], is_there(inner[1])};
      half.halvings = node.halvings;
      next.push_back(half);
    }
    nodes_ = std::move(next);
    return true;
  }

  bool is_good(Node& node, const Node& end, std::span<const CurvePoint> inner) {
    const auto there = std::ranges::count_if(inner, [this](const auto& p) { return is_there(p); });
    if (!node.there && !end.there && there == 0) return node.halvings >= kBlindHalvings;
    if (!node.there || !end.there || there < 3) return false;
    const dvec3& a = node.point.position;
    const dvec3& b = end.point.position;
    node.error = 0;
    double longest = 0;  // step from sample to sample
    dvec3 last = a;
    for (const CurvePoint& p : inner) {
      node.error = std::max(node.error, distance_to_chord(p.position, a, b));
      longest = std::max(longest, glm::length(p.position - last));
      last = p.position;
    }
    longest = std::max(longest, glm::length(b - last));
    if (longest > std::max(kMostStep * glm::length(b - a), tolerance(a, b))) return false;
    double error = node.error;
    if (request_.radius > 0) {
      const double angle = std::max(turn(node.point.tangent, inner[1].tangent),
                                    turn(inner[1].tangent, end.point.tangent));
      // A corner is where the way ends while the tangent still turns: the tube has a joint there.
      const bool is_corner = glm::length(b - a) <= kSame * request_.radius;
      if (!is_corner && 2 * angle > kMostTurn) return false;
      // The outside of a bend by 2 angle, a circle's arc.
      if (!is_corner) error += request_.radius * (1 - std::cos(angle));
    }
    return error <= kSampled * tolerance(a, b);
  }

  /// A part of a chord's range of s.
  struct Part {
    std::size_t node;
    CurvePoint from, to;
    double off = 0;  ///< the larger distance of its ends from the chord
  };

  /// Proves the tolerance over all of the chords, or opens those where it finds the curve farther
  /// away. Returns whether there are any.
  bool search_by_bounds() {
    if (result_.reached_limit) return false;
    Enclosure enclosure(curve_.bounds);
    std::vector<Part> parts;
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (nodes_[i].there && nodes_[i + 1].there) {
        parts.push_back({i, nodes_[i].point, nodes_[i + 1].point, 0});
      }
    }
    std::size_t budget = std::max(kLeastBoxes, kBoxesPerChord * parts.size());
    double proved = 0;
    bool found = false;
    while (!parts.empty() && budget >= parts.size()) {
      budget -= parts.size();
      std::erase_if(parts, [&](const Part& part) {
        const bool is_proved = this->is_proved(part, enclosure);
        if (is_proved) proved += part.to.s - part.from.s;
        return is_proved || nodes_[part.node].open;
      });
      parts = halves(parts);
      found = found || std::ranges::any_of(nodes_, &Node::open);
    }
    result_.proved_fraction = proved / (high_ - low_);
    return found;
  }

  bool is_proved(const Part& part, Enclosure& enclosure) {
    std::array<Interval, 6> bounds{};
    enclosure({part.from.s, part.to.s}, {0, 0}, bounds);
    dvec3 spread(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval& r = bounds[k];
      const Interval& slope = bounds[k + 3];
      if (r.defined != Defined::Yes || !r.continuous || slope.defined != Defined::Yes) return false;
      spread[static_cast<int>(k)] = slope.high - slope.low;
    }
    const double bend = glm::length(spread) * (part.to.s - part.from.s) / 4;
    const Node& node = nodes_[part.node];
    return part.off + bend <= tolerance(node.point.position, nodes_[part.node + 1].point.position);
  }

  /// Both halves of each part; opens the chords that a middle is too far from.
  std::vector<Part> halves(const std::vector<Part>& parts) {
    std::vector<double> s(parts.size());
    std::ranges::transform(parts, s.begin(),
                           [](const Part& part) { return std::midpoint(part.from.s, part.to.s); });
    const std::vector<CurvePoint> middles = sample(s);
    std::vector<Part> result;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Part& part = parts[i];
      if (s[i] <= part.from.s || s[i] >= part.to.s) continue;
      Node& node = nodes_[part.node];
      const dvec3& a = node.point.position;
      const dvec3& b = nodes_[part.node + 1].point.position;
      const double off = distance_to_chord(middles[i].position, a, b);
      if (!is_there(middles[i]) || off > tolerance(a, b)) node.open = node.known = true;
      if (node.open) continue;
      result.push_back({part.node, part.from, middles[i], std::max(part.off, off)});
      result.push_back({part.node, middles[i], part.to, std::max(part.off, off)});
    }
    return result;
  }

  bool is_pole(const CurvePoint& p) const {
    const dvec3& at = p.position;
    const bool infinite = std::isinf(at.x) || std::isinf(at.y) || std::isinf(at.z);
    return infinite || glm::length(at) > kFar * size_;
  }

  /// Finds out where chords are none, and why.
  void take_cuts() {
    double undefined = 0;
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (!nodes_[i].there) continue;
      std::size_t next = i + 1;
      while (next < nodes_.size() && !nodes_[next].there) ++next;
      if (next == nodes_.size()) break;
      take_gap(i, next);
    }
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      const bool ends_here = nodes_[i].there != nodes_[i + 1].there;
      const CurvePoint& in = nodes_[nodes_[i].there ? i : i + 1].point;
      const CurvePoint& out = nodes_[nodes_[i].there ? i + 1 : i].point;
      if (ends_here && (is_pole(in) || is_pole(out))) add(out.s, result_.poles);
      const bool both_undefined =
          !is_finite(nodes_[i].point.position) && !is_finite(nodes_[i + 1].point.position);
      if (both_undefined) undefined += nodes_[i + 1].point.s - nodes_[i].point.s;
    }
    result_.undefined_fraction = undefined / (high_ - low_);
  }

  /// Two neighbours that are there, or have nothing but nodes between that are not.
  void take_gap(std::size_t from, std::size_t to) {
    const CurvePoint& a = nodes_[from].point;
    const CurvePoint& b = nodes_[to].point;
    const double gap = glm::length(b.position - a.position);
    const bool is_narrow = b.s - a.s <= kSame * (high_ - low_);
    const bool is_last = to == from + 1 && std::nextafter(a.s, b.s) == b.s;
    const bool agrees = gap <= tolerance(a.position, b.position);
    if (to == from + 1 && (!is_last || agrees)) return;
    if (is_narrow && agrees) {  // a point without a value, at which the curve has a limit
      nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                   nodes_.begin() + static_cast<std::ptrdiff_t>(to));
      return;
    }
    nodes_[from].cut = true;
    if (!is_narrow) return;
    if (is_pole(a) || is_pole(b)) {
      add(b.s, result_.poles);
    } else {
      add(b.s, result_.jumps);
    }
  }

  /// Each place once: both sides of a cut may name it.
  void add(double s, std::vector<double>& places) const {
    if (std::fabs(s) <= kRounding * (high_ - low_)) s = 0;  // a cut beside 0
    if (!places.empty() && s - places.back() <= kSame * (high_ - low_)) return;
    places.push_back(s);
  }

  void make_chains() {
    CurveChain chain;
    const auto end_chain = [&] {
      if (chain.size() > 1) result_.chains.push_back(std::move(chain));
      chain.clear();
    };
    for (const Node& node : nodes_) {
      if (node.there) {
        // The halvings beside a cut leave points that are nearer than anything shows.
        const bool is_near = chain.size() > 1 && is_within(chain.back(), node.point) &&
                             turn(chain.back().tangent, node.point.tangent) < kMostTurn;
        if (is_near) chain.pop_back();
        chain.push_back(node.point);
        if (!node.cut) result_.max_error = std::max(result_.max_error, node.error);
      }
      if (!node.there || node.cut) end_chain();
    }
    end_chain();
    std::ranges::sort(result_.poles);
    if (curve_.from > curve_.to) turn_round();
    for (const CurveChain& each : result_.chains) {
      for (std::size_t i = 0; i < each.size(); ++i) {
        result_.bounds.add(each[i].position);
        if (i > 0) result_.length += glm::length(each[i].position - each[i - 1].position);
      }
    }
    result_.closed = is_closed();
  }

  bool is_within(const CurvePoint& a, const CurvePoint& b) {
    return glm::length(b.position - a.position) <= kNearly * tolerance(a.position, b.position);
  }

  /// A range that runs backwards begins at its larger end.
  void turn_round() {
    std::ranges::reverse(result_.chains);
    for (CurveChain& chain : result_.chains) {
      std::ranges::reverse(chain);
      for (CurvePoint& p : chain) p.tangent = -p.tangent;
    }
  }

  bool is_closed() const {
    if (result_.chains.size() != 1) return false;
    const CurvePoint& first = result_.chains[0].front();
    const CurvePoint& last = result_.chains[0].back();
    return first.s == curve_.from && last.s == curve_.to &&
           glm::length(first.position - last.position) <= kSame * result_.bounds.diagonal();
  }

  const ParametricCurve& curve_;
  const CurveRequest& request_;
  double low_, high_;
  double size_ = 0;  ///< three quarters of the first samples are no farther from the origin
  std::vector<Node> nodes_;
  CurveMesh result_;
};

}  // namespace

CurveMesh mesh_curve(const ParametricCurve& curve, const CurveRequest& request) {
  return CurveMesher(curve, request).run();
}

}  // namespace saddle
