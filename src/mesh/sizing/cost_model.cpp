#include "mesh/sizing/cost_model.h"

#include "formula/operations.h"

namespace saddle {
namespace {

/// Cost of a function call, in additions.
constexpr double kCall = 25;
/// Points for each cell. A grid: a share of corners and sides, the centre, and four between them. A
/// tree: besides, those of cells that were subdivided.
constexpr double kGridSamples = 8;
constexpr double kLeafSamples = 10;
constexpr double kMillisecond = 1e6;  // nanoseconds

double weight(std::span<const Instruction> instructions) {
  double sum = 0;
  for (const Instruction& instruction : instructions)
    sum += row_of(instruction.op).kind == Kind::Arithmetic ? 1 : kCall;
  return sum;
}

double weight(const Tape& tape) {
  return weight(tape.of_u) + weight(tape.of_v) + weight(tape.of_both);
}

std::size_t rounded(double count) {
  return static_cast<std::size_t>(count);
}

}  // namespace

Operations count_operations(const Surface& surface) {
  return {weight(surface.normals.of_both), weight(surface.tangents), weight(surface.bounds)};
}

double cost(const MeshWork& work, const Operations& operations) {
  const auto sum = [](std::size_t count, double each) { return static_cast<double>(count) * each; };
  const double nanoseconds =
      sum(work.grid_samples, kCosts.grid_sample + kCosts.operation * operations.of_grid) +
      sum(work.leaf_samples, kCosts.leaf_sample + kCosts.operation * operations.of_point) +
      sum(work.boxes, kCosts.box + kCosts.box_operation * operations.of_box);
  return nanoseconds / kMillisecond;
}

double drawing_cost(double triangles, double times) {
  return triangles * times * kCosts.triangle / kMillisecond;
}

MeshWork work_of_grid(double cells) {
  return {.grid_samples = rounded(kGridSamples * cells)};
}

MeshWork work_of_halving(double cells) {
  return {.leaf_samples = rounded(kLeafSamples * cells)};
}

}  // namespace saddle
