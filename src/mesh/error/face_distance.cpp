#include "mesh/error/face_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.h"
#include "mesh/features/bisect_together.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// A search ends at a step of less than 0.02 tolerances, or after kHalvingsToNearly steps.
constexpr double kFaceStep = 0.02;
/// The end of a side beyond a pole is taken to be at most 16 times as far from the face as the
/// other end.
constexpr double kSteepest = 16;
/// A line between two sides is looked for up to half of their distance to either side.
constexpr double kBesideCut = 0.5;

/// Whether something within a box may be nearer to a place than a distance.
bool is_nearer_box(const dvec3& low, const dvec3& high, const dvec3& place, double distance) {
  const dvec3 beyond = glm::max(low - place, place - high);
  return std::max({beyond.x, beyond.y, beyond.z}) < distance;
}

}  // namespace

void FaceDistance::for_faces(const auto& act) const {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double limit : {clip_.low[axis], clip_.high[axis]}) {
      if (std::isfinite(limit)) act(Face{axis, limit});
    }
  }
}

/// Calls act(face, cut) for each face that cuts a triangle.
void FaceDistance::for_cuts(const Triangle& t, const auto& act) const {
  Bounds around;
  for (const std::uint32_t corner : t) around.add(grid_.mesh.position[corner]);
  for_faces([&](const Face& face) {
    // Most triangles cross no face.
    if (!(around.low[face.axis] < face.limit && face.limit < around.high[face.axis])) return;
    if (const std::optional<CutSides> cut = sides_of_cut(t, face)) act(face, *cut);
  });
}

void FaceDistance::add(std::size_t leaf, bool is_at_edge, std::span<const Triangle> triangles) {
  for (const Triangle& t : triangles) {
    for_cuts(t, [&](const Face& face, const CutSides& cut) {
      add_cut({leaf, is_at_edge}, t, face, cut);
    });
  }
}

/// The sides of a triangle that cross a face, and where; nothing if there are not two.
std::optional<FaceDistance::CutSides> FaceDistance::sides_of_cut(const Triangle& t,
                                                                 const Face& face) const {
  const auto& position = grid_.mesh.position;
  CutSides cut;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec3& a = position[t[k]];
    const dvec3& b = position[t[(k + 1) % 3]];
    const double from = a[face.axis] - face.limit;
    const double to = b[face.axis] - face.limit;
    if (!(std::min(from, to) < 0 && std::max(from, to) > 0) || count == 2) continue;
    cut.ends[count] = glm::mix(a, b, from / (from - to));
    cut.ends[count][face.axis] = face.limit;
    cut.sides[count++] = k;
  }
  return count == 2 ? std::optional(cut) : std::nullopt;
}

/// Adds the cut of a triangle by a face, if it is not beyond the box's other faces.
void FaceDistance::add_cut(const CutLeaf& leaf, const Triangle& t, const Face& face,
                           const CutSides& found) {
  if (is_beyond(clip_, found.ends)) return;
  const Mesh& mesh = grid_.mesh;
  const ParameterBox around = box_around({mesh.uv[t[0]], mesh.uv[t[1]], mesh.uv[t[2]]});
  Cut cut{leaf.number, face, around.size(), found.ends, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t a = t[found.sides[k]];
    const std::uint32_t b = t[(found.sides[k] + 1) % 3];
    const auto height = [&](std::uint32_t end) {
      return mesh.position[end][face.axis] - face.limit;
    };
    const dvec2& opposite = mesh.uv[t[(found.sides[k] + 2) % 3]];
    // Rounding may put the places of a chord on either sheet beside it.
    const double inward = leaf.is_at_edge ? kNearly : 0;
    const Line line = {glm::mix(mesh.uv[a], opposite, inward),
                       glm::mix(mesh.uv[b], opposite, inward)};
    cut.sides[k] = number_of(crossing_of(line, {height(a), height(b)}, face), leaf.number);
  }
  cuts_.push_back(cut);
}

FaceDistance::Crossing FaceDistance::crossing_of(Line line, std::array<double, 2> heights,
                                                 const Face& face) {
  if (heights[0] > 0) {
    std::swap(line[0], line[1]);
    std::swap(heights[0], heights[1]);
  }
  const double least = std::min(-heights[0], heights[1]);
  heights = {std::max(heights[0], -kSteepest * least), std::min(heights[1], kSteepest * least)};
  return {face, line, heights};
}

/// The number of a side's crossing, which two triangles of a leaf may share.
std::size_t FaceDistance::number_of(const Crossing& crossing, std::size_t leaf) {
  for (std::size_t k = cuts_.size(); k-- > 0 && cuts_[k].leaf == leaf;) {
    for (const std::size_t side : cuts_[k].sides) {
      if (sides_[side].line == crossing.line && sides_[side].face == crossing.face) return side;
    }
  }
  sides_.push_back(crossing);
  return sides_.size() - 1;
}

/// Finds where lines from below faces to above them cross, by the Illinois method.
void FaceDistance::find(std::vector<Crossing>& crossings) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    if (crossings[k].heights[0] < 0 && crossings[k].heights[1] > 0) open.push_back(k);
  }
  const auto place = [](const Crossing& crossing) {
    const auto& [below, above] = crossing.heights;
    return glm::mix(crossing.line[0], crossing.line[1], below / (below - above));
  };
  const auto is_done = [&](Crossing& crossing, const dvec2& uv, const dvec3& position) {
    ++evaluations_;
    const double height = position[crossing.face.axis] - crossing.face.limit;
    const dvec3 before = crossing.position;
    crossing.uv = uv;
    crossing.position = position;
    crossing.position[crossing.face.axis] = crossing.face.limit;
    const std::size_t end = height < 0 ? 0 : 1;
    crossing.line[end] = uv;
    crossing.heights[end] = height;
    if (crossing.last_end == end) crossing.heights[1 - end] /= 2;
    crossing.last_end = end;
    return height == 0 || glm::distance(crossing.position, before) < enough_;
  };
  bisect_together(surface_, crossings, open, {kHalvingsToNearly, threads_}, place, is_done);
}

/// Lines across the middles between the places where the sides of cuts cross faces.
std::vector<FaceDistance::Crossing> FaceDistance::middles() const {
  std::vector<dvec2> uv;
  for (const Cut& cut : cuts_) {
    const dvec2 a = sides_[cut.sides[0]].uv;
    const dvec2 b = sides_[cut.sides[1]].uv;
    const dvec2 along = (b - a) / cut.size;
    const dvec2 aside = kBesideCut * cut.size * dvec2(-along.y, along.x);
    uv.push_back(0.5 * (a + b) - aside);
    uv.push_back(0.5 * (a + b) + aside);
  }
  const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
  std::vector<Crossing> across;
  for (std::size_t k = 0; k < cuts_.size(); ++k) {
    const Face& face = cuts_[k].face;
    const auto height = [&](std::size_t i) { return points[i][face.axis] - face.limit; };
    across.push_back(
        crossing_of({uv[2 * k], uv[2 * k + 1]}, {height(2 * k), height(2 * k + 1)}, face));
  }
  return across;
}

/// The places of the surface's lines that are above the tolerance from the cuts of their own
/// leaves.
std::vector<FaceDistance::FarPlace> FaceDistance::far_from_own_cuts(
    const ValidatedMesh& mesh, const std::vector<Crossing>& across) const {
  std::vector<FarPlace> far;
  for (std::size_t first = 0; first < cuts_.size();) {
    std::size_t last = first;
    while (last < cuts_.size() && cuts_[last].leaf == cuts_[first].leaf) ++last;
    const auto of_leaf = std::span(cuts_).subspan(first, last - first);
    const auto add = [&](const Crossing& crossing, const dvec3& on_cut) {
      if (!is_finite(crossing.position) || !clip_.contains(crossing.position)) return;
      FarPlace place{of_leaf.front().leaf, &crossing, on_cut};
      for (const Cut& cut : of_leaf) {
        if (cut.face == crossing.face) place.move_to_cut(cut.ends);
      }
      move_to_lines(first, last, across, std::span(&place, 1));
      if (place.error() > mesh.allowed[place.leaf]) far.push_back(place);
    };
    for (std::size_t k = first; k < last; ++k) {
      const Cut& cut = cuts_[k];
      for (std::size_t end = 0; end < 2; ++end) add(sides_[cut.sides[end]], cut.ends[end]);
      add(across[k], 0.5 * (cut.ends[0] + cut.ends[1]));
    }
    first = last;
  }
  return far;
}

/// Moves places to cuts of the triangles of leaves that are nearer.
void FaceDistance::move_to_cuts(std::size_t leaves, const TrianglesOf& triangles_of,
                                std::span<FarPlace> places) const {
  if (places.empty()) return;
  const std::vector<FarPlace> before(places.begin(), places.end());
  std::mutex mutex;
  parallel_chunks(leaves, kInBatch, threads_, [&](std::size_t begin, std::size_t end) {
    std::vector<FarPlace> moved = before;
    for (std::size_t k = begin; k < end; ++k) {
      for (const Triangle& t : triangles_of(k)) {
        for_cuts(t, [&](const Face& face, const CutSides& cut) {
          const dvec3 low = glm::min(cut.ends[0], cut.ends[1]);
          const dvec3 high = glm::max(cut.ends[0], cut.ends[1]);
          for (FarPlace& place : moved) {
            if (place.crossing->face != face) continue;
            if (is_nearer_box(low, high, place.crossing->position, place.distance))
              place.move_to_cut(cut.ends);
          }
        });
      }
    }
    const std::scoped_lock lock(mutex);
    for (std::size_t i = 0; i < moved.size(); ++i)
      places[i].distance = std::min(places[i].distance, moved[i].distance);
  });
}

/// Moves places to parts of the surface's lines that are nearer, at a range of cuts.
void FaceDistance::move_to_lines(std::size_t first, std::size_t last,
                                 const std::vector<Crossing>& across,
                                 std::span<FarPlace> places) const {
  for (std::size_t k = first; k < last; ++k) {
    const dvec3& middle = across[k].position;
    if (!is_finite(middle)) continue;
    std::array<dvec3, 3> line = {middle, middle, middle};
    for (std::size_t side = 0; side < 2; ++side) {
      const dvec3& end = sides_[cuts_[k].sides[side]].position;
      if (is_finite(end)) line[2 * side] = end;
    }
    const dvec3 low = glm::min(line[0], glm::min(line[1], line[2]));
    const dvec3 high = glm::max(line[0], glm::max(line[1], line[2]));
    for (FarPlace& place : places) {
      if (place.crossing->face != cuts_[k].face) continue;
      if (!is_nearer_box(low, high, place.on_cut, place.distance_of_cut)) continue;
      place.move_to_line({line[0], line[1]});
      place.move_to_line({line[1], line[2]});
    }
  }
}

void FaceDistance::measure(ValidatedMesh& mesh, std::span<const std::size_t> which,
                           const LeafTriangles& triangles) {
  for (const Cut& cut : cuts_) enough_ = std::min(enough_, kFaceStep * mesh.allowed[cut.leaf]);
  find(sides_);
  std::vector<Crossing> across = middles();
  evaluations_ += 2 * across.size();
  find(across);
  std::vector<FarPlace> far = far_from_own_cuts(mesh, across);
  if (far.empty()) return;
  std::vector<bool> is_newer(mesh.leaves.size(), false);
  for (const std::size_t leaf : which) is_newer[leaf] = true;
  const auto is_far_from_cut = [&](const FarPlace& place) {
    return place.distance > mesh.allowed[place.leaf];
  };
  const auto rest = std::stable_partition(far.begin(), far.end(), is_far_from_cut);
  const std::span<FarPlace> from_cuts(far.begin(), rest);
  move_to_cuts(
      which.size(), [&](std::size_t i) { return triangles.of(i); }, from_cuts);
  const auto of_older = [&](std::size_t k) {
    return is_newer[k] ? std::span<const Triangle>() : mesh.triangles.of(k);
  };
  move_to_cuts(mesh.triangles.ranges.size(), of_older, from_cuts);
  parallel_chunks(far.size(), kSearchedTogether, threads_, [&](std::size_t begin, std::size_t end) {
    move_to_lines(0, cuts_.size(), across, std::span(far).subspan(begin, end - begin));
  });
  for (const FarPlace& place : far) mesh.add(place.leaf, place.error(), place.crossing->uv);
}

}  // namespace saddle
