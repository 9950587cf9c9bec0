// What runs say of their meshes: triangles, tolerances, clipping.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace saddle {
namespace {

using Json = nlohmann::json;

class GraphMesh : public ProgramTest {};

TEST_F(GraphMesh, NeedsNoMoreCellsThanTheSurfaceAndItsGridLines) {
  const auto cells = [this](const std::string& grid) {
    const Outcome run = saddle({"z=u", "--grid", grid, "--report", "-"});
    return Json::parse(run.out)["surfaces"][0]["cells"];
  };
  EXPECT_EQ(cells("off"), 1);  // a plane
  EXPECT_EQ(cells("16x5"), 15 * 4);
}

TEST_F(GraphMesh, KeepsTheToleranceThatIsAskedFor) {
  const auto report = [this](const std::string& tolerance, const std::string& more = "--quiet") {
    const Outcome run = saddle({"torus", "--tolerance", tolerance, "--report", "-", more});
    return Json::parse(run.out)["surfaces"][0];
  };
  double before = 0;
  for (const char* tolerance : {"1e-2", "1e-3", "1e-4"}) {
    const Json torus = report(tolerance);
    const double diagonal = std::sqrt(5.6 * 5.6 * 2 + 1.6 * 1.6);
    EXPECT_NEAR(torus["tolerance"], std::stod(tolerance) * diagonal, 0.01 * diagonal);
    EXPECT_LE(torus["max_error"], torus["tolerance"]);
    EXPECT_GT(torus["triangles"], before);
    before = torus["triangles"];
  }
  // Half the pixels, twice the error.
  const double fine = report("0.5px")["tolerance"];
  EXPECT_NEAR(report("1px")["tolerance"], 2 * fine, 1e-9);
}

TEST_F(GraphMesh, KeepsTheStricterToleranceOfPictureAndMesh) {
  const auto tolerance = [this](std::vector<std::string> outputs) {
    outputs.insert(outputs.begin(), "sphere");
    outputs.insert(outputs.end(), {"-s", "64x48", "--report", "-"});
    return Json::parse(saddle(outputs).out)["surfaces"][0]["tolerance"].get<double>();
  };
  const double picture = tolerance({"-o", "a.png"});
  const double mesh = tolerance({"-o", "a.ply"});
  EXPECT_GT(picture, mesh);  // of 64 pixels
  EXPECT_EQ(tolerance({"-o", "a.png", "-o", "a.ply"}), mesh);
}

TEST_F(GraphMesh, StopsAtTheLimitOfTriangles) {
  const Outcome run =
      saddle({"torus", "--tolerance", "1e-5", "--max-triangles", "5000", "--report", "-"});
  const Json torus = Json::parse(run.out)["surfaces"][0];
  EXPECT_LE(torus["triangles"], 5000);
  EXPECT_GT(torus["triangles"], 450);
  EXPECT_TRUE(contains(run.err, "--max-triangles allows more")) << run.err;
}

TEST_F(GraphMesh, ClipsPolesAndSaysSo) {
  const auto high = [this](const std::vector<std::string>& more, bool warns) {
    std::vector<std::string> arguments = {"z=1/u", "--report", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = saddle(arguments);
    EXPECT_TRUE(contains(run.err, "goes to infinity")) << run.err;
    EXPECT_EQ(contains(run.err, "--clip off shows all of it"), warns) << run.err;
    const Json surface = Json::parse(run.out)["surfaces"][0];
    EXPECT_GT(surface["poles_count"], 0);
    return surface["bounds"][1][2].get<double>();
  };
  EXPECT_NEAR(high({}, true), 4, 0.2);  // four times the square's side, low to high
  EXPECT_GT(high({"--clip", "off"}, false), 1000);
  EXPECT_EQ(high({"--clip", "-1:1,-1:1,-4:3"}, false), 3);
  error_of(saddle({"z=u", "--clip", "2:3,2:3,2:3", "--report", "-"}), 3);
  EXPECT_TRUE(contains(saddle({"show", "costa"}).out, "clip = \"-3:3,-3:3,-3:3\""));
  EXPECT_TRUE(contains(error_of(saddle({"z=u", "--clip", "1:2"}), 2), "three ranges"));
  EXPECT_TRUE(contains(error_of(saddle({"z=u", "--clip", "0:1,1:0,0:1"}), 2), "empty"));
}

TEST_F(GraphMesh, ClipsPolesThatFewSamplesGoToward) {
  // The samples go 28 times as far as the square is wide, and most of them go a third of that.
  const Outcome run = saddle({"z=1/(1+cos(u))", "u=-5:5", "v=-5:5", "--report", "-"});
  EXPECT_TRUE(contains(run.err, "goes to infinity")) << run.err;
  EXPECT_LT(Json::parse(run.out)["surfaces"][0]["bounds"][1][2].get<double>(), 50);
}

TEST_F(GraphMesh, ClipsAPoleOnlyWhereTheSurfaceGoes) {
  for (const char* z : {"z=1/(u^2+v^2)", "z=1/(u-1)^2"}) {
    const Outcome run = saddle({z, "--report", "-"});
    EXPECT_TRUE(contains(run.err, "clipped to z up to")) << run.err;
    // The corners that are farthest from the pole are there.
    const double least = z == std::string("z=1/(u^2+v^2)") ? 0.5 : 0.25;
    EXPECT_EQ(Json::parse(run.out)["surfaces"][0]["bounds"][0][2], least) << z;
  }
}

TEST_F(GraphMesh, ClipsWhatOutgrowsItsSamplesBetweenThem) {
  // No pole in double precision: 1-cos(u) is 0 for |u| < 1e-8, and exp(1/u) overflows on one side.
  for (const char* z : {"z=1/(1-cos(u))", "z=exp(1/u)"}) {
    const Outcome run = saddle({z, "u=-5:5", "v=-5:5", "--report", "-"});
    EXPECT_TRUE(contains(run.err, "clipped to z up to")) << run.err;
    const Json surface = Json::parse(run.out)["surfaces"][0];
    EXPECT_LT(surface["bounds"][1][2], 100) << z;
    EXPECT_LE(surface["max_error"], surface["tolerance"]) << z;
  }
  // A box of samples would leave nothing of what none of them has met.
  const Json peak = report_of({"z=1e6*exp(-1e6*(u^2+v^2))"})["surfaces"][0];
  EXPECT_EQ(peak["bounds"][1][2], 1e6);
}

TEST_F(GraphMesh, ShowsWhatIsInProportionOfSurfacesWithSidesAtInfinity) {
  struct Case {
    std::vector<std::string> surface;
    std::size_t axes;  // the first of x, y and z, which are clipped
  };
  // 1.6e16 in doubles is tan(pi/2).
  for (const auto& [surface, axes] : std::vector<Case>{
           {{"x=tan(u)*cos(v)", "y=tan(u)*sin(v)", "z=tan(v)", "u=-pi/2:pi/2", "v=0:pi/2"}, 3},
           {{"x=cos(v)/cos(u)", "y=sin(v)/cos(u)", "z=tan(v)", "u=-pi/2:pi/2", "v=0:pi"}, 3},
           {{"x=v*cos(u)", "y=v*sin(u)", "z=0", "u=0:pi", "v=0:1/abs(sin(u)*cos(u))"}, 2}}) {
    for (const bool adaptive : {true, false}) {
      std::vector<std::string> run = surface;
      run.insert(run.end(), {"--report", "-"});
      if (!adaptive) run.insert(run.end(), {"--samples", "40x40"});
      const Json report = Json::parse(saddle(run).out)["surfaces"][0];
      // Of all meshes that it took to know the box.
      EXPECT_LT(report["evaluations"], 600'000) << surface[0];
      // The strip of the last between its sides at infinity is told not to be whole.
      if (adaptive && axes == 3) {
        EXPECT_LE(report["max_error"], report["tolerance"]) << surface[0];
      }
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const double low = report["bounds"][0][axis];
        const double high = report["bounds"][1][axis];
        EXPECT_LT(high - low, 20) << surface[0];
      }
    }
  }
}

TEST_F(GraphMesh, ClipsAsMuchAboveAsBelowOfWhatIsOdd) {
  for (const std::vector<std::string>& formula :
       std::vector<std::vector<std::string>>{{"z=1/sin(u)", "u=-7:7"},
                                             {"z=csc(u)+cot(v)", "u=-5:5", "v=-5:5"},
                                             {"z=(u+v)/(u-v)", "u=-2:2", "v=-2:2"}}) {
    std::vector<std::string> arguments = formula;
    arguments.insert(arguments.end(), {"--report", "-"});
    const Json bounds = Json::parse(saddle(arguments).out)["surfaces"][0]["bounds"];
    const auto low = bounds[0][2].get<double>();
    const auto high = bounds[1][2].get<double>();
    EXPECT_NEAR(-low, high, 1e-3 * high) << formula[0];
  }
}

TEST_F(GraphMesh, FindsWavesThatKeepStepWithEvenGrids) {
  const Outcome run = saddle({"z=sin(60*u)/10", "u=0:tau", "--report", "-"});
  const Json waves = Json::parse(run.out)["surfaces"][0];
  EXPECT_NEAR(waves["bounds"][1][2], 0.1, 1e-3);
  EXPECT_LE(waves["max_error"], waves["tolerance"]);
  EXPECT_EQ(run.err, "");
}

TEST_F(GraphMesh, DrawsHeightFieldsThatAreNearlyUpright) {
  const Json report = report_of({"z=1e9*u*v"})["surfaces"][0];
  EXPECT_GT(report["triangles"], 700);  // of 800; some in the middle have no area beside 1e9
}

TEST_F(GraphMesh, WarnsOfAMeshThatIsNotAllowedToBeFineEnough) {
  const Outcome run =
      saddle({"z=sin(1/u)", "-s", "64x48", "--max-triangles", "2000", "--report", "-"});
  EXPECT_TRUE(contains(run.err, "the limit of triangles stopped refinement, the mesh is off by"))
      << run.err;
}

TEST_F(GraphMesh, RefusesWhatIsALineInDoublePrecision) {
  const Outcome run = small({"x=u", "y=u+1e-14*v", "z=u", "--report", "-"});
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "the surface is a line in double precision")) << run.err;
}

TEST_F(GraphMesh, OfAPictureIsWithinToleranceWhereCreasesMeetRims) {
  // Creases that are found late cut leaves once more that were near enough.
  const Outcome run = saddle({"z=sqrt(abs(u)-abs(v))", "-o", "a.png", "--report", "-"});
  const Json surface = Json::parse(run.out)["surfaces"][0];
  EXPECT_LE(surface["max_error"], surface["tolerance"]);
}

}  // namespace
}  // namespace saddle
