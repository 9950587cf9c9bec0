// Formulas put back into text for muparser mean what they meant.
#include "study/muparser_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "eval/batch.h"
#include "scene/model/gallery.h"
#include "scene/model/prepare.h"
#include "study_subject.h"

namespace saddle {
namespace {

constexpr int kPoints = 50;

/// Both evaluators are within some last places of the truth, which cancellation may amplify.
constexpr double kShare = 1e-11;

/// False if muparser cannot read the surface.
bool expect_same(const Scene& scene) {
  const BoundSurface bound = bind_surface(scene, scene.surfaces.at(0));
  auto method = MuparserMethod::make(bound.graph, bound.r);
  if (!method) return false;
  std::vector<double> u;
  std::vector<double> v;
  for (int k = 0; k < kPoints; ++k) {
    const Domain& d = bound.domain;
    u.push_back(d.u0 + (d.u1 - d.u0) * (k + 0.37) / kPoints);
    v.push_back(d.v0 + (d.v1 - d.v0) * ((7 * k) % kPoints + 0.59) / kPoints);
  }
  std::array<std::vector<double>, 9> columns;
  std::array<double*, 9> to{};
  for (std::size_t k = 0; k < 9; ++k) {
    columns[k].resize(kPoints);
    to[k] = columns[k].data();
  }
  evaluate_points(compile(bound.graph, bound.r), u, v, std::span(to).first(3));
  method->scalar(u, v, {to[3], to[4], to[5]});
  method->bulk(u, v, {to[6], to[7], to[8]});
  for (std::size_t k = 0; k < 3; ++k) {
    double size = 0;
    for (const double x : columns[k])
      size = std::isfinite(x) ? std::fmax(size, std::fabs(x)) : size;
    for (std::size_t i = 0; i < kPoints; ++i) {
      EXPECT_EQ(std::isnan(columns[k][i]), std::isnan(columns[k + 3][i]));
      EXPECT_EQ(std::isnan(columns[k][i]), std::isnan(columns[k + 6][i]));
      if (std::isnan(columns[k][i])) continue;
      EXPECT_EQ(columns[k + 3][i], columns[k + 6][i]);
      EXPECT_NEAR(columns[k][i], columns[k + 3][i], kShare * size) << k << " " << i;
    }
  }
  return true;
}

TEST(MuparserMethod, AgreesWithTapesOnTheGallery) {
  std::size_t refused = 0;  // some are long: without their shared parts, past muparser's limit
  for (const GalleryEntry& entry : gallery()) {
    SCOPED_TRACE(entry.name);
    if (!expect_same(gallery_scene(entry))) ++refused;
  }
  EXPECT_LT(refused, gallery().size() / 10);
}

TEST(MuparserMethod, HasOurFunctionsToo) {
  const Scene scene =
      scene_of("if(u<0, -u^2, cbrt(u))+hypot(u,v)", "besselj0(u)+erf(v)+gamma(3+u)+sinc(v)",
               "mod(u,0.3)+floor(3*v)+sign(u)*lgamma(2+v)+(u>0&&v<0?1:-2)");
  EXPECT_TRUE(expect_same(scene));
}

TEST(MuparserMethod, RefusesWhatIsTooLongForMuparser) {
  Scene scene = scene_of("u", "v", "w12");
  scene.definitions.push_back({"w0", "u+v"});
  for (int k = 1; k <= 12; ++k) {
    const std::string before = "w" + std::to_string(k - 1);
    scene.definitions.push_back({"w" + std::to_string(k), "sin(" + before + ")*" + before});
  }
  const BoundSurface bound = bind_surface(scene, scene.surfaces[0]);
  EXPECT_FALSE(MuparserMethod::make(bound.graph, bound.r).has_value());
}

}  // namespace
}  // namespace saddle
