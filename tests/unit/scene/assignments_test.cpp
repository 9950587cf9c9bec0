#include "scene/model/assignments.h"

#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "base/error.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

Scene scene_of(const std::vector<std::string>& assignments) {
  Scene scene;
  for (const std::string& assignment : assignments) assign(scene, assignment);
  return scene;
}

template <typename Action>
Error error_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {Status::Done, ""};
}

Error assign_error(const std::string& assignment) {
  return error_of([&] { scene_of({assignment}); });
}

/// The part of the place's text that the caret marks.
std::string marked(const Error& error) {
  const Place& place = error.place();
  return place.text.substr(place.span.begin, place.span.end - place.span.begin);
}

TEST(Assignments, PutCoordinatesIntoTheSurface) {
  const Scene scene = scene_of({"z=u*v", "x=2*u", "y = v + 1"});
  ASSERT_EQ(scene.surfaces.size(), 1U);
  EXPECT_EQ(scene.surfaces[0].x, "2*u");
  EXPECT_EQ(scene.surfaces[0].y, "v + 1");
  EXPECT_EQ(scene.surfaces[0].z, "u*v");
  EXPECT_TRUE(scene.definitions.empty());
}

TEST(Assignments, SplitAtTheFirstEqualsSign) {
  EXPECT_EQ(scene_of({"z=u==v"}).surfaces[0].z, "u==v");
  EXPECT_EQ(scene_of({"a==b"}).definitions[0].text, "=b");
}

TEST(Assignments, ReadRangesOfConstantExpressions) {
  const Scene scene = scene_of({"u=0:2*pi", " v = -1 : +1 "});
  EXPECT_EQ(scene.surfaces[0].u.min, "0");
  EXPECT_EQ(scene.surfaces[0].u.max, "2*pi");
  EXPECT_EQ(scene.surfaces[0].v.min, "-1");
  EXPECT_EQ(scene.surfaces[0].v.max, "+1");
}

TEST(Assignments, SplitRangesAtTheFirstColonThatNoQuestionMarkOwns) {
  const Range first = scene_of({"u=a<0?1:2:3"}).surfaces[0].u;
  EXPECT_EQ(first.min, "a<0?1:2");
  EXPECT_EQ(first.max, "3");
  const Range second = scene_of({"u=0:a<0?1:2"}).surfaces[0].u;
  EXPECT_EQ(second.min, "0");
  EXPECT_EQ(second.max, "a<0?1:2");
  const Range bracketed = scene_of({"u=(a<0?1:2):(b?3:4)"}).surfaces[0].u;
  EXPECT_EQ(bracketed.min, "(a<0?1:2)");
  EXPECT_EQ(bracketed.max, "(b?3:4)");
  const Range nested = scene_of({"u=a?b?1:2:3:4"}).surfaces[0].u;
  EXPECT_EQ(nested.min, "a?b?1:2:3");
  EXPECT_EQ(nested.max, "4");
}

TEST(Assignments, MakeOtherNamesDefinitionsInTheirOrder) {
  const Scene scene = scene_of({"r=0.4", "w=cosh(v)^2", "e=3"});
  ASSERT_EQ(scene.definitions.size(), 3U);
  EXPECT_EQ(scene.definitions[0].name, "r");
  EXPECT_EQ(scene.definitions[1].text, "cosh(v)^2");
  EXPECT_EQ(scene.definitions[2].name, "e");
  EXPECT_FALSE(scene.definitions[0].is_function);
}

TEST(Assignments, ReplaceANameThatIsThere) {
  const Scene scene = scene_of({"r=1", "s=2", "r=3", "z=u", "z=v"});
  ASSERT_EQ(scene.definitions.size(), 2U);
  EXPECT_EQ(scene.definitions[0].text, "3");
  EXPECT_EQ(scene.surfaces[0].z, "v");
}

TEST(Assignments, ReadHelperFunctions) {
  const Scene scene = scene_of({"f ( s ,u) = s*u", "g(s)=s==1"});
  ASSERT_EQ(scene.definitions.size(), 2U);
  EXPECT_EQ(scene.definitions[0].name, "f");
  EXPECT_EQ(scene.definitions[0].arguments, (std::vector<std::string>{"s", "u"}));
  EXPECT_EQ(scene.definitions[0].text, "s*u");
  EXPECT_TRUE(scene.definitions[0].is_function);
  EXPECT_EQ(scene.definitions[1].text, "s==1");
}

TEST(Assignments, ReadTheMoment) {
  EXPECT_EQ(scene_of({"t=3/4"}).t.text, "3/4");
  EXPECT_EQ(resolve(scene_of({"t=a+1", "a=2"})).t, 3);
}

TEST(Assignments, PointAtAMomentThatIsNoNumber) {
  EXPECT_EQ(marked(error_of([] { resolve(scene_of({"t=1/0"})); })), "1/0");
}

TEST(Assignments, ReadARangeOfTimeAndBeginAtItsStart) {
  const Scene scene = resolve(scene_of({"t=a:a ? tau : 0", "a=2"}));
  ASSERT_TRUE(scene.animation);
  EXPECT_EQ(scene.animation->from, 2);
  EXPECT_EQ(scene.animation->to, 2 * std::numbers::pi);
  EXPECT_EQ(scene.t, 2);
}

TEST(Assignments, RefuseRangesOfTimeThatAreNone) {
  for (const auto& [text, message, place] : {std::tuple{"t=1:", "the upper end is missing", ":"},
                                             std::tuple{"t=0:1:2", "a range has one ':'", ":"}}) {
    const Error error = assign_error(text);
    EXPECT_EQ(std::string(error.what()), message);
    EXPECT_EQ(marked(error), place);
  }
  for (const auto& [text, message, place] :
       {std::tuple{"t=3:3", "the range of t is empty", "3"},
        std::tuple{"t=0:-tau", "the range of t runs backwards", "-tau"},
        std::tuple{"t=-1e308:1e308", "the range of t is too wide", "1e308"},
        std::tuple{"t=0:t+1", "this must be a constant", "t+1"}}) {
    const Error error = error_of([text = text] { resolve(scene_of({text})); });
    EXPECT_EQ(std::string(error.what()), message);
    EXPECT_EQ(marked(error), place);
    EXPECT_EQ(error.status(), Status::Input);
  }
}

TEST(Assignments, RefuseNamesThatAreNone) {
  EXPECT_EQ(marked(assign_error("2x=3")), "2x");
  EXPECT_EQ(marked(assign_error("a<=b")), "a<");
  EXPECT_EQ(marked(assign_error("a!=b")), "a!");
  EXPECT_EQ(marked(assign_error("a b=3")), "a b");
  EXPECT_EQ(marked(assign_error("f(2)=3")), "2");
  EXPECT_EQ(marked(assign_error("f(s,)=3")), "");
  EXPECT_EQ(marked(assign_error("f()=3")), "()");
  EXPECT_EQ(assign_error("z= ").place().name, "z");
  EXPECT_EQ(assign_error("=3").status(), Status::Input);
  EXPECT_EQ(assign_error("f(s=3").status(), Status::Input);
}

TEST(Assignments, KeepCoordinatesAndParametersFromBeingFunctions) {
  for (const char* text : {"x(s)=s", "u(s)=s", "t(s)=s"}) {
    EXPECT_EQ(assign_error(text).status(), Status::Input) << text;
  }
}

TEST(Assignments, RefuseNamesThatNoSceneCanDefine) {
  const Error error = assign_error("sin=2");
  EXPECT_EQ(std::string(error.what()), "'sin' is a function of the language");
  EXPECT_EQ(error.place().name, "sin");
  EXPECT_EQ(assign_error("sqrt(s)=s").place().name, "sqrt(s)");
  EXPECT_EQ(std::string(assign_error("f(s,s)=s").what()), "two arguments are called 's'");
}

TEST(Assignments, WantAWholeRange) {
  EXPECT_EQ(assign_error("u=3").place().name, "u");
  EXPECT_EQ(marked(assign_error("u=3")), "3");
  EXPECT_EQ(marked(assign_error("u=(1:2)")), "(1:2)");
  EXPECT_EQ(marked(assign_error("u=:3")), ":");
  EXPECT_EQ(marked(assign_error("u=3:")), ":");
  const Error twice = assign_error("v=0:1:2");
  EXPECT_EQ(twice.place().text, "0:1:2");
  EXPECT_EQ(twice.place().span.begin, 3U);
}

TEST(Assignments, RefuseEmptyExpressions) {
  EXPECT_EQ(assign_error("z=").status(), Status::Input);
  EXPECT_EQ(assign_error("z= ").status(), Status::Input);
}

TEST(Overrides, ReplaceWhatTheSceneHas) {
  Scene scene = scene_of({"z=r*u", "r=1", "f(s)=s"});
  override_assignment(scene, "r=2");
  override_assignment(scene, "f(q)=2*q");
  override_assignment(scene, "u=0:1");
  override_assignment(scene, "z=r");
  override_assignment(scene, "t=r");
  EXPECT_EQ(scene.definitions[0].text, "2");
  EXPECT_EQ(scene.definitions[1].arguments[0], "q");
  EXPECT_EQ(scene.surfaces[0].u.max, "1");
  EXPECT_EQ(scene.surfaces[0].z, "r");
  EXPECT_EQ(resolve(scene).t, 2);
}

TEST(Overrides, RefuseOtherNamesAndListTheRightOnes) {
  Scene scene = scene_of({"z=radius*u", "radius=1"});
  const Error error = error_of([&] { override_assignment(scene, "radios=2"); });
  EXPECT_EQ(error.status(), Status::Input);
  EXPECT_EQ(marked(error), "radios");
  EXPECT_NE(error.hint().find("radius x y z u v t"), std::string::npos);
  EXPECT_NE(error.hint().find("did you mean 'radius'?"), std::string::npos);
  EXPECT_EQ(scene.definitions.size(), 1U);
}

TEST(Overrides, AskWhichSurfaceIsMeant) {
  Scene scene = scene_of({"z=a*u", "a=1"});
  scene.surfaces.push_back(scene.surfaces[0]);
  override_assignment(scene, "a=2");
  const Error error = error_of([&] { override_assignment(scene, "u=0:1"); });
  EXPECT_EQ(marked(error), "u");
}

TEST(Assignments, NameTheParametersByTheirRanges) {
  const auto names = [](const std::vector<std::string>& assignments) {
    Scene scene;
    assign_all(scene, assignments);
    return scene.surfaces.at(0).parameters;
  };
  EXPECT_EQ(names({"z=1"}), (ParameterNames{"u", "v"}));
  EXPECT_EQ(names({"theta=0:1", "z=1"}), (ParameterNames{"theta", "v"}));
  EXPECT_EQ(names({"b=0:1", "a=0:1", "z=1"}), (ParameterNames{"b", "a"}));
  EXPECT_EQ(names({"a=0:1", "u=0:1"}), (ParameterNames{"u", "a"}));
  EXPECT_EQ(names({"v=0:1", "a=0:1"}), (ParameterNames{"a", "v"}));
  EXPECT_EQ(names({"y=0:1", "x=0:1", "z=1"}), (ParameterNames{"x", "y"}));
  EXPECT_EQ(names({"y=0:1"}), (ParameterNames{"u", "y"}));
  EXPECT_EQ(names({"x=0:1", "u=0:1"}), (ParameterNames{"u", "x"}));
  EXPECT_EQ(names({"φ=0:1", "z=1"}), (ParameterNames{"phi", "v"}));
  EXPECT_EQ(names({"t=0:1", "z=1"}), (ParameterNames{"u", "v"}));
  Scene scene;
  assign_all(scene, {"y=2:3", "a=0:1"});
  EXPECT_EQ(scene.surfaces[0].u.max, "1");
  EXPECT_EQ(scene.surfaces[0].v.min, "2");
  EXPECT_THROW(assign_all(scene, {"a=0:1", "b=0:1", "c=0:1"}), Error);
  EXPECT_THROW(assign_all(scene, {"sin=0:1"}), Error);
}

}  // namespace
}  // namespace saddle
