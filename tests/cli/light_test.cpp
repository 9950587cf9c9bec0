// Light in scenes: choices of parameters, lights that are all off, shading of single surfaces,
// shaders in words.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/image_png.h"
#include "cli/program.h"
#include "paths.h"

namespace saddle {
namespace {

class LitScenes : public ProgramTest {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string content(const std::string& name) const { return read_file(path(name)); }
  Image image(const std::string& name) const { return read_png(path(name).string()).image; }
};

const std::string kSwitched =
    "[params]\n"
    "light = { value = \"lamp\", choices = [\"sun\", \"lamp\", \"torch\"] }\n"
    "power = { value = 1, min = 0, max = 4, step = 0.5 }\n"
    "[[surface]]\nz = \"x*y\"\n"
    "[[light]]\ndirection = [0, 0, 1]\nenabled = \"light == 0 && power > 0\"\n"
    "[[light]]\nposition = [0, 0, 0]\nenabled = \"light > 0 && power > 0\"\n";

TEST_F(LitScenes, ChoicesHaveNamesAndNumbers) {
  write("s.toml", kSwitched);
  ASSERT_EQ(small({"s.toml", "light=torch", "-o", "a.png", "-o", "a.toml"}).status, 0);
  ASSERT_EQ(small({"s.toml", "light=2", "-o", "b.png"}).status, 0);
  ASSERT_EQ(small({"a.toml", "-o", "c.png", "-o", "c.toml"}).status, 0);
  EXPECT_EQ(image("a.png").rgba, image("b.png").rgba);
  EXPECT_EQ(image("a.png").rgba, image("c.png").rgba);
  EXPECT_EQ(content("a.toml"), content("c.toml"));
  EXPECT_TRUE(contains(content("a.toml"),
                       "light = { value = 2, choices = [\"sun\", \"lamp\", \"torch\"] }\n"
                       "power = { value = 1, min = 0, max = 4, step = 0.5 }\n"))
      << content("a.toml");
}

TEST_F(LitScenes, AChoiceThatThereIsNotNamesThoseThatThereAre) {
  write("s.toml", kSwitched);
  const std::string names = "choices: 0 sun, 1 lamp, 2 torch";
  for (const std::string value : {"3", "-1", "0.5", "1/0"}) {
    const std::string error = error_of(small({"s.toml", "light=" + value, "-o", "a.png"}), 2);
    EXPECT_TRUE(contains(error, names) || value == "1/0") << error;
    EXPECT_TRUE(contains(error, "light = " + value)) << error;
  }
  const std::string error = error_of(small({"s.toml", "light=lam", "-o", "a.png"}), 2);
  EXPECT_TRUE(contains(error, names + "; did you mean 'lamp'?")) << error;
}

TEST_F(LitScenes, WrongChoicesHavePlacesInTheFile) {
  const auto error = [this](const std::string& inside) {
    write("s.toml", "[params]\na = { " + inside + " }\n[[surface]]\nz = \"a*x\"\n");
    return error_of(small({"s.toml", "-o", "a.png"}), 2);
  };
  EXPECT_TRUE(contains(error("value = 0, choices = [\"b\"]"), "s.toml:2:"));
  EXPECT_TRUE(contains(error("value = 0, choices = [\"b\", \"b\"]"), "'b' is there twice"));
  EXPECT_TRUE(contains(error("value = 0, choices = [\"b\", \"1\"]"), "'1' cannot be the name"));
  EXPECT_TRUE(contains(error("value = 0, choices = 3"), "must be names"));
  EXPECT_TRUE(contains(error("value = 2, choices = [\"b\", \"c\"]"), "there is no choice 2"));
  EXPECT_TRUE(contains(error("value = \"d\", choices = [\"b\", \"c\"]"), "s.toml:2:"));
  EXPECT_TRUE(contains(error("choices = [\"b\", \"c\"]"), "'value' is missing"));
  EXPECT_TRUE(contains(error("value = 0, min = 0, max = 2, step = -1"), "must be at least 0"));
}

TEST_F(LitScenes, WarnWhereNoLightIsOn) {
  write("s.toml", kSwitched);
  const Outcome run = small({"s.toml", "power=0", "-o", "a.png", "--report", "r.json"});
  EXPECT_EQ(run.status, 0);
  const std::string told = "no light is on: light takes 0 sun, 1 lamp, 2 torch; power takes 0 to 4";
  EXPECT_TRUE(contains(run.err, "saddle: warning: " + told + "\n")) << run.err;
  const auto report = nlohmann::json::parse(content("r.json"));
  EXPECT_EQ(report["findings"].back()["kind"], "no-light");
  EXPECT_EQ(report["findings"].back()["text"], told);
  EXPECT_TRUE(report["findings"].back()["surface"].is_null());
  EXPECT_EQ(small({"s.toml", "-o", "a.png"}).err, "");
  EXPECT_EQ(small({"s.toml", "power=0", "--shading", "unlit", "-o", "a.png"}).err, "");
  write("none.toml", "light = []\n[[surface]]\nz = \"x*y\"\n");
  EXPECT_TRUE(
      contains(small({"none.toml", "-o", "a.png"}).err, "no light is on: the scene has none"));
  write("day.toml",
        "[[surface]]\nz = \"x*y\"\n[[light]]\nenabled = \"t > 0.2\"\n[animation]\nframes = 2\n");
  EXPECT_EQ(small({"day.toml", "-o", "day-%d.png"}).err, "");
  EXPECT_TRUE(contains(small({"day.toml", "--t", "0", "-o", "a.png"}).err, "no light is on"));
}

TEST_F(LitScenes, WarnWhereVerticesLoseACone) {
  const std::string scene =
      "[[surface]]\nz = \"0*x\"\nu = [-2, 2]\nv = [-2, 2]\n"
      "[[light]]\nframe = \"world\"\nposition = [0.3, 0.2, 2]\nspot = { cutoff = 10 }\n";
  write("s.toml", scene);
  const Outcome run = saddle({"-s", "40x30", "s.toml", "--shading", "vertex", "--samples", "2x2",
                              "-o", "a.png", "--report", "r.json"});
  EXPECT_TRUE(contains(run.err, "surface: lit per vertex, it loses 100 % of a spot light's cone"))
      << run.err;
  const auto report = nlohmann::json::parse(content("r.json"));
  EXPECT_EQ(report["findings"].back()["kind"], "cone-lost");
  EXPECT_EQ(report["findings"].back()["share"], 1);
  EXPECT_EQ(saddle({"-s", "40x30", "s.toml", "--samples", "2x2", "-o", "a.png"}).err, "");
  EXPECT_EQ(saddle({"-s", "40x30", "s.toml", "--shading", "vertex", "--samples", "200x200", "-o",
                    "a.png"})
                .err,
            "");
}

TEST_F(LitScenes, ShadingIsOfOneSurfaceOrOfAll) {
  const std::string file = source_folder() + "/examples/lighting/side-by-side.toml";
  const std::vector<std::string> options = {"-s", "80x40", "--antialias", "1"};
  const auto draw = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {file, "-o", name};
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(saddle(arguments).status, 0);
    return image(name);
  };
  const Image both = draw("both.png", {});
  const Image vertex = draw("vertex.png", {"--shading", "vertex"});
  const Image pixel = draw("pixel.png", {"--shading", "pixel"});
  int differences = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 80; ++x) {
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(both.pixel(x, y)[c], (x < 40 ? vertex : pixel).pixel(x, y)[c]) << x << " " << y;
        differences += vertex.pixel(x, y)[c] != pixel.pixel(x, y)[c] ? 1 : 0;
      }
    }
  }
  EXPECT_GT(differences, 500);
}

TEST_F(LitScenes, ALitSurfaceStandsInAnUnlitScene) {
  write("s.toml",
        "shading = \"unlit\"\n[[surface]]\nz = \"0*x\"\ngrid = \"off\"\nshading = \"pixel\"\n"
        "front = { diffuse = \"white\", specular = \"black\" }\n"
        "[[light]]\nframe = \"world\"\ndirection = [0, 0, 1]\ncolor = [0.5, 0.5, 0.5]\n");
  ASSERT_EQ(
      saddle({"s.toml", "-s", "40x30", "--view", "0,0,1", "--up", "0,1,0", "-o", "a.png"}).status,
      0);
  EXPECT_NEAR(image("a.png").pixel(20, 15)[0], 128, 1);
}

TEST_F(LitScenes, ReportWhoseBackFacesAreCulled) {
  const Outcome closed = small({"torus", "-v", "-o", "a.png", "--report", "r.json"});
  EXPECT_TRUE(contains(closed.err, "evaluations, back faces are culled")) << closed.err;
  EXPECT_EQ(nlohmann::json::parse(content("r.json"))["surfaces"][0]["culls_backs"], true);
  const Outcome open = small({"z=u*v", "-v", "-o", "a.png", "--report", "r.json"});
  EXPECT_TRUE(contains(open.err, "evaluations, back faces are drawn")) << open.err;
  EXPECT_EQ(nlohmann::json::parse(content("r.json"))["surfaces"][0]["culls_backs"], false);
}

TEST_F(LitScenes, ShadersComeWithWhatIsLeftOutOfThem) {
  const std::string file = source_folder() + "/examples/lighting/side-by-side.toml";
  const std::string both = saddle({"show", "--shader", file}).out;
  EXPECT_TRUE(contains(both, "// Program 1 of 2: per vertex\n")) << both;
  EXPECT_TRUE(contains(both, "// Program 2 of 2: per pixel\n"));
  EXPECT_TRUE(contains(both, "//   lit per vertex: no light in the fragment shader\n"));
  EXPECT_TRUE(
      contains(both, "//   no light is weaker from afar: no distance and no attenuation\n"));
  const std::string spots =
      saddle({"show", "--shader", source_folder() + "/examples/lighting/spotlights.toml"}).out;
  EXPECT_FALSE(contains(spots, "no spot light"));
  EXPECT_TRUE(contains(spots, "void spot_light(int i)"));
  EXPECT_TRUE(contains(error_of(saddle({"torus", "--shader", "-o", "a.png"}), 2), "--shader"));
}

TEST_F(LitScenes, WarnOfAClampWhoseBoundsAreReversed) {
  const Outcome run = small({"z=clamp(u,a,0)+v", "a=1", "-o", "a.png"});
  EXPECT_TRUE(contains(run.err,
                       "z: clamp(u,a,0) is 0 everywhere: its bounds are reversed; write "
                       "clamp(u,0,a)"))
      << run.err;
  EXPECT_FALSE(contains(small({"z=clamp(u,0,1)+v", "-o", "a.png"}).err, "clamp"));
}

}  // namespace
}  // namespace saddle
