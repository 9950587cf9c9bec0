// --thickness on the command line, in scenes, pictures, meshes and reports.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.h"
#include "base/image_png.h"
#include "cli/program.h"
#include "exported.h"

namespace saddle {
namespace {

using Json = nlohmann::json;

class Solids : public ProgramTest {
 protected:
  Outcome run(const std::vector<std::string>& arguments) { return saddle(arguments); }
  /// What the run reports of its first surface.
  Json surface_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--report", "r.json"});
    const Outcome outcome = saddle(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(read_file(path("r.json")))["surfaces"][0];
  }
};

TEST_F(Solids, AreReportedAndWritten) {
  const Json solid = surface_of({"torus", "--thickness", "0.2", "-o", "a.ply"});
  EXPECT_TRUE(solid["solid"]["closed"].get<bool>());
  EXPECT_EQ(solid["solid"]["shells"], 2);
  EXPECT_EQ(solid["solid"]["self_intersections"], 0);
  EXPECT_NEAR(solid["solid"]["volume"].get<double>(), 12.63, 0.1);
  EXPECT_NEAR(solid["solid"]["largest_thickness"].get<double>(), 1.6, 1e-9);
  const Json sheet = surface_of({"torus", "-o", "b.ply"});
  EXPECT_FALSE(sheet.contains("solid"));
  EXPECT_EQ(solid["triangles"].get<int>(), 2 * sheet["triangles"].get<int>());
  const Json checked = surface_of({"check", "torus", "--thickness", "0.2"});
  EXPECT_EQ(checked["solid"]["shells"], 2);
  EXPECT_NEAR(checked["area"].get<double>(), 63.165, 1e-2);
}

TEST_F(Solids, WarnOfFoldsAndCrossings) {
  const Outcome fat = run({"torus", "--thickness", "2", "-o", "a.ply"});
  EXPECT_EQ(fat.status, 0);
  EXPECT_TRUE(contains(fat.err, "the largest that does not is 1.6")) << fat.err;
  const Outcome bottle = run({"klein-bottle", "--thickness", "0.1", "-o", "a.ply"});
  EXPECT_TRUE(contains(bottle.err, "the solid goes through itself: ")) << bottle.err;
  EXPECT_EQ(run({"torus", "--thickness", "2", "-o", "c.ply", "--strict"}).status, 2);
  EXPECT_FALSE(exists("c.ply"));
  EXPECT_EQ(run({"torus", "--thickness", "0.1", "-o", "d.ply", "--strict"}).status, 0);
}

TEST_F(Solids, AreKeptInScenes) {
  ASSERT_EQ(run({"torus", "a=0.05", "--thickness", "2*a,back", "+", "sphere", "--thickness", "2mm",
                 "+", "cylinder", "--thickness", "off", "-o", "a.toml"})
                .status,
            0);
  const std::string scene = read_file(path("a.toml"));
  EXPECT_TRUE(contains(scene, "thickness = \"2*a,back\"\n")) << scene;
  EXPECT_TRUE(contains(scene, "thickness = \"2mm\"\n")) << scene;
  EXPECT_TRUE(contains(scene, "thickness = \"off\"\n")) << scene;
  ASSERT_EQ(run({"a.toml", "-o", "b.toml"}).status, 0);
  EXPECT_EQ(read_file(path("b.toml")), scene);
  const Json report = surface_of({"a.toml", "-o", "a.ply"});
  EXPECT_NEAR(report["solid"]["thickness"].get<double>(), 0.1, 1e-12);
}

TEST_F(Solids, FollowTimeAndTheScene) {
  const Outcome outcome = run({"torus", "t=0:1", "--thickness", "0.1+0.1*t", "--frames", "3", "-s",
                               "64x48", "-o", "f-%d.ply", "--report", "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(read_file(path("f-0.ply")), read_file(path("f-1.ply")));
  const Json clipped =
      surface_of({"hyperboloid-1", "--clip", "-1:1,-1:1,0:1", "--thickness", "0.1", "-o", "a.ply"});
  EXPECT_TRUE(clipped["solid"]["closed"].get<bool>());
  const Json poles = surface_of({"z=1/u", "--thickness", "0.1,front", "-o", "a.ply"});
  EXPECT_TRUE(poles["solid"]["closed"].get<bool>());
  const Json steps = surface_of({"z=floor(2*u)", "--thickness", "0.1,back", "-o", "a.ply"});
  EXPECT_TRUE(steps["solid"]["closed"].get<bool>());
  EXPECT_EQ(steps["solid"]["shells"], 4);
}

TEST_F(Solids, AreHeldByTheCameraOfAnAnimationAtTheirThickest) {
  ASSERT_EQ(run({"torus", "t=0:1", "--thickness", "0.1+1.4*t", "--frames", "4", "--grid", "off",
                 "-s", "80x60", "-o", "f-%d.png", "-q"})
                .status,
            0);
  const Image image = read_png(path("f-3.png")).image;
  for (int x = 0; x < image.width; ++x) {
    EXPECT_EQ(image.pixel(x, 0)[0], 0) << x;
    EXPECT_EQ(image.pixel(x, image.height - 1)[0], 0) << x;
  }
}

TEST_F(Solids, ShowTheFrontAboveTheBackBelowAndWallsBetween) {
  const auto middle = [&](const std::string& view) {
    EXPECT_EQ(run({"z=0", "--thickness", "0.8", "--view", view, "--shading", "unlit", "--grid",
                   "off", "-s", "40x40", "-o", "a.png"})
                  .status,
              0);
    const Image image = read_png(path("a.png")).image;
    const auto* const p = image.pixel(20, 20);
    return std::vector<int>{p[0], p[1], p[2]};
  };
  EXPECT_EQ(middle("0,0,1"), (std::vector<int>{255, 255, 128}));
  EXPECT_EQ(middle("0,0,-1"), (std::vector<int>{128, 128, 255}));
  EXPECT_EQ(middle("0,-1,0"), (std::vector<int>{191, 191, 191}));
}

TEST_F(Solids, ArePrintedInMillimetres) {
  const Outcome outcome =
      run({"z=0", "--thickness", "2mm", "--print-size", "80", "-o", "a.stl", "-o", "a.3mf"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "") << "no open edges";
  const std::string stl = read_file(path("a.stl"));
  Bounds bounds;
  for (std::size_t at = 84; at < stl.size(); at += 50) {
    for (std::size_t k = 12; k < 48; k += 12) {
      bounds.add({number_in<float>(stl, at + k), number_in<float>(stl, at + k + 4),
                  number_in<float>(stl, at + k + 8)});
    }
  }
  EXPECT_NEAR(bounds.size().x, 80, 1e-4);
  EXPECT_NEAR(bounds.size().y, 80, 1e-4);
  EXPECT_NEAR(bounds.size().z, 2, 1e-4);
}

TEST_F(Solids, AreWhatTheWarningOfOpenEdgesProposes) {
  const std::vector<std::vector<std::string>> scenes = {{"z=u*v"},
                                                        {"mobius"},
                                                        {"enneper", "--print-size", "80"},
                                                        {"z=1e-6*u*v", "u=0:1e-3", "v=0:1e-3"}};
  for (std::vector<std::string> words : scenes) {
    words.insert(words.end(), {"-o", "a.stl"});
    const std::string err = run(words).err;
    const std::string option = "--thickness ";
    const std::size_t begin = err.find(option);
    ASSERT_NE(begin, std::string::npos) << err;
    const std::size_t number = begin + option.size();
    words.insert(words.end(), {"--thickness", err.substr(number, err.find(' ', number) - number)});
    const Outcome solid = run(words);
    EXPECT_EQ(solid.status, 0) << solid.err;
    EXPECT_FALSE(contains(solid.err, "no solid that can be printed")) << solid.err;
  }
}

TEST_F(Solids, AreOnPagesAsTheyAreAndFollowNoSliders) {
  const Outcome outcome = run({"torus", "v=0:4", "--thickness", "0.3", "-o", "a.html"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  const Outcome slider = run({"torus", "--thickness", "0.3", "--sliders", "r", "-o", "b.html"});
  EXPECT_EQ(slider.status, 2);
  EXPECT_TRUE(contains(slider.err, "solids follow no sliders")) << slider.err;
  EXPECT_FALSE(exists("b.html"));
  EXPECT_EQ(run({"torus", "--sliders", "r", "-o", "b.html"}).status, 0);
}

TEST_F(Solids, RefuseWhatIsNoThickness) {
  struct Refusal {
    std::string text;
    std::string said;
  };
  for (const Refusal& refusal : std::vector<Refusal>{
           {"-1", "more than 0"},
           {"0", "more than 0"},
           {"1/0", ""},
           {"inf", ""},
           {"2cm", "write 20mm"},
           {"0.5in", "write 12.7mm"},
           {"0.1,both", "0.1,front or 0.1,back"},
           {"0.1,", "0.1,front or 0.1,back"},
           {"", ""},
           {"1e-30", "lost in the rounding"},
       }) {
    const Outcome outcome = run({"torus", "--thickness", refusal.text, "-o", "a.ply"});
    EXPECT_EQ(outcome.status, 2) << refusal.text << ": " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, refusal.said)) << refusal.text << ": " << outcome.err;
    EXPECT_FALSE(exists("a.ply")) << refusal.text;
  }
  const Outcome one_sided = run({"mobius", "--thickness", "0.1,front", "-o", "a.ply"});
  EXPECT_EQ(one_sided.status, 2);
  EXPECT_TRUE(contains(one_sided.err, "one-sided")) << one_sided.err;
  EXPECT_EQ(run({"mobius", "--thickness", "0.1", "-o", "a.ply"}).status, 0);
}

}  // namespace
}  // namespace saddle
