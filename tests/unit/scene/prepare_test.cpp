#include "scene/model/prepare.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/error.h"
#include "scene/model/assignments.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

Surface surface_of(const std::vector<std::string>& assignments) {
  Scene scene;
  for (const std::string& assignment : assignments) assign(scene, assignment);
  scene = resolve(scene);
  return prepare_surface(scene, scene.surfaces.at(0)).surface;
}

dvec3 point_of(const Surface& surface, dvec2 uv) {
  return evaluate(surface, std::array{uv})[0].position;
}

Error prepare_error(const std::vector<std::string>& assignments) {
  try {
    surface_of(assignments);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {Status::Done, ""};
}

std::string marked_part(const Error& error) {
  const Place& place = error.place();
  return place.text.substr(place.span.begin, place.span.end - place.span.begin);
}

TEST(Prepare, MakesAHeightFieldWhenOnlyZIsGiven) {
  EXPECT_EQ(point_of(surface_of({"z=u*v"}), {3, 5}), dvec3(3, 5, 15));
}

TEST(Prepare, KnowsParametersSharedExpressionsFunctionsAndTheSurfaceItself) {
  const Surface surface = surface_of({"z=f(w)+x", "f(s)=a*s", "w=u+v", "a=10", "x=100*u"});
  EXPECT_EQ(point_of(surface, {1, 2}), dvec3(100, 2, 130));
}

TEST(Prepare, DrawsTheScenesMoment) {
  EXPECT_EQ(point_of(surface_of({"z=t*u", "t=7"}), {2, 0}).z, 14);
}

TEST(Prepare, KnowsWhatTimeMoves) {
  const auto moves = [](const std::vector<std::string>& assignments) {
    Scene scene;
    for (const std::string& text : assignments) assign(scene, text);
    scene.t = 3;
    return prepare_surface(scene, scene.surfaces[0]).moves;
  };
  EXPECT_FALSE(moves({"z=a*u", "a=2"}));
  EXPECT_FALSE(moves({"z=u", "w=t"}));
  EXPECT_TRUE(moves({"z=a*u", "a=t"}));
  EXPECT_TRUE(moves({"z=f(u)", "f(s)=s+t"}));
  EXPECT_TRUE(moves({"z=u", "u=0:t"}));
  EXPECT_TRUE(moves({"z=u", "v=0:1+t"}));
  EXPECT_TRUE(moves({"z=u", "v=0:u*t+2"}));
}

TEST(Prepare, EndsRangesWhereTheMomentHasThem) {
  const Domain domain = surface_of({"z=u", "u=-t:2*t", "v=0:t/2", "t=4"}).domain;
  EXPECT_EQ(domain.u0, -4);
  EXPECT_EQ(domain.u1, 8);
  EXPECT_EQ(domain.v1, 2);
}

TEST(Prepare, ComputesRangesWithParameters) {
  const Domain domain = surface_of({"z=u", "u=-a:2*a", "v=3:1", "a=4"}).domain;
  EXPECT_EQ(domain.u0, -4);
  EXPECT_EQ(domain.u1, 8);
  EXPECT_EQ(domain.v0, 3);
  EXPECT_EQ(domain.v1, 1);
}

TEST(Prepare, WantsAZ) {
  const Error error = prepare_error({"x=u"});
  EXPECT_EQ(error.status(), Status::Input);
  EXPECT_NE(std::string(error.what()).find("z has no formula"), std::string::npos);
}

TEST(Prepare, PointsIntoTheWholeRange) {
  const Error error = prepare_error({"z=u", "v=0:2*foo"});
  EXPECT_EQ(error.place().name, "v");
  EXPECT_EQ(error.place().text, "0:2*foo");
  EXPECT_EQ(marked_part(error), "foo");
}

TEST(Prepare, RefusesRangesThatAreEmptyOrNotFinite) {
  EXPECT_STREQ(prepare_error({"z=u", "u=1:2-1"}).what(), "the range of u is empty");
  EXPECT_EQ(marked_part(prepare_error({"z=u", "u=0:1/0"})), "1/0");
  EXPECT_EQ(marked_part(prepare_error({"z=u", "v=nan:1"})), "nan");
  EXPECT_EQ(prepare_error({"z=u", "v=-1e308:1e308"}).status(), Status::Input);
}

TEST(Prepare, TakesVBetweenEndsThatDependOnU) {
  const Surface surface = surface_of({"x=u", "y=v", "z=u*v", "u=0:4", "v=u^2:a*u", "a=10"});
  EXPECT_EQ(surface.domain.v0, 0);
  EXPECT_EQ(surface.domain.v1, 1);
  EXPECT_EQ(point_of(surface, {2, 0}), dvec3(2, 4, 8));
  EXPECT_EQ(point_of(surface, {2, 1}), dvec3(2, 20, 40));
  EXPECT_EQ(point_of(surface, {2, 0.25}), dvec3(2, 8, 16));
  std::array uv = {dvec2(2, 0.25), dvec2(3, 1)};
  take_user_parameters(surface, uv);
  EXPECT_EQ(uv[0], dvec2(2, 8));
  EXPECT_EQ(uv[1], dvec2(3, 30));
  take_own_parameters(surface, uv);
  EXPECT_EQ(uv[0], dvec2(2, 0.25));
  EXPECT_EQ(uv[1], dvec2(3, 1));
}

TEST(Prepare, DifferentiatesThroughEndsThatDependOnU) {
  const Surface surface = surface_of({"z=u*v^2", "u=0:3", "v=1:2+sin(u)"});
  // v = 1 + s (1 + sin u), z = u v^2
  const dvec2 place(0.7, 0.3);
  const double v = 1 + 0.3 * (1 + std::sin(0.7));
  const double v_u = 0.3 * std::cos(0.7);
  const double v_s = 1 + std::sin(0.7);
  const SurfacePoint p = evaluate(surface, std::array{place})[0];
  EXPECT_NEAR(glm::distance(p.r_u, dvec3(1, v_u, v * v + 2 * 0.7 * v * v_u)), 0, 1e-15);
  EXPECT_NEAR(glm::distance(p.r_v, dvec3(0, v_s, 2 * 0.7 * v * v_s)), 0, 1e-15);
}

TEST(Prepare, TakesEndsThatDependOnUInEitherOrder) {
  const Surface surface = surface_of({"z=0", "u=-1:1", "v=u:0"});
  EXPECT_EQ(point_of(surface, {-0.5, 0}).y, -0.5);
  EXPECT_EQ(point_of(surface, {-0.5, 1}).y, 0);
  EXPECT_EQ(point_of(surface, {0.5, 0}).y, 0);
  EXPECT_EQ(point_of(surface, {0.5, 1}).y, 0.5);
  EXPECT_FALSE(surface.flip);
}

TEST(Prepare, LeavesParametersOfConstantRangesAlone) {
  std::array uv = {dvec2(2, 0.25)};
  take_user_parameters(surface_of({"z=u"}), uv);
  EXPECT_EQ(uv[0], dvec2(2, 0.25));
}

TEST(Prepare, RefusesRangesThatDependOnEachOtherOrThemselves) {
  EXPECT_STREQ(prepare_error({"z=u", "u=0:v"}).what(), "the range of u cannot depend on v");
  EXPECT_STREQ(prepare_error({"z=u", "u=0:w", "w=v^2"}).what(),
               "the range of u cannot depend on v");
  EXPECT_STREQ(prepare_error({"z=u", "u=u:1"}).what(), "the range of u depends on itself");
  EXPECT_STREQ(prepare_error({"z=u", "v=u:v"}).what(), "the range of v depends on itself");
  EXPECT_STREQ(prepare_error({"z=u", "v=2*u:2*u"}).what(), "the range of v is empty");
  EXPECT_EQ(marked_part(prepare_error({"z=u", "v=0:2*v"})), "2*v");
}

TEST(Prepare, FlipsOnRequest) {
  Scene scene;
  assign(scene, "z=u");
  scene.surfaces[0].flip = true;
  EXPECT_TRUE(prepare_surface(scene, scene.surfaces[0]).surface.flip);
}

TEST(Prepare, FlipsForARangeThatRunsBackwards) {
  const auto flipped = [](const char* u, const char* v) {
    Scene scene;
    for (const char* assignment : {"z=u", u, v}) assign(scene, assignment);
    return prepare_surface(scene, scene.surfaces[0]).surface.flip;
  };
  EXPECT_FALSE(flipped("u=0:1", "v=0:1"));
  EXPECT_TRUE(flipped("u=1:0", "v=0:1"));
  EXPECT_TRUE(flipped("u=0:1", "v=1:0"));
  EXPECT_FALSE(flipped("u=1:0", "v=1:0"));
}

}  // namespace
}  // namespace saddle
