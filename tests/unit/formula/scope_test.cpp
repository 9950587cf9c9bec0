#include "formula/scope.h"

#include <gtest/gtest.h>

#include <array>

#include "graph_value.h"

namespace saddle {
namespace {

double value_with(const std::string& text, std::vector<Definition> definitions, double u = 0,
                  double v = 0) {
  Graph graph;
  const NodeId root = testing::parse(graph, text, std::move(definitions));
  return testing::value(graph, root, u, v);
}

Error error_of(std::vector<Definition> definitions) {
  Graph graph;
  try {
    const Scope scope(graph, std::move(definitions));
  } catch (const Error& error) {
    return error;
  }
  return {Status::Done, "no error"};
}

TEST(Scope, TakesDefinitionsInAnyOrder) {
  EXPECT_EQ(value_with("w*u", {{"w", "b+1"}, {"b", "2*a"}, {"a", "3"}}, 2), 14);
}

TEST(Scope, LetsTheSurfaceUseItsOwnCoordinates) {
  Graph graph;
  Scope scope(graph, {{"x", "u"}, {"y", "v"}, {"z", "x^2-y^2"}});
  EXPECT_EQ(testing::value(graph, scope.node("z"), 3, 2), 5);
}

TEST(Scope, CallsHelperFunctionsOfSeveralArguments) {
  EXPECT_EQ(value_with("f(u,2)+f(1,v)", {{"f", "10*a+b", {"a", "b"}, true}}, 3, 4), 46);
}

TEST(Scope, LetsArgumentsShadowEveryOtherName) {
  EXPECT_EQ(value_with("f(5,6)", {{"f", "u-v", {"u", "v"}, true}}, 100, 100), -1);
  EXPECT_EQ(value_with("f(5)", {{"f", "pi", {"pi"}, true}}), 5);
  EXPECT_EQ(value_with("f(5)", {{"f", "2*a", {"a"}, true}, {"a", "7"}}), 10);
}

TEST(Scope, LetsDefinitionsShadowConstants) {
  EXPECT_EQ(value_with("e+1", {{"e", "5"}}), 6);
}

TEST(Scope, LetsFunctionsUseDefinitionsAndOtherFunctions) {
  EXPECT_EQ(
      value_with("g(2)", {{"g", "f(s)+a", {"s"}, true}, {"f", "s^2", {"s"}, true}, {"a", "1"}}), 5);
}

TEST(Scope, ShowsTheCircle) {
  const Error error = error_of({{"a", "b+1"}, {"b", "2*c"}, {"c", "a"}});
  EXPECT_STREQ(error.what(), "a definition that needs itself: a -> b -> c -> a");
  EXPECT_STREQ(error_of({{"f", "f(s-1)", {"s"}, true}}).what(),
               "a definition that needs itself: f -> f");
}

TEST(Scope, RefusesNamesThatAreTaken) {
  EXPECT_STREQ(error_of({{"sin", "3"}}).what(), "'sin' is a function of the language");
  EXPECT_STREQ(error_of({{"u", "3"}}).what(), "'u' cannot be defined");
  EXPECT_STREQ(error_of({{"a", "3"}, {"a", "4"}}).what(), "'a' is defined twice");
  EXPECT_STREQ(error_of({{"f", "s", {"s", "s"}, true}}).what(), "two arguments are called 's'");
}

TEST(Scope, ParsesDefinitionsThatNobodyUses) {
  const Error error = error_of({{"f", "1+foo", {"s"}, true}});
  EXPECT_EQ(error.place().name, "f(s)");
  EXPECT_EQ(error.place().span.begin, 2U);
}

TEST(Scope, SaysWhatIsNotConstant) {
  Graph graph;
  Scope scope(graph, {{"a", "2"}});
  EXPECT_EQ(scope.constant("u", "0:2*a", Span{2, 5}), 4);
  try {
    scope.constant("u", "0:2*v", Span{2, 5});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().text, "0:2*v");
    EXPECT_EQ(error.place().span.begin, 2U);
  }
}

TEST(Scope, ListsItsConstantsWithTheirValues) {
  Graph graph;
  const Scope scope(graph, {{"a", "2"}, {"b", "a^2"}, {"w", "u*a"}, {"x", "1"}});
  const std::unordered_map<Symbol, double> expected = {{graph[scope.node("a")].symbol, 2}};
  EXPECT_EQ(scope.constants(), expected);
}

/// A definition of one surface.
Definition own(const std::string& name, const std::string& text) {
  return {name, text, {}, false, true};
}

TEST(Scope, LetsOwnDefinitionsHideSharedOnes) {
  Graph graph;
  Scope scope(graph, {{"a", "2"}, {"w", "10*a"}, own("a", "3"), {"z", "u+100*a+w"}});
  const NodeId bound = scope.bind(std::array{scope.node("z")}, 0)[0];
  EXPECT_EQ(testing::value(graph, bound, 1, 0), 1 + 300 + 20);  // w does not see the own a
  EXPECT_EQ(scope.constant("number", "a"), 3);
  Scope::View shared;
  shared.of_surface = false;
  Graph other;
  Scope outside(other, {{"a", "2"}, own("a", "3")}, shared);
  EXPECT_EQ(outside.constant("number", "a"), 2);
}

TEST(Scope, CallsParametersByTheirNames) {
  Graph graph;
  Scope scope(graph, {{"phi", "7"}, {"w", "10*phi"}, {"z", "theta+100*phi+w"}},
              {.parameters = {"theta", "phi"}});
  const NodeId bound = scope.bind(std::array{scope.node("z")}, 0)[0];
  EXPECT_EQ(testing::value(graph, bound, 1, 2), 1 + 200 + 70);  // a shared phi is hidden, not in w
  EXPECT_THROW(scope.parse("z", "u+1"), Error);
  EXPECT_THROW(Scope(graph, {own("theta", "1")}, {.parameters = {"theta", "phi"}}), Error);
}

TEST(Scope, ParsesLazilyWhatOtherSurfacesMean) {
  Graph graph;
  EXPECT_THROW(Scope(graph, {{"w", "theta"}, {"z", "u"}}), Error);
  Scope scope(graph, {{"w", "theta"}, {"z", "u"}}, {.lazy = true});
  EXPECT_THROW(scope.node("w"), Error);
  EXPECT_THROW(Scope(graph, {{"z", "theta"}}, {.lazy = true}), Error);
}

TEST(Scope, BindsTheTime) {
  Graph graph;
  Scope scope(graph, {{"z", "u+t"}});
  const NodeId bound = scope.bind(std::array{scope.node("z")}, 10)[0];
  EXPECT_EQ(testing::value(graph, bound, 1, 0), 11);
}

TEST(Scope, StopsFunctionsThatMultiply) {
  std::vector<Definition> definitions = {{"f0", "sin(s)", {"s"}, true}};
  for (int i = 1; i <= 60; ++i) {
    const std::string inner = "f" + std::to_string(i - 1);
    definitions.push_back({"f" + std::to_string(i),
                           inner + "(s)*" + inner + "(s+" + std::to_string(i) + ")",
                           {"s"},
                           true});
  }
  EXPECT_STREQ(error_of(definitions).what(), "the formulas grow past 100000 operations");
}

TEST(Scope, StopsChainsThatAreTooDeep) {
  std::vector<Definition> definitions;
  for (int i = 0; i < 2000; ++i) {
    definitions.push_back({"a" + std::to_string(i), "a" + std::to_string(i + 1)});
  }
  definitions.push_back({"a2000", "1"});
  EXPECT_STREQ(error_of(definitions).what(), "definitions use each other more than 256 deep");
}

TEST(Scope, KnowsWhichConstantsTimeChanges) {
  Graph graph;
  Scope scope(graph, {{"a", "2"}, {"w", "a*t"}});
  EXPECT_EQ(scope.constant("n", "a+1", {}, 5), 3);
  EXPECT_EQ(scope.constant("n", "a+1"), 3);
  EXPECT_FALSE(scope.has_used_time());
  EXPECT_EQ(scope.constant("n", "w+1", {}, 5), 11);
  EXPECT_EQ(scope.constant("other", "w+1", {}, 5), 11);
  EXPECT_EQ(scope.constant("n", "w+1", {}, 7), 15);
  EXPECT_TRUE(scope.has_used_time());
  EXPECT_THROW(scope.constant("n", "w+1"), Error);
  EXPECT_THROW(scope.constant("n", "u", {}, 7), Error);
}

}  // namespace
}  // namespace saddle
