// What runs write: pictures, meshes, reports, comparisons.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/image_png.h"
#include "cli/program.h"

namespace saddle {
namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string>;

class GraphCommand : public ProgramTest {
 protected:
  /// Runs and expects success without a word.
  Outcome done(const std::vector<std::string>& arguments) {
    Outcome run = small(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return run;
  }
  /// The report of a mesh file within its tolerance.
  Json meshed(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", "a.ply", "--report", "-"});
    const Outcome run = saddle(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out);
  }
  Image picture(const std::string& name) { return read_png(path(name)).image; }
};

TEST_F(GraphCommand, WritesAPictureThatCarriesItsScene) {
  done({"torus", "r=0.5", "--background", "white", "-o", "a.png"});
  const PngFile file = read_png(path("a.png"));
  EXPECT_EQ(file.image.width, 64);
  EXPECT_EQ(file.image.height, 48);
  EXPECT_TRUE(contains(file.text.at("saddle-scene"), "\nr = 0.5\n"));
  EXPECT_TRUE(contains(file.text.at("saddle-scene"), "background = \"#ffffff\"\n"));
  EXPECT_EQ(files(), Names{"a.png"});
}

TEST_F(GraphCommand, WritesSeveralOutputsInOneRun) {
  done({"z=u*v", "-o", "a.png", "-o", "b.PLY", "--output", "c.png"});
  EXPECT_EQ(files(), (Names{"a.png", "b.PLY", "c.png"}));
  EXPECT_EQ(read_file(path("a.png")), read_file(path("c.png")));
  EXPECT_TRUE(read_file(path("b.PLY")).starts_with("ply\nformat binary_little_endian 1.0\n"));
}

TEST_F(GraphCommand, WritesToStandardOutput) {
  EXPECT_TRUE(done({"z=u*v", "-o", "-", "--format", "png"}).out.starts_with("\x89PNG\r\n"));
  EXPECT_TRUE(done({"z=u*v", "-o", "-", "--format", "ply"}).out.starts_with("ply\n"));
  EXPECT_TRUE(contains(error_of(saddle({"z=u", "-o", "-"}), 2), "--format"));
  EXPECT_TRUE(contains(error_of(saddle({"z=u", "-o", "-", "--format", "png", "--report", "-"}), 2),
                       "only one"));
}

TEST_F(GraphCommand, FormatNamesWhatTheExtensionDoesNot) {
  done({"z=u*v", "-o", "mesh", "--format", "ply"});
  EXPECT_TRUE(read_file(path("mesh")).starts_with("ply\n"));
}

TEST_F(GraphCommand, NoticesThatStandardOutputIsFull) {
  const Outcome run = run_saddle({"show", "torus"}, folder_, "/dev/full");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.err, "standard output")) << run.err;
}

TEST_F(GraphCommand, LeavesNothingBehindWhereItCannotWrite) {
  EXPECT_TRUE(contains(error_of(small({"torus", "-o", "none/a.png"}), 1), "none/a.png"));
  EXPECT_TRUE(
      contains(error_of(small({"torus", "-o", "a.png", "--report", "none/r"}), 1), "none/r"));
  std::filesystem::create_directory(path("folder.png"));
  error_of(small({"torus", "-o", "folder.png"}), 1);
  EXPECT_EQ(files(), Names{"folder.png"});
}

TEST_F(GraphCommand, LooksAtItsOutputsBeforeItComputes) {
  // Computing would find out that there is nothing to draw: status 3.
  error_of(small({"z=sqrt(-1-u^2)", "-o", "none/a.png"}), 1);
  error_of(small({"z=sqrt(-1-u^2)", "--report", "none/a.json"}), 1);
}

TEST_F(GraphCommand, HasNothingToDrawWhereNothingIsDefined) {
  EXPECT_TRUE(contains(error_of(small({"z=sqrt(-1-u^2)", "-o", "a.png"}), 3), "undefined"));
  error_of(small({"x=1", "y=2", "z=3", "-o", "a.png"}), 3);
  EXPECT_TRUE(files().empty());
}

TEST_F(GraphCommand, ReportsTheKeysThatScriptsReadInOrder) {
  const Outcome run = done({"sphere", "-o", "a.png", "--report", "r.json"});
  EXPECT_EQ(run.out, "");
  const auto report = nlohmann::ordered_json::parse(read_file(path("r.json")));
  Names keys;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  EXPECT_EQ(keys, (Names{"version", "surfaces", "image", "times", "peak_memory_bytes", "warnings",
                         "findings"}));
  keys.clear();
  for (const auto& [key, value] : report["surfaces"][0].items()) keys.push_back(key);
  EXPECT_EQ(keys, (Names{"name",
                         "cells",
                         "triangles",
                         "vertices",
                         "evaluations",
                         "bounds",
                         "tolerance",
                         "max_error",
                         "max_error_is",
                         "max_normal_error",
                         "undefined_fraction",
                         "outside_fraction",
                         "efficiency",
                         "singular_points",
                         "singular_points_count",
                         "singular_places",
                         "singular_places_count",
                         "poles",
                         "poles_count",
                         "jumps",
                         "jumps_count",
                         "closed_u",
                         "closed_v",
                         "orientable",
                         "certified",
                         "proved_fraction",
                         "uncertified",
                         "culls_backs"}));
  keys.clear();
  for (const auto& [key, value] : report["times"].items()) keys.push_back(key);
  EXPECT_EQ(keys, (Names{"parse", "compile", "tessellate", "context", "upload", "draw", "encode",
                         "total"}));
}

TEST_F(GraphCommand, ReportsWhatItFound) {
  const Json report = report_of({"cylinder"});
  const Json& surface = report["surfaces"][0];
  EXPECT_EQ(surface["name"], "cylinder");
  EXPECT_EQ(surface["cells"], 400);
  EXPECT_EQ(surface["triangles"], 800);
  EXPECT_EQ(surface["closed_u"], "join");
  EXPECT_TRUE(surface["closed_v"].is_null());
  EXPECT_EQ(surface["undefined_fraction"], 0);
  EXPECT_EQ(surface["bounds"][0][2], -1);
  EXPECT_EQ(surface["bounds"][1][2], 1);
  EXPECT_TRUE(report["warnings"].empty());
  EXPECT_GT(report["peak_memory_bytes"], 100000);  // even the program itself is larger
}

/// The resource usage of a process includes the memory that it had before exec.
TEST_F(GraphCommand, ReportsTheMemoryOfSaddleAloneWhoeverStartedIt) {
  constexpr std::size_t kMuch = 400'000'000;
  const auto use_much = [] {
    std::vector<char> much(kMuch, 1);
    asm volatile("" : : "r"(much.data()) : "memory");
  };
  const Outcome run =
      run_saddle({"torus", "-o", "torus.ply", "--report", "-"}, folder_, "", use_much);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_LT(Json::parse(run.out)["peak_memory_bytes"], kMuch);
}

/// The warnings are the sentences of findings.
TEST_F(GraphCommand, ReportsFindingsWithTheirPlaces) {
  const Json report = report_of({"z=sqrt(0.25-u^2)", "u=1:-1"});
  const Json& findings = report["findings"];
  ASSERT_GE(findings.size(), 2U) << findings;
  EXPECT_EQ(findings[0]["kind"], "undefined");
  EXPECT_EQ(findings[0]["surface"], "surface");
  EXPECT_NEAR(findings[0]["share"].get<double>(), 0.5, 0.01);
  EXPECT_EQ(findings[1]["kind"], "backwards");
  EXPECT_FALSE(findings[1].contains("value"));
  EXPECT_FALSE(findings[1].contains("u"));
  ASSERT_EQ(report["warnings"].size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string text = findings[k]["text"];
    EXPECT_EQ(report["warnings"][k], "surface: " + text);
  }
  const Json pole = report_of({"z=1/u"})["findings"][0];
  EXPECT_EQ(pole["kind"], "pole");
  EXPECT_FALSE(pole.contains("value"));
  EXPECT_NEAR(pole["u"][0].get<double>(), 0, 1e-15);
  EXPECT_EQ(pole["u"][0], pole["u"][1]);
}

TEST_F(GraphCommand, SaysWhetherAnErrorIsABoundAndHowMuchIsProved) {
  const Json plane = meshed({"z=u"})["surfaces"][0];
  EXPECT_EQ(plane["max_error_is"], "bound");
  EXPECT_EQ(plane["proved_fraction"], 1);
  // The largest second derivative bounds the distance from triangles.
  const Json sphere = meshed({"sphere"})["surfaces"][0];
  EXPECT_EQ(sphere["max_error_is"], "search");
  EXPECT_EQ(sphere["proved_fraction"], 1);
  // No proof is tried of a grid that the user gives; a leaf beside a rim has none.
  const Json grid = meshed({"z=u*v", "--samples", "9x9"})["surfaces"][0];
  EXPECT_EQ(grid["max_error_is"], "search");
  EXPECT_EQ(grid["proved_fraction"], 0);
  const Json rim = meshed({"z=sqrt(0.25-u^2)"})["surfaces"][0];
  EXPECT_GT(rim["proved_fraction"], 0.3);
  EXPECT_LT(rim["proved_fraction"], 0.5);  // half of the domain has a surface
}

/// No mesh can show waves that are too short, and a warning says so. The rest of such a picture is
/// within three pixels in place of half of one, unless somebody asks for more.
TEST_F(GraphCommand, DrawsHopelessWavesMoreCoarsely) {
  const auto tolerance_of = [&](const std::string& z, const Names& options) {
    Names arguments = {"z=" + z, "--report", "r.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(saddle(arguments).status, 0);
    return Json::parse(read_file(path("r.json")))["surfaces"][0]["tolerance"].get<double>();
  };
  const Names picture = {"-o", "a.png", "--size", "200x150"};
  const double fine = tolerance_of("sin(9*u*v)", picture);
  EXPECT_GT(tolerance_of("sin(1e6*u*v)", picture), 5 * fine);
  const Names file = {"-o", "a.ply"};
  EXPECT_LT(tolerance_of("sin(1e6*u*v)", file), 1.1 * tolerance_of("sin(9*u*v)", file));
  const Names asked = {"-o", "a.png", "--size", "200x150", "--tolerance", "0.5px"};
  EXPECT_LT(tolerance_of("sin(1e6*u*v)", asked), 1.1 * fine);
}

/// A ridge of height 1 that is narrower than the cells: nothing but bounds know of it.
TEST_F(GraphCommand, WarnsWhereALargeFeatureCouldBeMissing) {
  for (const char* const ridge :
       {"z=exp(-((u-0.378522)*1e5)^2)", "z=min(1,abs(u-0.378522)/1e-4)"}) {
    const Json report = meshed({ridge});
    const Json& surface = report["surfaces"][0];
    const bool shows_it = surface["bounds"][1][2].get<double>() > 0.99 &&
                          surface["bounds"][0][2].get<double>() < 0.01;
    const bool is_off = surface["max_error"] > surface["tolerance"];
    EXPECT_EQ(report["warnings"].empty(), shows_it && !is_off) << report["findings"];
    if (is_off) {
      EXPECT_LT(surface["proved_fraction"], 1);
    }
  }
  for (const std::string smooth : {"boy", "kuen", "superellipsoid", "z=besselj0(10*hypot(u,v))"}) {
    const Json report = meshed({smooth});
    for (const Json& warning : report["warnings"])
      EXPECT_FALSE(contains(warning, "could be missing")) << warning;
  }
}

TEST_F(GraphCommand, ReportsNoPictureWhereThereIsNone) {
  const Json report = report_of({"z=u*v"});
  EXPECT_FALSE(report.contains("image"));
  EXPECT_FALSE(report["times"].contains("draw"));
  EXPECT_TRUE(report["times"].contains("tessellate"));
  EXPECT_EQ(report_of({"z=u*v", "-o", "a.png"})["image"]["renderer"], "osmesa");
}

TEST_F(GraphCommand, WarnsOfWhatIsUndefined) {
  const Outcome run = small({"z=sqrt(u)", "-o", "a.png", "--report", "-"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.err.starts_with("saddle: warning: surface: 50 % of the domain is undefined"))
      << run.err;
  EXPECT_TRUE(contains(run.err, "u = 0:1")) << run.err;
  EXPECT_FALSE(contains(run.err, "v = ")) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["warnings"].size(), 1U);
  EXPECT_NEAR(report["surfaces"][0]["undefined_fraction"].get<double>(), 0.5, 1e-12);
}

TEST_F(GraphCommand, QuietSilencesWarningsButNotTheReport) {
  const Outcome run = small({"z=sqrt(u)", "-q", "--report", "-"});
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(Json::parse(run.out)["warnings"].size(), 1U);
  EXPECT_TRUE(contains(small({"z=u", "-v", "-o", "a.png"}).err, "800 triangles"));
}

TEST_F(GraphCommand, TakesVectorsThatBeginWithAMinus) {
  done({"torus", "--view", "-1,2,3", "-o", "a.png"});
  done({"torus", "--view=-1,2,3", "-o", "b.png"});
  done({"torus", "--view", "-.5*2,sqrt(4),(1+2)", "-o", "c.png"});
  done({"torus", "--view", "1,2,3", "-o", "d.png"});
  EXPECT_EQ(read_file(path("a.png")), read_file(path("b.png")));
  EXPECT_EQ(read_file(path("a.png")), read_file(path("c.png")));
  EXPECT_NE(picture("a.png").rgba, picture("d.png").rgba);
}

TEST_F(GraphCommand, EveryOptionOfThePictureChangesIt) {
  done({"z=u*v+t", "-o", "plain.png"});
  const Image plain = picture("plain.png");
  const std::vector<std::vector<std::string>> options = {
      {"--view", "1,1,1"},  {"--up", "0,1,0"},   {"--target", "1,0,0"},   {"--distance", "5"},
      {"--fov", "60"},      {"--ortho"},         {"--background", "red"}, {"--antialias", "1"},
      {"--front", "red"},   {"--flip"},          {"--grid", "off"},       {"--grid", "3x16"},
      {"--samples", "1x1"}, {"--size", "64x64"}, {"--opacity", "0.5"},
  };
  for (const auto& option : options) {
    std::vector<std::string> arguments = {"z=u*v+t", "-s", "64x48",      "--samples",
                                          "20x20",   "-o", "changed.png"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    ASSERT_EQ(saddle(arguments).status, 0) << option[0];
    EXPECT_NE(picture("changed.png").rgba, plain.rgba) << option[0];
  }
}

TEST_F(GraphCommand, BackAndTimeCount) {
  const std::vector<std::string> below = {"z=0", "--view", "1,1,-2", "-o"};
  auto blue = below;
  blue.push_back("a.png");
  done(blue);
  auto red = below;
  red.insert(red.end(), {"b.png", "--back", "red"});
  done(red);
  EXPECT_NE(picture("a.png").rgba, picture("b.png").rgba);
  EXPECT_EQ(report_of({"z=t", "t=1+2"})["surfaces"][0]["bounds"][0][2], 3);
  EXPECT_EQ(report_of({"z=t", "t=a", "a=5"})["surfaces"][0]["bounds"][0][2], 5);
  EXPECT_EQ(report_of({"z=t", "a=5", "--t", "-2*a"})["surfaces"][0]["bounds"][0][2], -10);
}

TEST_F(GraphCommand, RefusesADriverThatWouldCrash) {
  setenv("GALLIUM_DRIVER", "nonsense", 1);
  const Outcome run = small({"z=u", "-o", "a.png", "--renderer", "osmesa"});
  unsetenv("GALLIUM_DRIVER");
  EXPECT_TRUE(contains(error_of(run, 1), "GALLIUM_DRIVER"));
  EXPECT_EQ(files(), Names{});
}

TEST_F(GraphCommand, WritesTheSameBytesOnEveryCpuLevel) {
  for (const std::string level : {"sse2", "avx2", "avx512"}) {
    setenv("SADDLE_CPU", level.c_str(), 1);
    const Outcome run =
        saddle({"seashell", "-s", "200x150", "-o", level + ".ply", "-o", level + ".png"});
    unsetenv("SADDLE_CPU");
    if (contains(run.err, "this processor does not have " + level)) {
      EXPECT_EQ(run.status, 2);
    } else {
      EXPECT_EQ(read_file(path(level + ".ply")), read_file(path("sse2.ply"))) << level;
      EXPECT_EQ(read_file(path(level + ".png")), read_file(path("sse2.png"))) << level;
    }
  }
  setenv("SADDLE_CPU", "sse9", 1);
  const Outcome unknown = saddle({"torus", "-o", "a.ply"});
  unsetenv("SADDLE_CPU");
  EXPECT_TRUE(contains(error_of(unknown, 2), "the levels are sse2, avx2 and avx512"));
}

TEST_F(GraphCommand, WritesTheSameBytesOnAnyNumberOfThreads) {
  // Smooth; with halved cells; with a pole; with a rim.
  const std::vector<std::string> formulas = {"z=u*v", "z=exp(-90*(u^2+v^2))", "z=0.1/u",
                                             "z=sqrt(1-u^2-v^2)"};
  for (const std::string& formula : formulas) {
    for (const std::string threads : {"1", "2", "7"}) {
      saddle({formula, "-s", "200x150", "--threads", threads, "-q", "-o", threads + ".ply", "-o",
              threads + ".png"});
      EXPECT_EQ(read_file(path(threads + ".ply")), read_file(path("1.ply"))) << formula << threads;
      EXPECT_EQ(read_file(path(threads + ".png")), read_file(path("1.png"))) << formula << threads;
    }
    EXPECT_GT(read_file(path("1.ply")).size(), 1000U) << formula;
  }
}

TEST_F(GraphCommand, ColoursBySomethingAndSaysWhatIsWrongWithIt) {
  done({"torus", "-o", "plain.png"});
  done({"torus", "--color", "z", "--colormap", "magma", "-o", "color.png", "-o", "color.toml"});
  done({"color.toml", "--colormap", "viridis", "-o", "viridis.png"});
  done({"color.toml", "--color", "off", "-o", "off.png"});
  EXPECT_NE(picture("color.png").rgba, picture("viridis.png").rgba);
  EXPECT_EQ(picture("off.png").rgba, picture("plain.png").rgba);
  const auto refused = [&](std::vector<std::string> options, const std::string& part) {
    options.insert(options.begin(), "torus");
    const std::string message = error_of(small(options), 2);
    EXPECT_TRUE(contains(message, part)) << message;
  };
  refused({"--color", "z+zz", "-o", "x.png"}, "--color z+zz\n            ^~");
  refused({"--color", "", "-o", "x.png"}, "the value is empty");
  refused({"--color", "z", "--colormap", "jet", "-o", "x.png"}, "known: viridis");
  refused({"--colormap", "magma", "-o", "x.png"}, "nothing to colour");
  EXPECT_FALSE(exists("x.png"));
}

TEST_F(GraphCommand, GivesColoursToAMeshThatHasThem) {
  done({"torus", "-o", "plain.ply"});
  EXPECT_FALSE(contains(read_file(path("plain.ply")), "property uchar red"));
  done({"z=0", "--color", "u", "--colormap", "gray", "--samples", "2x1", "--grid", "off", "-o",
        "color.ply"});
  const std::string ply = read_file(path("color.ply"));
  EXPECT_TRUE(contains(ply,
                       "property double v\nproperty uchar red\nproperty uchar green\n"
                       "property uchar blue\nelement face"));
  // The first vertex is at u = -1: six floats, u and v, black.
  const std::string first = ply.substr(ply.find("end_header\n") + 11, 43);
  EXPECT_EQ(first.substr(40), std::string(3, '\0'));
}

TEST_F(GraphCommand, DrawsAxesOnlyWhenTheyAreWanted) {
  done({"torus", "-o", "plain.png"});
  done({"torus", "--axes", "-o", "axes.png"});
  EXPECT_NE(picture("axes.png").rgba, picture("plain.png").rgba);
}

}  // namespace
}  // namespace saddle
