// saddle check and --strict.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/program.h"

namespace saddle {
namespace {

using Json = nlohmann::json;

constexpr double kPi = std::numbers::pi;

class CheckCommand : public ProgramTest {
 protected:
  std::string words(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "check");
    const Outcome run = saddle(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  }
  Json facts(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "check");
    arguments.insert(arguments.end(), {"--report", "-"});
    const Outcome run = saddle(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out)["surfaces"][0];
  }
  Json written(const std::string& name) const {
    std::ifstream in(path(name));
    return Json::parse(in);
  }
};

TEST_F(CheckCommand, SaysWhatIsTrueOfASphere) {
  const std::string text = words({"sphere"});
  for (const char* part :
       {"domain      u = 0:6.28319, v = -1.5708:1.5708", "everywhere (proved)", "poles       none",
        "is the point (0, 0, 1) with the normal (0, 0, 1)", "u = 0 and u = 6.28319 join",
        "sides       two", "Euler number 2 (a sphere), closed", "area        12.5664",
        "volume      4.18879", "Gauss 1 to 1, mean -1 to -1", "times the least possible",
        "within 4 tolerances of the mesh everywhere (proved)"}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(CheckCommand, ClosesASurfaceWhoseEdgesAreFolded) {
  const std::string text = words({"pillow"});
  EXPECT_TRUE(contains(text, "u = 0 is folded: its halves join; u = 3.14159 is folded")) << text;
  EXPECT_TRUE(contains(text, "Euler number 2 (a sphere), closed")) << text;
  const Json pillow = facts({"pillow"});
  ASSERT_EQ(pillow["folded"].size(), 2U);
  EXPECT_EQ(pillow["folded"][0]["u"], 0);
  EXPECT_TRUE(pillow["closed_u"].is_null());
  // Twice the integral of sin(u) sin(v) / 2 over the square, in x = cos(u) and y = cos(v).
  EXPECT_NEAR(pillow["volume"].get<double>(), kPi * kPi / 4, 1e-9);
  EXPECT_TRUE(facts({"torus"})["folded"].empty());
}

TEST_F(CheckCommand, TellsSingularPointsFromLinesAndCurves) {
  const auto says = [&](const std::string& name, const std::string& part) {
    const std::string text = words({name});
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  };
  says("torus", "singular    none\n");
  says(
      "whitney-umbrella",
      "singular    1 point: u = 0, v = 0 is the point (0, 0, 0) with a normal on each way there\n");
  says("catalan", "u = 0, v = 0 is the point (0, 0, 0) with the normal (1, 0, 0)");
  says("pseudosphere", "singular    1 line: u = 0:6.28319, v = 0 has a normal on each side\n");
  says("swallowtail", "singular    curves: within u = -2:0, v = -0.57735:0.57735 has");
  says("bourke-harmonic", "singular    curves: within u = 0:6.28319, v = 1.04");
  says("bent-horns",
       "v = 0 is the point (0, 0, 0) with a normal on each side. 8 points: within u = -1.31");
  // Whether or not a line of the mesh is there by chance.
  for (const char* tolerance : {"0.05", "1e-3", "1e-5"}) {
    const std::string text = words({"z=sqrt(u)", "--tolerance", tolerance});
    EXPECT_TRUE(contains(text, "singular    1 line: u = 0, v = -1:1 has the normal (-1, 0, 0)\n"))
        << text;
  }
  // Of a limit as many decimals as are known.
  says("z=1/3+(u^2+v^2)/hypot(u,v)", "v = 0 is the point (0, 0, 0.3333) with a normal on each way");
  // At a corner of the domain, too, it depends on the way.
  says("pillow", "singular    4 points: ");
  const Json pillow = facts({"pillow"});
  for (const Json& place : pillow["singular_points"]) {
    EXPECT_TRUE(place["isolated"]);
    EXPECT_TRUE(place["normal"].is_null());
    EXPECT_GE(place["normals"].size(), 2U);
  }
  const Json sphere = facts({"sphere"});
  for (const Json& place : sphere["singular_places"]) EXPECT_FALSE(place["isolated"]);
}

TEST_F(CheckCommand, CountsSingularPointsOfSpace) {
  const Json sphere = facts({"sphere"});
  EXPECT_EQ(sphere["singular_points_count"], 2);
  ASSERT_EQ(sphere["singular_points"].size(), 2U);
  EXPECT_GT(sphere["singular_places_count"], 2);
  for (const Json& pole : sphere["singular_points"]) {
    EXPECT_TRUE(pole["isolated"]);
    EXPECT_NEAR(pole["normal"][2].get<double>(), pole["position"][2].get<double>(), 1e-9);
  }
  const Json cone = facts({"x=v*cos(u)", "y=v*sin(u)", "z=v", "u=0:2*pi", "v=0:1"});
  EXPECT_EQ(cone["singular_points_count"], 1);
  EXPECT_TRUE(cone["singular_points"][0]["normal"].is_null());
  EXPECT_GE(cone["singular_points"][0]["normals"].size(), 2U);
}

TEST_F(CheckCommand, TellsUnboundedCurvatureAsSuch) {
  const std::vector<std::string> cone = {"x=v*cos(u)", "y=v*sin(u)", "z=-v", "u=0:2*pi", "v=0:1"};
  const Json json = facts(cone);
  EXPECT_TRUE(json["mean_curvature"][1].is_null() != json["mean_curvature"][0].is_null());
  const Json& places = json["mean_curvature_unbounded"];
  ASSERT_EQ(places.size(), 2U);
  EXPECT_TRUE(places[0].is_null() != places[1].is_null());
  EXPECT_EQ(json["gauss_curvature_unbounded"], (Json{nullptr, nullptr}));
  EXPECT_TRUE(contains(words(cone), " without a bound near u = ")) << words(cone);
}

TEST_F(CheckCommand, TellsOfAHoleThatTheMeshCovers) {
  const std::vector<std::string> torus = {"x=(2+cos(v))*cos(u)", "y=(2+cos(v))*sin(u)",
                                          "z=sin(v)+0*sqrt((u-1)^2+(v-1)^2-1e-10)", "u=0:2*pi",
                                          "v=0:2*pi"};
  const Json json = facts(torus);
  EXPECT_EQ(json["closed"], false);
  EXPECT_TRUE(json["volume"].is_null());
  EXPECT_NEAR(json["undefined_at"]["u"].get<double>(), 1, 1e-5);
  EXPECT_GT(json["undefined_fraction"], 0);
  const std::string text = words(torus);
  EXPECT_TRUE(contains(text, "defined     not ")) << text;
  EXPECT_FALSE(contains(text, "volume")) << text;
  EXPECT_TRUE(facts({"torus"})["undefined_at"].is_null());
  EXPECT_EQ(facts({"torus"})["closed"], true);
}

TEST_F(CheckCommand, TellsHowFarOffNumbersMayBe) {
  const Json dome = facts({"z=sqrt(1-u^2-v^2)"});
  EXPECT_LE(std::fabs(dome["area"].get<double>() - 2 * kPi), dome["area_error"].get<double>());
  const Json torus = facts({"torus"});
  EXPECT_LE(torus["volume_error"], 1e-9);
  EXPECT_LE(torus["gauss_curvature_bounds"][0], torus["gauss_curvature"][0]);
  EXPECT_GE(torus["gauss_curvature_bounds"][1], torus["gauss_curvature"][1]);
  EXPECT_TRUE(contains(words({"torus"}), "(found by a search; proved: Gauss within "));
}

TEST_F(CheckCommand, FindsNothingSingularWhereZeroByZeroHasLimits) {
  for (const char* const z : {"z=(u^3-v^3)/(u-v)", "z=sin(u-v)/(u-v)"}) {
    EXPECT_TRUE(contains(words({z}), "singular    none\n")) << z;
  }
}

TEST_F(CheckCommand, TellsAPoleOnceFromHoweverManySidesItWasCut) {
  EXPECT_TRUE(contains(words({"z=1/(u^2+v^2)"}), "poles       1 place: u = 0, v = 0\n"));
}

/// A point without a limit is none of the cuts.
TEST_F(CheckCommand, TellsOfTheSameJumpsAsTheReportAndTheWarnings) {
  const Outcome run = saddle({"check", "z=atan2(v,u)", "--report", path("r.json").string()});
  const Json report = written("r.json");
  EXPECT_EQ(report["surfaces"][0]["jumps"].size(), report["surfaces"][0]["jumps_count"]);
  EXPECT_TRUE(contains(run.err, "jumps and is cut there: u = -1:-0.00")) << run.err;
  EXPECT_TRUE(contains(run.err, "no limit at u = 0, v = 0:")) << run.err;
  EXPECT_TRUE(contains(run.out, "jumps       u = -1:-0.00")) << run.out;
  EXPECT_TRUE(contains(run.out, "; no limit at u = 0, v = 0\n")) << run.out;
  EXPECT_TRUE(contains(words({"z=u*v/(u^2+v^2)"}), "jumps       no limit at u = 0, v = 0\n"));
}

TEST_F(CheckCommand, SaysOnWhichShareOfTheDomainItsProofHolds) {
  EXPECT_TRUE(contains(words({"z=sign(u*v)"}),
                       "% of the domain within 4 tolerances of the mesh (proved), but for"));
}

TEST_F(CheckCommand, TellsCurvesAsCurvesHoweverManyCellsTheyCross) {
  EXPECT_TRUE(
      contains(words({"z=floor(3*u)", "u=0.1:0.9"}), "jumps       u = 0.333333, v = -1:1;"));
  EXPECT_TRUE(contains(words({"z=sign(u^2+v^2-0.5)"}), "jumps       within u = -0.7"));
}

TEST_F(CheckCommand, TellsAPointOnASeamOnce) {
  // The tangents of its two circles are parallel at (+-1/2, 0, +-1), and at u = 0 as at 2*pi.
  const std::string dome = words({"bohemian-dome"});
  EXPECT_TRUE(contains(dome, "singular    4 points: ")) << dome;
  EXPECT_TRUE(contains(dome, "volume      0 within ")) << dome;
}

TEST_F(CheckCommand, TellsSizesThatDoublesCannotHold) {
  const std::string small = words({"sphere", "r=1e-60"});
  EXPECT_TRUE(contains(small, "volume      4.18879e-180\n")) << small;
  const std::string none = words({"sphere", "r=1e-110"});
  EXPECT_TRUE(contains(none, "area        too small for doubles\n")) << none;
  EXPECT_TRUE(contains(none, "volume      too small for doubles\n")) << none;
}

/// What a description says in the line that begins with a word.
std::string line_of(const std::string& text, const std::string& word) {
  const std::size_t begin = text.find("  " + word + " ") + 14;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST_F(CheckCommand, CountsLinesOfJumpsFromEndToEnd) {
  const auto jumps = [&](const char* formula) { return line_of(words({formula}), "jumps"); };
  // The last one is at the end of the range.
  const char* const six = " = -0.99, -0.98, -0.97, -0.96, -0.95, -0.94 and others";
  EXPECT_EQ(jumps("z=mod(u*100,1)"), std::string("200 lines of constant u, u") + six);
  EXPECT_EQ(jumps("z=mod(v*100,1)"), std::string("200 lines of constant v, v") + six);
  EXPECT_EQ(jumps("z=mod(u*4,1)+step(0.1,v)*(u>0.9)"),
            "8 lines of constant u, u = -0.75, -0.5, -0.25, 0, 0.25, 0.5 and others; "
            "within u = 0.9:0.999479, v = 0.1:1");
  EXPECT_EQ(jumps("z=sign(u)"), "u = 0, v = -1:1");
  // Hyperbolas that end at the same parameters of both edges.
  EXPECT_FALSE(contains(jumps("z=mod(10*u*v,1)"), "lines of constant"));
}

TEST_F(CheckCommand, CountsLinesOfPolesFromEndToEnd) {
  const auto poles = [&](const char* formula) { return line_of(words({formula}), "poles"); };
  const char* const six =
      " = -0.989602, -0.958186, -0.92677, -0.895354, -0.863938, -0.832522 and others";
  EXPECT_EQ(poles("z=tan(100*u)"), std::string("64 lines of constant u, u") + six);
  EXPECT_EQ(poles("z=tan(100*v)"), std::string("64 lines of constant v, v") + six);
  EXPECT_EQ(poles("z=1/u"), "u = 0, v = -1:1");
  EXPECT_EQ(poles("z=1/(u^2+v^2)"), "1 place: u = 0, v = 0");
}

TEST_F(CheckCommand, SaysWhereNothingIsProvedAndWhy) {
  EXPECT_TRUE(facts({"torus"})["uncertified"].empty());
  EXPECT_TRUE(facts({"z=abs(u)"})["uncertified"].empty());
  const Json jump = facts({"z=sign(u)"})["uncertified"];
  ASSERT_EQ(jump.size(), 1U) << jump;
  EXPECT_EQ(jump[0]["reason"], "jump");
  EXPECT_LE(jump[0]["u"][0], 0);
  EXPECT_GE(jump[0]["u"][1], 0);
  EXPECT_LT(jump[0]["u"][1].get<double>() - jump[0]["u"][0].get<double>(), 0.3);
  EXPECT_EQ(jump[0]["v"], (Json{-1.0, 1.0}));
  const struct {
    std::vector<std::string> arguments;
    const char* reason;
    const char* words;
  } cases[] = {
      {{"z=sqrt(0.5-u^2-v^2)"}, "rim", "but for places where the surface ends there: u = -0.7"},
      {{"z=1/(u-0.3)"}, "pole", "it goes to infinity: u = 0."},
      {{"z=abs(sin(20*u)-v)"}, "crease", "but for places where it has a crease: u = "},
      {{"z=2*u*v/(u^2+v^2)"}, "no limit", "each way leads to another place: u = -"},
      {{"z=sin(9*u*v)", "--max-triangles", "500"},
       "limit of triangles",
       "samples only: --max-triangles stopped refinement: u = -1:1, v = -1:1"},
      {{"z=u*v", "--samples", "9x9"}, "not tried", "samples only: nothing was proved"},
  };
  for (const auto& [arguments, reason, said] : cases) {
    const Json surface = facts(arguments);
    EXPECT_EQ(surface["certified"], false);
    const Json& places = surface["uncertified"];
    EXPECT_TRUE(std::ranges::any_of(
        places, [&, name = reason](const Json& place) { return place["reason"] == name; }))
        << reason << ": " << places;
    EXPECT_TRUE(contains(words(arguments), said)) << words(arguments);
  }
}

TEST_F(CheckCommand, ListsAllFindings) {
  const std::string text = words({"bourke-harmonic"});
  EXPECT_TRUE(contains(text, "finding     ")) << text;
  EXPECT_TRUE(contains(text, " of the domain is not proved")) << text;
  EXPECT_TRUE(contains(words({"z=u"}), "(proved: at most 0)"));
  EXPECT_TRUE(contains(words({"torus"}), "(a search found 0.0"));
}

TEST_F(CheckCommand, NamesTheKindOfSurface) {
  EXPECT_TRUE(contains(words({"torus"}), "(a torus), closed"));
  EXPECT_TRUE(contains(words({"cylinder"}), "(a band), 2 edges"));
  EXPECT_TRUE(contains(words({"z=u*v"}), "(a disc), one edge"));
  EXPECT_TRUE(contains(words({"mobius"}), "(a Moebius band), one edge"));
  EXPECT_TRUE(contains(words({"klein-bottle"}), "(a Klein bottle), closed"));
  EXPECT_TRUE(contains(words({"costa"}), "(a torus with 3 holes), 3 edges"));
  EXPECT_TRUE(contains(words({"mobius"}), "one: the surface is not orientable"));
  EXPECT_TRUE(contains(words({"mobius"}), "join reversed"));
}

TEST_F(CheckCommand, TellsPlacesAlongALineAsOne) {
  EXPECT_TRUE(contains(words({"z=1/u"}), ": u = 0, v = -1:1\n"));
  EXPECT_TRUE(contains(words({"z=floor(v/2+0.3)"}), ": u = -1:1, v = -0.6\n"));
}

TEST_F(CheckCommand, ReportsFactsAsJson) {
  const Json sphere = facts({"sphere"});
  EXPECT_EQ(sphere["euler_number"], 2);
  EXPECT_EQ(sphere["components"], 1);
  EXPECT_EQ(sphere["closed"], true);
  EXPECT_EQ(sphere["open_edges"], 0);
  EXPECT_EQ(sphere["boundary_loops"], 0);
  EXPECT_EQ(sphere["proved_defined_fraction"], 1);
  EXPECT_EQ(sphere["proved_undefined_fraction"], 0);
  EXPECT_NEAR(sphere["extents"][1][0].get<double>(), 1, 1e-12);
  EXPECT_NEAR(sphere["area"].get<double>(), 12.566370614359172, 1e-10);
  EXPECT_NEAR(sphere["volume"].get<double>(), 4.18879020478639, 1e-10);
  EXPECT_NEAR(sphere["gauss_curvature"][1].get<double>(), 1, 1e-9);
  EXPECT_NEAR(sphere["mean_curvature"][0].get<double>(), -1, 1e-9);
  EXPECT_EQ(sphere["domain"]["u"][0], 0);
  EXPECT_GT(sphere["least_triangles"], 1000);
  EXPECT_NEAR(sphere["singular_points"][0]["normal"][2].get<double>(), -1, 1e-9);
  const Json band = facts({"mobius"});
  EXPECT_EQ(band["orientable"], false);
  EXPECT_TRUE(band["volume"].is_null());
  EXPECT_EQ(band["boundary_loops"], 1);
}

TEST_F(CheckCommand, PrintsEitherWordsOrJsonOnStandardOutput) {
  const Outcome both = saddle({"check", "torus", "--report", "r.json"});
  EXPECT_TRUE(contains(both.out, "Euler number 0"));
  EXPECT_EQ(written("r.json")["surfaces"][0]["euler_number"], 0);
}

TEST_F(CheckCommand, IsAVerbOnlyAsTheFirstArgument) {
  EXPECT_TRUE(contains(error_of(saddle({"torus", "check", "--report", "-"}), 2), "'check'"));
}

TEST_F(CheckCommand, WritesNothingElse) {
  EXPECT_TRUE(contains(error_of(saddle({"check", "torus", "-o", "a.png"}), 2), "no pictures"));
  EXPECT_TRUE(files().empty());
}

TEST_F(CheckCommand, KnowsNoLeastNumberOfTrianglesOfAPart) {
  const Json part = facts({"torus", "--clip", "0:3,-3:3,-1:1"});
  EXPECT_TRUE(part["efficiency"].is_null());
  EXPECT_EQ(part["least_triangles"], 0);
  EXPECT_FALSE(contains(words({"torus", "--clip", "0:3,-3:3,-1:1"}), "least"));
  EXPECT_TRUE(contains(words({"cylinder"}), "unrolls into a plane"));
}

TEST_F(CheckCommand, SaysThatDoublesCannotHoldTheSurface) {
  EXPECT_TRUE(contains(error_of(saddle({"check", "z=u*1e300"}), 3), "in double precision"));
  EXPECT_TRUE(contains(error_of(saddle({"check", "z=1e150*u*v"}), 3), "as long along z"));
  const std::vector<std::string> partly = {"z=exp(u^2)-exp(v^2)", "u=-30:30"};
  EXPECT_TRUE(contains(
      words(partly), "everywhere (proved), but larger than doubles can hold on 11.1942 % of the"));
  EXPECT_TRUE(facts(partly)["exceeds_doubles"]);
  EXPECT_FALSE(facts({"z=sqrt(u)+exp(u^2)", "u=-30:30"})["exceeds_doubles"]);
}

TEST_F(CheckCommand, SaysThatThereIsNothing) {
  error_of(saddle({"check", "z=sqrt(-1-u^2)"}), 3);
  error_of(saddle({"check"}), 2);
}

TEST_F(CheckCommand, StrictFailsOnWarningsAndWritesTheReportAlone) {
  const std::vector<std::string> hole = {"z=sqrt(u)", "-o",       "a.png",
                                         "--strict",  "--report", "r.json"};
  const std::string message = error_of(saddle(hole), 2);
  EXPECT_TRUE(contains(message, "--strict: a warning")) << message;
  EXPECT_TRUE(contains(message, "50 % of the domain is undefined")) << message;
  EXPECT_EQ(files(), std::vector<std::string>{"r.json"});
  EXPECT_EQ(written("r.json")["warnings"].size(), 1U);
  EXPECT_EQ(saddle({"torus", "-o", "b.ply", "--strict"}).status, 0);
  const Outcome checked = saddle({"check", "mobius", "--strict"});
  EXPECT_EQ(checked.status, 2);
  EXPECT_TRUE(contains(checked.out, "Moebius band")) << "the facts are told all the same";
}

}  // namespace
}  // namespace saddle
