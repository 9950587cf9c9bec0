// The chords of curves against the curves themselves, computed here; tubes against the implicit
// equations of tori, cylinders and spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "mesh/curve/curve_mesher.h"
#include "mesh/curve/tube.h"
#include "mesh/model/topology.h"
#include "scene/model/bind_stroke.h"

namespace saddle {
namespace {

constexpr double kPi = std::numbers::pi;

ParametricCurve curve_of(const Scene& scene, const CurveSpec& spec) {
  BoundCurve bound = bind_curve(scene, spec);
  return make_curve(bound.graph, bound.r, bound.from, bound.to);
}

ParametricCurve curve_in_space(const std::string& x, const std::string& y, const std::string& z,
                               const Range& s) {
  CurveSpec spec;
  spec.x = x;
  spec.y = y;
  spec.z = z;
  spec.s = s;
  return curve_of(Scene(), spec);
}

CurveRequest within(double tolerance, double radius = 0) {
  CurveRequest request;
  request.tolerance = tolerance;
  request.radius = radius;
  return request;
}

double chord_distance(const dvec3& p, const dvec3& a, const dvec3& b) {
  const double share = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::length(p - (a + share * (b - a)));
}

TEST(CurveMesher, KeepsAHelixWithinTheTolerance) {
  const auto helix = [](double s) { return dvec3(std::cos(s), std::sin(s), s / 5); };
  constexpr double kTolerance = 1e-4;
  const CurveMesh mesh =
      mesh_curve(curve_in_space("cos(s)", "sin(s)", "s/5", {"0", "6*pi"}), within(kTolerance));
  ASSERT_EQ(mesh.chains.size(), 1U);
  const CurveChain& chain = mesh.chains[0];
  EXPECT_EQ(chain.front().s, 0);
  EXPECT_EQ(chain.back().s, 6 * kPi);
  double worst = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    for (int k = 0; k <= 20; ++k) {
      const double s = chain[i - 1].s + (chain[i].s - chain[i - 1].s) * k / 20;
      worst = std::max(worst, chord_distance(helix(s), chain[i - 1].position, chain[i].position));
    }
  }
  EXPECT_LE(worst, kTolerance);
  EXPECT_EQ(mesh.proved_fraction, 1);
  EXPECT_NEAR(mesh.length, 6 * kPi * std::hypot(1, 0.2), 0.01);
  // Chords of a circle of curvature 1 that reach the tolerance are sqrt(8 * tolerance) long.
  EXPECT_LE(static_cast<double>(chain.size()), 4 * 6 * kPi / std::sqrt(8 * kTolerance));
  EXPECT_FALSE(mesh.closed);
}

TEST(CurveMesher, TakesAVectorOfS) {
  Scene scene;
  scene.definitions = {{"c", "(cos(a), sin(a), h)", {"a"}, true}, {"h", "s/5"}};
  CurveSpec spec;
  spec.xyz = "c(s)+(1, 0, 0)";
  const CurveMesh mesh = mesh_curve(curve_of(scene, spec), within(1e-4));
  ASSERT_EQ(mesh.chains.size(), 1U);
  for (const auto& point : mesh.chains[0]) {
    const dvec3 expected(std::cos(point.s) + 1, std::sin(point.s), point.s / 5);
    EXPECT_LE(glm::distance(point.position, expected), 1e-15) << point.s;
  }
  spec.y = "s";
  EXPECT_THROW(bind_curve(scene, spec), Error);
}

/// R = 2, r = 1, where the surface's own s is another one than the curve's.
Scene torus_with_s() {
  Scene scene;
  scene.definitions = {{"s", "2"}};
  SurfaceSpec& torus = scene.surfaces.emplace_back();
  torus.name = "torus";
  torus.x = "(s+cos(v))*cos(u)";
  torus.y = "(s+cos(v))*sin(u)";
  torus.z = "sin(v)";
  return scene;
}

TEST(CurveMesher, PutsACircleOnATorusExactly) {
  CurveSpec spec;
  spec.on = "torus";
  spec.u = "3*s";
  spec.v = "1";
  spec.s = {"0", "2*pi/3"};
  const CurveMesh mesh = mesh_curve(curve_of(torus_with_s(), spec), within(1e-3));
  ASSERT_EQ(mesh.chains.size(), 1U);
  EXPECT_TRUE(mesh.closed);
  for (const CurvePoint& p : mesh.chains[0]) {
    EXPECT_NEAR(std::hypot(p.position.x, p.position.y), 2 + std::cos(1.0), 1e-14);
    EXPECT_NEAR(p.position.z, std::sin(1.0), 1e-15);
    EXPECT_NEAR(glm::length(p.tangent), 3 * (2 + std::cos(1.0)), 1e-13);
  }
}

TEST(CurveMesher, CutsAJumpAtTheLastDoubles) {
  const CurveMesh mesh =
      mesh_curve(curve_in_space("s", "s<0.3?0:1", "0", {"0", "1"}), within(1e-3));
  ASSERT_EQ(mesh.chains.size(), 2U);
  EXPECT_EQ(mesh.chains[1].front().s, 0.3);
  EXPECT_EQ(mesh.chains[0].back().s, std::nextafter(0.3, 0));
  EXPECT_EQ(mesh.chains[0].back().position.y, 0);
  EXPECT_EQ(mesh.chains[1].front().position.y, 1);
  EXPECT_EQ(mesh.jumps, std::vector<double>{0.3});
  EXPECT_TRUE(mesh.poles.empty());
}

TEST(CurveMesher, EndsAPoleAtTheClipBox) {
  CurveRequest request = within(1e-3);
  const ParametricCurve curve = curve_in_space("s", "1/s", "0", {"-1", "1"});
  EXPECT_EQ(mesh_curve(curve, request).poles, std::vector<double>{0});
  request.clip.emplace();
  request.clip->add(dvec3(-1, -5, -1));
  request.clip->add(dvec3(1, 5, 1));
  const CurveMesh mesh = mesh_curve(curve, request);
  ASSERT_EQ(mesh.chains.size(), 2U);
  EXPECT_NEAR(mesh.chains[0].back().s, -0.2, 1e-15);
  EXPECT_NEAR(mesh.chains[1].front().s, 0.2, 1e-15);
  EXPECT_EQ(mesh.undefined_fraction, 0);
}

TEST(CurveMesher, BeginsWhereABackwardRangeBegins) {
  const CurveMesh mesh = mesh_curve(curve_in_space("s", "s^2", "0", {"2", "-1"}), within(1e-3));
  ASSERT_EQ(mesh.chains.size(), 1U);
  EXPECT_EQ(mesh.chains[0].front().s, 2);
  EXPECT_EQ(mesh.chains[0].back().s, -1);
  EXPECT_EQ(mesh.chains[0].front().tangent.x, -1);
}

/// No sample comes near the needle: its half width is 1e-4 of the first chords'.
TEST(CurveMesher, FindsANeedleByBounds) {
  const CurveMesh mesh =
      mesh_curve(curve_in_space("s", "exp(-1e13*(s-0.1234567)^2)", "0", {"-1", "1"}), within(1e-3));
  double highest = 0;
  for (const CurvePoint& p : mesh.chains.at(0)) highest = std::max(highest, p.position.y);
  EXPECT_GT(highest, 0.998);
}

TEST(CurveMesher, LeavesOutWhatIsUndefined) {
  const CurveMesh root = mesh_curve(curve_in_space("s", "sqrt(s)", "0", {"-1", "3"}), within(1e-3));
  ASSERT_EQ(root.chains.size(), 1U);
  EXPECT_EQ(root.chains[0].front().s, 0);
  EXPECT_NEAR(root.undefined_fraction, 0.25, 1e-12);
  EXPECT_TRUE(root.jumps.empty());
  const CurveMesh sinc =
      mesh_curve(curve_in_space("s", "sin(s)/s", "0", {"-1", "1"}), within(1e-3));
  EXPECT_EQ(sinc.chains.size(), 1U) << "a point without a value, but with a limit";
  EXPECT_TRUE(sinc.jumps.empty());
}

/// The volume inside of a closed mesh (divergence theorem).
double volume_inside(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += glm::dot(mesh.position[t[0]], glm::cross(mesh.position[t[1]], mesh.position[t[2]])) / 6;
  }
  return sum;
}

TEST(Tube, RoundACircleIsATorus) {
  constexpr double kRadius = 0.3;
  const CurveMesh circle =
      mesh_curve(curve_in_space("2*cos(s)", "2*sin(s)", "0", {"0", "2*pi"}), within(5e-4, kRadius));
  const Mesh mesh = tube_mesh(circle, kRadius, 5e-4);
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    const dvec3& p = mesh.position[i];
    const dvec3 out = p - 2.0 * glm::normalize(dvec3(p.x, p.y, 0));
    EXPECT_NEAR(glm::length(out), kRadius, 1e-13);
    EXPECT_NEAR(glm::dot(mesh.normal[i], out / kRadius), 1, 1e-13);
  }
  const Topology found = topology(mesh);
  EXPECT_TRUE(found.is_closed());
  EXPECT_TRUE(found.orientable);
  EXPECT_EQ(found.euler_number, 0);
  EXPECT_NEAR(volume_inside(mesh), 4 * kPi * kPi * kRadius * kRadius, 0.02);
}

TEST(Tube, RoundASegmentIsACapsule) {
  constexpr double kRadius = 0.5;
  const CurveMesh line =
      mesh_curve(curve_in_space("s", "s", "2*s", {"0", "1"}), within(1e-3, kRadius));
  const Mesh mesh = tube_mesh(line, kRadius, 1e-3);
  const dvec3 end(1, 1, 2);
  for (const dvec3& p : mesh.position) {
    EXPECT_NEAR(chord_distance(p, dvec3(0), end), kRadius, 1e-14);
  }
  EXPECT_TRUE(topology(mesh).is_closed());
  EXPECT_EQ(topology(mesh).euler_number, 2);
  const double true_volume = kPi * kRadius * kRadius * (glm::length(end) + 4 * kRadius / 3);
  EXPECT_NEAR(volume_inside(mesh) / true_volume, 1, 0.01);
}

/// The Frenet frame flips at an inflection; rings that follow it would be twisted by half a turn.
TEST(Tube, IsNotTwistedWhereACurveInflects) {
  constexpr double kRadius = 0.1;
  const CurveMesh curve =
      mesh_curve(curve_in_space("s", "s^3", "0", {"-1", "1"}), within(1e-3, kRadius));
  const Mesh mesh = tube_mesh(curve, kRadius, 1e-3);
  const double widest = 2 * kPi * kRadius / 12 * 1.5;  // across a ring of the fewest corners
  for (const Triangle& t : mesh.triangles) {
    const dvec3 across = mesh.position[t[0]] - mesh.position[t[1]];
    const dvec2 angles = mesh.uv[t[0]] - mesh.uv[t[1]];
    EXPECT_LE(glm::length(across), widest + std::fabs(angles.x) * std::sqrt(10.0));
    EXPECT_GT(glm::dot(glm::cross(mesh.position[t[1]] - mesh.position[t[0]],
                                  mesh.position[t[2]] - mesh.position[t[0]]),
                       mesh.normal[t[0]]),
              0);
  }
}

TEST(Tube, HasAJointAtACorner) {
  constexpr double kRadius = 0.1;
  const CurveMesh curve =
      mesh_curve(curve_in_space("s", "abs(s)", "0", {"-1", "1"}), within(1e-3, kRadius));
  ASSERT_EQ(curve.chains.size(), 1U);
  const Mesh mesh = tube_mesh(curve, kRadius, 1e-3);
  double lowest = 0;
  for (const dvec3& p : mesh.position) {
    lowest = std::min(lowest, p.y);
    // A corner of the mesh is on the tube of one of the two sides, or inside of the other one.
    const double left = chord_distance(p, dvec3(-1, 1, 0), dvec3(0));
    const double right = chord_distance(p, dvec3(0), dvec3(1, 1, 0));
    EXPECT_NEAR(left, kRadius, left < right + 1e-9 ? 0.11 : 5);
    EXPECT_LE(std::min(left, right), kRadius + 1e-9);
  }
  EXPECT_NEAR(lowest, -kRadius, 1e-3) << "the ball round the corner";
}

TEST(BindCurve, TellsWhatIsWrong) {
  const auto message = [](const CurveSpec& spec) -> std::string {
    try {
      bind_curve(torus_with_s(), spec);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CurveSpec spec;
  EXPECT_EQ(message(spec), "the curve has no place");
  spec.x = "t";
  EXPECT_EQ(message(spec), "the curve does not depend on s");
  spec.x = "u+s";
  EXPECT_EQ(message(spec), "unknown name 'u'");
  spec.x = "s";
  EXPECT_EQ(message(spec), "");
  spec.u = "s";
  EXPECT_EQ(message(spec), "the curve has two places, one in space and one on a surface");
  spec.x.clear();
  EXPECT_EQ(message(spec), "v is missing");
  spec.v = "0";
  EXPECT_EQ(message(spec), "");
  spec.on = "torsu";
  EXPECT_EQ(message(spec), "no surface is called 'torsu'");
}

}  // namespace
}  // namespace saddle
