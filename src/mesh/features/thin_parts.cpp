#include "mesh/features/thin_parts.h"

#include <algorithm>

#include "mesh/features/bisect_discontinuities.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/continuity.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Open parts of a line.
struct OpenLine {
  std::size_t number;
  std::vector<Line> parts;
};

class ThinPartSearch {
 public:
  ThinPartSearch(const Surface& surface, std::span<const AlikeEnds> lines, unsigned threads)
      : surface_(surface),
        lines_(lines),
        threads_(threads),
        found_(lines.size()),
        enclosure_(surface, Bounded::Position) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (!is_alike(lines[k].line, lines[k].are_defined)) open_.push_back({k, {lines[k].line}});
    }
  }

  std::vector<std::optional<dvec2>> run() {
    for (int halving = 0; halving < kHalvingsToNearly && !open_.empty(); ++halving) {
      halve();
      for (OpenLine& open : open_) {
        const bool are_defined = lines_[open.number].are_defined;
        std::erase_if(open.parts, [&](const Line& part) { return is_alike(part, are_defined); });
      }
      std::erase_if(open_, [](const OpenLine& open) {
        return open.parts.empty() || open.parts.size() > kMostLineParts;
      });
    }
    return std::move(found_);
  }

  std::size_t work() const { return work_; }

 private:
  /// Whether bounds prove a part to be defined, or undefined, all along.
  bool is_alike(const Line& part, bool are_defined) {
    ++work_;
    const std::span<const Interval> position =
        enclosure_.enclose({glm::min(part[0], part[1]), glm::max(part[0], part[1])});
    return least_defined(position) == (are_defined ? Defined::Yes : Defined::No);
  }

  /// Halves the open parts. Closes lines with a middle that differs from the ends.
  void halve() {
    std::vector<dvec2> middles;
    for (const OpenLine& open : open_) {
      for (const Line& part : open.parts) middles.push_back(near_middle(part));
    }
    const std::vector<dvec3> points = evaluate_positions(surface_, middles, threads_);
    work_ += points.size();
    std::size_t next = 0;
    for (OpenLine& open : open_) {
      std::vector<Line> halves;
      for (const Line& part : open.parts) {
        const std::size_t k = next++;
        if (is_finite(points[k]) != lines_[open.number].are_defined)
          found_[open.number] = middles[k];
        halves.push_back({part[0], middles[k]});
        halves.push_back({middles[k], part[1]});
      }
      open.parts = std::move(halves);
    }
    std::erase_if(open_, [&](const OpenLine& open) { return found_[open.number].has_value(); });
  }

  const Surface& surface_;
  std::span<const AlikeEnds> lines_;
  unsigned threads_;
  std::vector<std::optional<dvec2>> found_;
  SurfaceEnclosure enclosure_;
  std::vector<OpenLine> open_;
  std::size_t work_ = 0;
};

}  // namespace

std::vector<std::optional<dvec2>> find_thin_parts(const Surface& surface,
                                                  std::span<const AlikeEnds> lines,
                                                  unsigned threads, std::size_t& work) {
  if (lines.empty()) return {};
  ThinPartSearch search(surface, lines, threads);
  std::vector<std::optional<dvec2>> found = search.run();
  work += search.work();
  return found;
}

}  // namespace saddle
