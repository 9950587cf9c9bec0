#include "mesh/solid/thicken.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "mesh/solid/fans.h"
#include "mesh/solid/joined_sides.h"

namespace saddle {
namespace {

/// Walls that meet at a smaller angle are shaded as one: cosine of half of 40 degrees. A circle
/// cut into chords, nine or more, is round.
constexpr double kRoundCosine = 0.93969;

class Thickener {
 public:
  Thickener(const Mesh& sheet, const JoinedSides& joined, const Thickening& thickening)
      : sheet_(sheet), thickening_(thickening), joined_(joined), fans_(fans_of(sheet, joined)) {}

  Mesh run() {
    if (fans_.one_sided && thickening_.front != thickening_.back) {
      throw Error(Status::Input,
                  "the surface is one-sided: it has no front or back that all of its thickness "
                  "could be on");
    }
    give_corners_fans();
    make_room();
    add_sides();
    add_walls();
    add_lines();
    add_contours();
    for (const dvec3& p : solid_.position) solid_.bounds.add(p);
    solid_.point_count = 2 * static_cast<std::uint32_t>(fans_.point.size());
    solid_.color_range = sheet_.color_range;
    solid_.anchor = sheet_.anchor;
    return std::move(solid_);
  }

 private:
  /// A corner of the sheet as it is in one fan, on one side of it.
  struct Place {
    std::uint32_t corner;
    std::uint32_t fan;
    bool turned;
    auto operator<=>(const Place&) const = default;
  };

  std::uint32_t corner_of(std::uint32_t k) const { return sheet_.triangles[k / 3][k % 3]; }
  Place place_of(std::uint32_t k) const {
    return {corner_of(k), fans_.of[k], fans_.turned[k] != 0};
  }

  /// A corner of the sheet is one of each side, unless triangles of several fans share it.
  void give_corners_fans() {
    const std::size_t count = sheet_.position.size();
    places_.assign(count, {kNoIndex, kNoIndex, false});
    slot_.resize(3 * sheet_.triangles.size());
    std::map<Place, std::uint32_t> further;
    for (std::uint32_t k = 0; k < slot_.size(); ++k) {
      const Place place = place_of(k);
      if (places_[place.corner].corner == kNoIndex) places_[place.corner] = place;
      slot_[k] = place.corner;
      if (places_[place.corner] == place) continue;
      const auto [known, is_new] =
          further.try_emplace(place, static_cast<std::uint32_t>(places_.size()));
      if (is_new) places_.push_back(place);
      slot_[k] = known->second;
    }
    keep_used_places();
  }

  /// Numbers the places of corners that triangles use.
  void keep_used_places() {
    number_.resize(places_.size());
    std::iota(number_.begin(), number_.end(), 0U);
    const auto is_unused = [](const Place& place) { return place.corner == kNoIndex; };
    if (std::ranges::none_of(places_, is_unused)) return;
    std::ranges::fill(number_, kNoIndex);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].corner == kNoIndex) continue;
      number_[i] = count;
      places_[count++] = places_[i];
    }
    places_.resize(count);
    for (std::uint32_t& slot : slot_) slot = number_[slot];
  }

  /// The point number and the position of a place in front of the triangle, or behind it.
  std::uint32_t point_at(const Place& place, bool behind) const {
    return 2 * place.fan + (behind != place.turned ? 1 : 0);
  }
  dvec3 position_at(const Place& place, bool behind) const {
    const dvec3& p = sheet_.position[place.corner];
    const dvec3& d = fans_.direction[place.fan];
    return behind != place.turned ? p - thickening_.back * d : p + thickening_.front * d;
  }

  void set_corner(std::size_t corner, const Place& place, bool behind, const dvec3& normal) {
    solid_.position[corner] = position_at(place, behind);
    solid_.normal[corner] = normal;
    solid_.uv[corner] = sheet_.uv[place.corner];
    solid_.point[corner] = point_at(place, behind);
    if (!sheet_.color.empty()) solid_.color[corner] = sheet_.color[place.corner];
  }

  /// The corners of the front, those of the back, then four for each wall.
  void make_room() {
    borders_ = static_cast<std::size_t>(std::ranges::count(joined_.across, kNoIndex));
    const std::size_t corners = 2 * places_.size() + 4 * borders_;
    solid_.position.resize(corners);
    solid_.normal.resize(corners);
    solid_.uv.resize(corners);
    solid_.point.resize(corners);
    if (!sheet_.color.empty()) solid_.color.resize(corners);
    const std::size_t triangles = sheet_.triangles.size();
    solid_.triangles.resize(2 * (triangles + borders_));
    solid_.solid = {triangles, triangles, 2 * borders_};
  }

  void add_sides() {
    const std::size_t back = places_.size();
    for (std::size_t i = 0; i < back; ++i) {
      const dvec3& normal = sheet_.normal[places_[i].corner];
      set_corner(i, places_[i], false, normal);
      set_corner(back + i, places_[i], true, -normal);
    }
    const auto shift = static_cast<std::uint32_t>(back);
    const std::size_t triangles = sheet_.triangles.size();
    for (std::size_t t = 0; t < triangles; ++t) {
      const auto [a, b, c] = Triangle{slot_[3 * t], slot_[3 * t + 1], slot_[3 * t + 2]};
      solid_.triangles[t] = {a, b, c};
      solid_.triangles[triangles + t] = {a + shift, c + shift, b + shift};
    }
  }

  /// Out of the surface, at right angles to a side on a border: a unit vector, or 0.
  dvec3 outward(std::uint32_t side) const {
    const std::uint32_t a = corner_of(side);
    const std::uint32_t b = corner_of(next(side));
    const dvec3 out =
        glm::cross(sheet_.position[b] - sheet_.position[a], sheet_.normal[a] + sheet_.normal[b]);
    const double length = glm::length(out);
    return length > 0 ? out / length : dvec3(0);
  }
  static std::uint32_t next(std::uint32_t k) { return k % 3 == 2 ? k - 2 : k + 1; }

  /// Two walls meet at a fan on a border: where they do so smoothly, they share the normal.
  void add_walls() {
    if (borders_ == 0) return;
    std::map<std::uint32_t, dvec3> sums;  // of the walls that meet at a fan
    std::vector<std::uint32_t> borders;
    for (std::uint32_t side = 0; side < joined_.across.size(); ++side) {
      if (joined_.across[side] != kNoIndex) continue;
      borders.push_back(side);
      for (const std::uint32_t k : {side, next(side)}) {
        sums.try_emplace(fans_.of[k], 0).first->second += outward(side);
      }
    }
    auto corner = static_cast<std::uint32_t>(2 * places_.size());
    std::size_t triangle = 2 * sheet_.triangles.size();
    for (const std::uint32_t side : borders) {
      const std::uint32_t first = corner;
      const dvec3 own = outward(side);
      for (const std::uint32_t k : {side, next(side)}) {
        const dvec3& sum = sums.at(fans_.of[k]);
        const bool is_round = glm::dot(sum, own) > kRoundCosine * glm::length(sum);
        const dvec3 normal = is_round ? glm::normalize(sum) : own;
        for (const bool behind : {false, true}) set_corner(corner++, place_of(k), behind, normal);
      }
      // The first corner in front and behind, then the second one.
      solid_.triangles[triangle++] = {first + 2, first, first + 1};
      solid_.triangles[triangle++] = {first + 2, first + 1, first + 3};
    }
  }

  /// Each chain on both sides.
  void add_lines() {
    for (const std::uint32_t shift : {0U, static_cast<std::uint32_t>(places_.size())}) {
      for (const std::vector<std::uint32_t>& line : sheet_.lines) {
        std::vector<std::uint32_t> chain;
        for (const std::uint32_t corner : line) {
          if (number_[corner] != kNoIndex) chain.push_back(number_[corner] + shift);
        }
        solid_.lines.push_back(std::move(chain));
      }
    }
  }

  void add_contours() {
    const MeshContours& sheet = sheet_.contours;
    const auto count = static_cast<std::uint32_t>(sheet.position.size());
    MeshContours& both = solid_.contours;
    for (const double way : {thickening_.front, -thickening_.back}) {
      for (std::uint32_t i = 0; i < count; ++i) {
        both.position.push_back(sheet.position[i] + way * sheet.normal[i]);
        both.on_mesh.push_back(sheet.on_mesh[i] + way * sheet.normal[i]);
        both.normal.push_back(way < 0 ? -sheet.normal[i] : sheet.normal[i]);
      }
    }
    for (const std::uint32_t shift : {0U, count}) {
      for (std::vector<std::uint32_t> line : sheet.lines) {
        for (std::uint32_t& vertex : line) vertex += shift;
        both.lines.push_back(std::move(line));
      }
    }
  }

  const Mesh& sheet_;
  const Thickening& thickening_;
  const JoinedSides& joined_;
  Fans fans_;
  Array<Place> places_;          // each a corner in front and one behind
  Array<std::uint32_t> slot_;    // of the corners of triangles, in places_
  Array<std::uint32_t> number_;  // of the sheet's corners, in places_
  std::size_t borders_ = 0;      // sides on borders
  Mesh solid_;
};

}  // namespace

Mesh thicken(const Mesh& sheet, const Thickening& thickening) {
  if (has_flat_triangles(sheet)) return thicken(without_flat_triangles(sheet), thickening);
  const JoinedSides joined = join_sides(sheet);
  if (!joined.doubled.empty()) return thicken(with_single_edges(sheet, joined), thickening);
  return Thickener(sheet, joined, thickening).run();
}

}  // namespace saddle
