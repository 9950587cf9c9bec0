#include "mesh/measured.h"

namespace saddle {

void Measured::remove(std::span<const std::size_t> which) {
  if (which.empty()) return;
  std::size_t to = which.front();
  for (std::size_t from = to; from < leaves.size(); ++from) {
    if (!which.empty() && which.front() == from) {
      which = which.subspan(1);
      continue;
    }
    leaves[to] = leaves[from];
    deviations[to] = deviations[from];
    allowed[to++] = allowed[from];
  }
  leaves.resize(to);
  deviations.resize(to);
  allowed.resize(to);
}

}  // namespace saddle
