#include "mesh/sizing/effort.h"

#include "eval/enclose.h"
#include "mesh/sizing/cost_model.h"

namespace saddle {

namespace {

/// Nanoseconds, of which only ratios matter: a place without its formula, a look without its
/// formula, and a step of an Enclosure.
constexpr double kPlace = 270;
constexpr double kLook = 20;
constexpr double kStep = 5;

}  // namespace

Effort::Effort(const Surface& surface)
    : place_(1 + kCosts.operation * count_operations(surface).of_point / kPlace),
      look_((kLook + kStep * static_cast<double>(Enclosure(surface.bounds, 3).steps())) / kPlace) {}

}  // namespace saddle
