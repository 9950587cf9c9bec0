#include "mesh/features/sheet_ends.h"

#include "mesh/features/approach.h"
#include "mesh/features/bisect_discontinuities.h"
#include "mesh/features/search_chunks.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// On this thread alone.
std::vector<std::optional<SheetEnd>> ends_before_gaps(const Surface& surface,
                                                      std::span<const Line> lines,
                                                      const SheetEndSearch& search,
                                                      std::size_t& work) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) uv.insert(uv.end(), line.begin(), line.end());
  std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  work += uv.size();
  std::vector<std::size_t> leaving;
  std::vector<Line> ways;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const dvec3& last = points[2 * k + 1].position;
    if (is_seen(search.box, last)) continue;
    leaving.push_back(k);
    ways.push_back(lines[k]);
  }
  const std::vector<dvec2> last = last_defined(surface, ways, search.halvings, 1, search.box);
  const std::vector<SurfacePoint> at_last = evaluate(surface, last, 1);
  work += (static_cast<std::size_t>(search.halvings) + 1) * ways.size();
  std::vector<std::optional<SheetEnd>> ends;
  for (const Line& line : lines) ends.emplace_back(SheetEnd{line[1], SheetEnd::Kind::Open});
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    ends[leaving[i]] = {last[i], SheetEnd::Kind::Boundary};
    points[2 * leaving[i] + 1] = at_last[i];
  }
  std::vector<Bracket> gaps;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Line defined = {lines[k][0], ends[k]->uv};
    gaps.push_back(bracket_of(defined, defined, points[2 * k], points[2 * k + 1]));
  }
  auto jumps =
      bisect_positions(surface, gaps, {search.delta, Prefer::First, search.halvings}, 1, work);
  // The first gap may be that of a smooth part which is steeper than its slopes say.
  std::vector<std::size_t> passed;
  std::vector<Bracket> again;
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    if (jumps[k].kind != Discontinuity::None || !jumps[k].has_passed_by) continue;
    passed.push_back(k);
    again.push_back(gaps[k]);
  }
  const auto largest =
      bisect_positions(surface, again, {search.delta, Prefer::Largest, search.halvings}, 1, work);
  for (std::size_t i = 0; i < passed.size(); ++i) jumps[passed[i]] = largest[i];
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (jumps[k].kind == Discontinuity::Pole) ends[k].reset();
    if (jumps[k].kind == Discontinuity::Jump) ends[k] = {jumps[k].ends[0], SheetEnd::Kind::Jump};
  }
  return ends;
}

}  // namespace

std::vector<std::optional<SheetEnd>> sheet_ends(const Surface& surface, std::span<const Line> lines,
                                                const SheetEndSearch& search, unsigned threads,
                                                std::size_t& work) {
  const auto search_some = [&](std::span<const Line> some, std::size_t& own_work) {
    std::vector<Line> ways_to_gaps(some.begin(), some.end());
    end_in_gaps(surface, ways_to_gaps, 1, search.box, own_work);
    return ends_before_gaps(surface, ways_to_gaps, search, own_work);
  };
  return search_chunks(lines, kSearchedTogether, threads, work, search_some);
}

}  // namespace saddle
