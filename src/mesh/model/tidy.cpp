#include "mesh/model/tidy.h"

#include <memory>
#include <span>

#include "base/numbers.h"

namespace saddle {

namespace {

/// Moves lines to used corners of the same points. Points without one leave the line.
void move_lines(Mesh& mesh, std::span<const bool> used) {
  std::vector<std::uint32_t> of_point(mesh.point.size(), kNoIndex);
  for (std::uint32_t corner = 0; corner < mesh.point.size(); ++corner) {
    if (used[corner]) of_point[mesh.point[corner]] = corner;
  }
  for (std::vector<std::uint32_t>& line : mesh.lines) {
    for (std::uint32_t& corner : line) {
      if (!used[corner]) corner = of_point[mesh.point[corner]];
    }
    std::erase(line, kNoIndex);
  }
}

void drop_unused(Mesh& mesh, std::span<const bool> used) {
  std::vector<std::uint32_t> numbers(used.size());
  std::uint32_t count = 0;
  mesh.bounds = Bounds();
  for (std::size_t corner = 0; corner < used.size(); ++corner) {
    if (!used[corner]) continue;
    mesh.bounds.add(mesh.position[corner]);
    mesh.position[count] = mesh.position[corner];
    mesh.normal[count] = mesh.normal[corner];
    mesh.uv[count] = mesh.uv[corner];
    mesh.point[count] = mesh.point[corner];
    numbers[corner] = count++;
  }
  mesh.position.resize(count);
  mesh.normal.resize(count);
  mesh.uv.resize(count);
  mesh.point.resize(count);
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = numbers[corner];
  }
  for (std::vector<std::uint32_t>& line : mesh.lines) {
    for (std::uint32_t& corner : line) corner = numbers[corner];
  }
}

}  // namespace

void number_points(Mesh& mesh) {
  std::uint32_t names = 0;
  for (const std::uint32_t point : mesh.point) names = std::max(names, point + 1);
  std::vector<std::uint32_t> numbers(names, kNoIndex);
  mesh.point_count = 0;
  for (std::uint32_t& point : mesh.point) {
    std::uint32_t& number = numbers[point];
    if (number == kNoIndex) number = mesh.point_count++;
    point = number;
  }
}

void keep_used_corners(Mesh& mesh) {
  const auto used = std::make_unique<bool[]>(mesh.position.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) used[corner] = true;
  }
  const std::span<const bool> used_corners(used.get(), mesh.position.size());
  move_lines(mesh, used_corners);
  drop_unused(mesh, used_corners);
  number_points(mesh);
}

}  // namespace saddle
