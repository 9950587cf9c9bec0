#include "surface/surface.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <utility>

#include "base/parallel.h"
#include "base/run_limits.h"
#include "eval/batch.h"
#include "eval/differences.h"
#include "eval/vectors.h"
#include "surface/forms.h"

namespace saddle {

namespace {

/// Points computed at a time: the columns of a block (9 to 13, 1.7 MB) stay in the outer caches,
/// and a block is long enough to keep many threads busy.
constexpr std::size_t kBlock = std::size_t{1} << 14;
/// Records per chunk when columns are turned into records.
constexpr std::size_t kPackChunk = 4096;

/// A tape's outputs for one block, a column each.
class Columns {
 public:
  Columns(const Tape& tape, std::size_t capacity) {
    values_.resize(tape.outputs.size() * capacity);
    for (std::size_t k = 0; k < tape.outputs.size(); ++k) {
      starts_.push_back(values_.data() + k * capacity);
    }
  }
  std::span<double* const> outputs() const { return starts_; }

  /// Rows of the columns as records that consist of as many doubles.
  template <class Record>
  void pack(std::span<Record> records, unsigned threads) const {
    assert(sizeof(Record) == starts_.size() * sizeof(double));
    parallel_chunks(records.size(), kPackChunk, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        // NOLINTNEXTLINE(bugprone-sizeof-expression): a record may be a single double
        std::array<double, sizeof(Record) / sizeof(double)> row;
        for (std::size_t k = 0; k < row.size(); ++k) row[k] = starts_[k][i];
        std::memcpy(&records[i], row.data(), sizeof(Record));
      }
    });
  }

 private:
  Array<double> values_;
  std::vector<double*> starts_;
};

template <class Record>
std::vector<Record> evaluate_records(const Tape& tape, std::span<const dvec2> uv,
                                     unsigned threads) {
  std::vector<Record> records(uv.size());
  const std::size_t block = std::min(kBlock, uv.size());
  const Columns columns(tape, block);
  Array<double> u;
  Array<double> v;
  u.resize(block);
  v.resize(block);
  for (std::size_t begin = 0; begin < uv.size(); begin += block) {
    const std::size_t count = std::min(block, uv.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      u[i] = uv[begin + i].x;
      v[i] = uv[begin + i].y;
    }
    evaluate_points(tape, std::span(u).first(count), std::span(v).first(count), columns.outputs(),
                    threads);
    columns.pack(std::span(records).subspan(begin, count), threads);
  }
  return records;
}

/// `evaluate` fills the columns with the outputs of Surface::normals.
template <class Evaluate>
NormalColumns normal_columns(std::size_t count, Evaluate evaluate) {
  NormalColumns columns;
  std::array<double*, kAreaColumn> outputs{};
  for (Array<double>& column : columns) column.resize(count);
  for (std::size_t k = 0; k < outputs.size(); ++k) outputs[k] = columns[k].data();
  evaluate(outputs);
  const std::span<double* const> units = std::span(outputs).subspan(kNormalColumn, 3);
  const std::array<Operand, 3> normals = {{{units[0], true}, {units[1], true}, {units[2], true}}};
  vector_loops(cpu_level())
      .normalize(normals.data(), count, 1, units.data(), columns[kAreaColumn].data());
  return columns;
}

}  // namespace

bool Surface::may_go_on() const {
  return !(tangents.count && tangents.count->is_used_up()) && shortage() != Shortage::Time;
}

Surface make_surface(Graph& graph, const std::array<NodeId, 3>& r, const Domain& domain, bool flip,
                     Order order) {
  const Tangents tangents = tangents_of(graph, r);
  Surface surface{domain, flip, {}, {}, {}, {}, {}, {}, {}, {}};
  surface.tangents = compile(graph, tangent_outputs(tangents));
  surface.normals = compile(graph, normal_outputs(graph, tangents));
  if (order == Order::Second) {
    surface.curvatures = compile(graph, curvature_outputs(graph, tangents));
    surface.bounds = compile(
        graph, narrow_differences(graph, second_order_outputs(graph, tangents)), Powers::Whole);
  }
  surface.tangents.count = std::make_shared<PointCount>();
  surface.normals.count = surface.curvatures.count = surface.bounds.count = surface.tangents.count;
  surface.positions = first_outputs(surface.tangents, 3);
  return surface;
}

void take_user_parameters(const Surface& surface, std::span<dvec2> uv) {
  if (surface.v.outputs.empty()) return;
  const std::vector<double> v = evaluate_records<double>(surface.v, uv, 1);
  for (std::size_t i = 0; i < uv.size(); ++i) uv[i].y = v[i];
}

void take_own_parameters(const Surface& surface, std::span<dvec2> uv) {
  if (surface.v.outputs.empty()) return;
  for (dvec2& place : uv) {
    std::array ends = {dvec2(place.x, 0), dvec2(place.x, 1)};
    take_user_parameters(surface, ends);
    const double length = ends[1].y - ends[0].y;  // v is linear in s
    place.y = length > 0 ? (place.y - ends[0].y) / length : 0;
  }
}

std::vector<SurfacePoint> evaluate(const Surface& surface, std::span<const dvec2> uv,
                                   unsigned threads) {
  return evaluate_records<SurfacePoint>(surface.tangents, uv, threads);
}

std::vector<dvec3> evaluate_positions(const Surface& surface, std::span<const dvec2> uv,
                                      unsigned threads) {
  return evaluate_records<dvec3>(surface.positions, uv, threads);
}

NormalColumns evaluate_normals(const Surface& surface, std::span<const double> u,
                               std::span<const double> v, unsigned threads) {
  return normal_columns(u.size(), [&](std::span<double* const> outputs) {
    evaluate_points(surface.normals, u, v, outputs, threads);
  });
}

NormalColumns evaluate_normals_on_grid(const Surface& surface, std::span<const double> u,
                                       std::span<const double> v, unsigned threads) {
  return normal_columns(u.size() * v.size(), [&](std::span<double* const> outputs) {
    evaluate_grid(surface.normals, u, v, outputs, threads);
  });
}

std::vector<Curvature> evaluate_curvature(const Surface& surface, std::span<const dvec2> uv,
                                          unsigned threads) {
  assert(!surface.curvatures.outputs.empty());
  auto curvatures = evaluate_records<Curvature>(surface.curvatures, uv, threads);
  if (surface.flip) {
    for (Curvature& c : curvatures) {
      c.mean = -c.mean;
      c.largest = -std::exchange(c.smallest, -c.largest);
    }
  }
  return curvatures;
}

std::vector<double> evaluate_color(const Surface& surface, std::span<const dvec2> uv,
                                   unsigned threads) {
  return evaluate_records<double>(surface.color, uv, threads);
}

RegionShare region_share(const Surface& surface, unsigned threads) {
  constexpr int kPlaces = 256;  // each way: a part of a thousandth of the domain has 65 of them
  std::vector<dvec2> uv;
  for (int j = 0; j < kPlaces; ++j) {
    for (int i = 0; i < kPlaces; ++i)
      uv.push_back(surface.domain.at((dvec2(i, j) + 0.5) / double(kPlaces)));
  }
  struct Record {
    double condition, x, y, z;
  };
  static_assert(sizeof(Record) == kRegionOutputs * sizeof(double));
  std::size_t outside = 0;
  std::size_t undefined = 0;
  for (const Record& at : evaluate_records<Record>(surface.region, uv, threads)) {
    outside += at.condition == 0 ? 1 : 0;
    undefined += at.condition != 0 && !is_finite({at.x, at.y, at.z}) ? 1 : 0;
  }
  const auto count = static_cast<double>(uv.size());
  return {static_cast<double>(outside) / count, static_cast<double>(undefined) / count};
}

std::vector<SurfacePoint> evaluate_on_grid(const Surface& surface, std::span<const double> u,
                                           std::span<const double> v, unsigned threads) {
  std::vector<SurfacePoint> points(u.size() * v.size());
  if (points.empty()) return points;
  const std::size_t rows = std::clamp<std::size_t>(kBlock / u.size(), 1, v.size());
  const Columns columns(surface.tangents, rows * u.size());
  for (std::size_t row = 0; row < v.size(); row += rows) {
    const std::size_t count = std::min(rows, v.size() - row);
    evaluate_grid(surface.tangents, u, v.subspan(row, count), columns.outputs(), threads);
    columns.pack(std::span(points).subspan(row * u.size(), count * u.size()), threads);
  }
  return points;
}

}  // namespace saddle
