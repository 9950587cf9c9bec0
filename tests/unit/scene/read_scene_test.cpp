#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

Scene read(const std::string& text) {
  return read_scene({"scene.toml", text});
}

/// A scene with every key.
const std::string kEverything = R"toml(title = "Everything"
background = [0.1, 0.2, 0.3, 0.5]
size = "320x240"
antialias = 3
shading = "vertex"
specular = "blinn"
tolerance = "0.25px"
normal-tolerance = 5
max-triangles = 1000
samples = "20x10"
clip = "-1:1,-2:2,0:0.5"
print-size = 80
t = "r/2"

[params]
R = 2
r = { value = 0.7, min = 0.1, max = "R-0.1" }
w = "cosh(v)^2+u^2"

[functions]
"bump(s, q)" = "exp(-s*s)*q"

[[surface]]
name = "torus"
x = "(R+r*cos(v))*cos(u)"
y = "(R+r*cos(v))*sin(u)"
z = "r*sin(v)+bump(u, 0)"
u = ["0", "2*pi"]
v = ["-pi", "r"]
grid = [0, 12]
front = { diffuse = "#ff0000", specular = [0.1, 0.25, "0.1*t"], shininess = "8*R", ambient = "#333333", emission = [0, 0, "t"] }
back = { diffuse = "#00ff00" }
flip = true
opacity = "t/4"
in = ["wheel", "car"]

[[surface]]
z = "u*v"
in = "car"

[[node]]
name = "wheel"
in = "car"
transform = [{ rotate = ["600*t", 0, 0, 1] }, { translate = [0, "r", 2] }, { scale = 0.5 }, { scale = [1, 2, "R"] }]

[[node]]
name = "car"

[[light]]
frame = "world"
direction = [1, "R", 3]
color = [0.6, 2, "t"]
enabled = "sin(t) > 0"

[[light]]
frame = "wheel"
position = [1, 2, 3]
diffuse = "#ffffff"
specular = [0.4, 0.4, 0.41]
ambient = "#666666"
attenuation = [1, 0.5, "r"]
spot = { direction = [0, -1, 0], cutoff = 30, inner = "20+r", exponent = 2, falloff = "smooth" }

[[light]]
position = [0, 0, 0]
color = "#ffffff"
attenuation = { range = "25*R" }
enabled = 0

[camera]
view = [2, 1, "cos(t)"]
up = [0, 1, 0]
target = [0, 0, 1]
distance = "24+R"
fov = 45
ortho = true

[animation]
t = [0, "2*pi"]
fps = 25
frames = 50
)toml";

TEST(ReadScene, WritesBackEveryKeyAsItWasRead) {
  EXPECT_EQ(write_scene(read(kEverything)), kEverything);
}

TEST(ReadScene, EvaluatesExpressionsAtTheMoment) {
  const Scene scene = resolve(read(kEverything));
  EXPECT_EQ(scene.t, 0.35);
  EXPECT_EQ(scene.surfaces[0].front.emission.b, 0.35);
  EXPECT_EQ(scene.surfaces[0].opacity, 0.35 / 4);
  EXPECT_EQ(scene.surfaces[0].front.shininess, 16);
  EXPECT_EQ(scene.nodes[0].transform[0].angle, 600 * 0.35);
  EXPECT_EQ(dvec3(scene.nodes[0].transform[3].vector), dvec3(1, 2, 2));
  EXPECT_EQ(scene.lights[0].enabled, 1);
  EXPECT_EQ(scene.lights[1].spot->inner.value(), 20.7);
  EXPECT_EQ(scene.lights[2].attenuation.range.value(), 50);
  EXPECT_EQ(scene.camera.distance.value(), 26);
  EXPECT_EQ(scene.sliders[0].max, 1.9);
}

TEST(ReadScene, BeginsAtTheStartOfTheAnimationUnlessToldAnotherMoment) {
  const std::string surface = "[[surface]]\nz = \"u\"\n";
  const std::string animation = "\n[animation]\nt = [5, 10]\n";
  EXPECT_EQ(resolve(read(surface + animation)).t, 5);
  EXPECT_EQ(resolve(read("t = 0\n" + surface + animation)).t, 0);
  EXPECT_EQ(write_scene(read(surface + animation)), surface + animation);
  EXPECT_EQ(write_scene(read("t = 0\n" + surface + animation)), "t = 0\n\n" + surface + animation);
}

TEST(ReadScene, ReadsBackWhateverTheGalleryWrites) {
  for (const GalleryEntry& entry : gallery()) {
    const std::string text = write_scene(gallery_scene(entry));
    EXPECT_EQ(write_scene(read(text)), text);
  }
}

TEST(ReadScene, KeepsEveryBitOfANumber) {
  for (const double number : {0.1 + 0.2, 1e-300, 5e-324, 1.7976931348623157e308, 1e22,
                              123456789012345680000.0, 9007199254740993.0, -0.0}) {
    Scene scene;
    scene.surfaces.emplace_back().z = "u";
    scene.camera.view = dvec3(1, number, 2);
    EXPECT_EQ(read(write_scene(scene)).camera.view.y, number);
  }
}

TEST(ReadScene, TakesOptionsInEitherForm) {
  const Scene scene = read(R"(size = [80, 60]
samples = [4, 5]
tolerance = 1e-3
clip = "off"
[[surface]]
z = 1
u = [0, 2]
grid = "off"
front = "tomato"
back = [0.1, 0.2, 0.3]
[[surface]]
z = "u"
grid = "4x5")");
  EXPECT_EQ(scene.picture.width, 80);
  EXPECT_EQ(scene.mesh.samples->v, 5);
  EXPECT_FALSE(scene.mesh.tolerance->pixels);
  EXPECT_FALSE(scene.clip.automatic);
  EXPECT_EQ(scene.surfaces[0].z, "1");
  EXPECT_EQ(scene.surfaces[0].u.max, "2");
  EXPECT_EQ(scene.surfaces[0].grid_lines().u, 0);
  EXPECT_EQ(scene.surfaces[0].front.diffuse.r, 1);
  EXPECT_EQ(scene.surfaces[0].back.diffuse.b, 0.3);
  EXPECT_EQ(scene.surfaces[1].grid_lines().v, 5);
}

TEST(ReadScene, HasThreeLightsUnlessItNamesSome) {
  EXPECT_EQ(read("[[surface]]\nz = \"u\"").lights.size(), 3U);
  const Scene dark = read("light = []\n[[surface]]\nz = \"u\"");
  EXPECT_TRUE(dark.lights.empty());
  EXPECT_NE(write_scene(dark).find("light = []"), std::string::npos);
}

TEST(ReadScene, TakesTheOtherHalfOfALightAsBlack) {
  const Scene scene = read("[[surface]]\nz = 1\n[[light]]\ndiffuse = \"white\"\nposition=[0,0,1]");
  EXPECT_EQ(scene.lights[0].color.r, 1);
  EXPECT_EQ(scene.lights[0].specular->r, 0);
}

struct Malformed {
  std::string text;
  const char* where;  ///< line and column
  const char* says;   ///< part of the message or the hint
};

/// Two lines with a surface that is right.
const std::string kFront = "[[surface]]\nz = \"u\"\n";

class MalformedScene : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedScene, IsRefusedWithPlaceAndHint) {
  try {
    read(GetParam().text);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Input);
    EXPECT_EQ(error.place().where, std::string("scene.toml:") + GetParam().where);
    const std::string shown = format_error(error);
    EXPECT_NE(shown.find(GetParam().says), std::string::npos) << shown;
    EXPECT_LE(error.place().span.end, error.place().text.size());
    return;
  }
  ADD_FAILURE() << "no error";
}

INSTANTIATE_TEST_SUITE_P(
    All, MalformedScene,
    testing::Values(
        // no TOML
        Malformed{"", "1:1", "no [[surface]]"}, Malformed{"[&", "1:2", "TOML"},
        Malformed{"\x7f\x45LF\x02\x01", "1:1", "TOML"}, Malformed{"a = \xff", "1:4", "TOML"},
        Malformed{"title = \"open", "1:14", "TOML"}, Malformed{"z = 1e999", "1:10", "TOML"},
        Malformed{"title = 1\ntitle = 2", "2:9", "redefine"},
        Malformed{"t = 99999999999999999999", "1:25", "TOML"},
        // keys
        Malformed{"titel = \"x\"\n" + kFront, "1:1", "did you mean 'title'?"},
        Malformed{kFront + "colour = 1", "3:1", "did you mean 'color'?"},
        Malformed{kFront + "hue = 1", "3:1", "known keys: name"},
        Malformed{kFront + "color = \"z+foo\"", "3:12", "unknown name 'foo'"},
        Malformed{kFront + "color = \"z\"\ncolormap = \"virdis\"", "4:13", "'viridis'"},
        Malformed{kFront + "colormap = \"magma\"", "3:12", "nothing to colour"},
        Malformed{kFront + "color-range = [0, 1]", "3:15", "nothing to colour"},
        Malformed{kFront + "color = \"z\"\ncolor-range = [1, 0]", "4:15", "must be less"},
        Malformed{kFront + "color = \"z\"\ncolor-range = \"even\"", "4:16", "both ends"},
        Malformed{kFront + "contours = [\"z\", \"foo=1\"]", "3:19", "'foo'"},
        Malformed{kFront + "contours = \"z=0,bar\"", "3:12", "'bar'"},
        Malformed{kFront + "contours = [1]", "3:13", "gauss=0"},
        Malformed{"axes = 1\n" + kFront, "1:8", "true or false"},
        Malformed{kFront + "fornt = \"red\"", "3:1", "did you mean 'front'?"},
        Malformed{kFront + "front = { difuse = \"red\" }", "3:11", "did you mean 'diffuse'?"},
        Malformed{kFront + "[camera]\nfow = 3", "4:1", "did you mean 'fov'?"},
        Malformed{kFront + "[[light]]\npositon = [1,2,3]", "4:1", "did you mean 'position'?"},
        Malformed{kFront + "[[light]]\nspot = { cutof = 3 }", "4:10", "did you mean 'cutoff'?"},
        Malformed{kFront + "[[node]]\nnmae = \"a\"", "4:1", "did you mean 'name'?"},
        Malformed{kFront + "in = []", "3:6", "leave it out"},
        Malformed{kFront + "[animation]\nfsp = 3", "4:1", "did you mean 'fps'?"},
        Malformed{kFront + "[scene]\na = 1", "3:2", "unknown key 'scene'"},
        // types
        Malformed{"title = 3\n" + kFront, "1:9", "text in quotes, not a number"},
        Malformed{"[surface]\nz = \"u\"", "1:1", "must be written as [[surface]]"},
        Malformed{"surface = [1]", "1:11", "[[surface]]"},
        Malformed{"params = 3\n" + kFront, "1:10", "a table, not a number"},
        Malformed{kFront + "u = 3", "3:5", "two ends"},
        Malformed{kFront + "u = [1]", "3:5", "two ends"},
        Malformed{kFront + "x = true", "3:5", "a formula in quotes"},
        Malformed{kFront + "flip = 1", "3:8", "true or false"},
        Malformed{kFront + "opacity = 1.5", "3:11", "from 0 to 1"},
        Malformed{kFront + "grid = [1, 16]", "3:8", "one is not enough"},
        Malformed{kFront + "grid = [2.5, 16]", "3:8", "not a whole number"},
        Malformed{kFront + "in = 3", "3:6", "a name, or an array of names"},
        Malformed{kFront + "[camera]\nview = [1, 2]", "4:8", "three numbers, such as"},
        Malformed{kFront + "[camera]\nview = [1, 2, true]", "4:15", "a number, or an expression"},
        Malformed{kFront + "[camera]\northo = \"yes\"", "4:9", "true or false, not text"},
        Malformed{kFront + "[camera]\nfov = 1979-05-27", "4:7", "not a date or time"},
        Malformed{"size = 3\n" + kFront, "1:8", "two whole numbers with an x"},
        Malformed{"samples = [100000, 100000]\n" + kFront, "1:11", "more than"},
        Malformed{"antialias = 100\n" + kFront, "1:13", "from 1 to 16"},
        Malformed{"shading = \"vertx\"\n" + kFront, "1:12", "did you mean 'vertex'?"},
        Malformed{"clip = \"0:1\"\n" + kFront, "1:9", "three ranges"},
        Malformed{"background = \"rde\"\n" + kFront, "1:15", "did you mean 'red'?"},
        Malformed{kFront + "front = [1, 2]", "3:9", "a colour such as"},
        Malformed{kFront + "front = \"#ff000080\"", "3:10", "see-through"},
        Malformed{"[params]\nr = { value = 1 }\n" + kFront, "2:5", "'min' is missing"},
        Malformed{"[params]\nr = { value = 1, min = 2, max = 1 }\n" + kFront, "2:33",
                  "less than max"},
        Malformed{"[params]\n\"2r\" = 1\n" + kFront, "2:1", "'2r' is not a name"},
        Malformed{"[params]\n\"f(s)\" = 1\n" + kFront, "2:1", "[functions]"},
        Malformed{"[functions]\nbump = \"1\"\n" + kFront, "2:1", "not a function"},
        // formulas
        Malformed{"[[surface]]\nx = \"u\"", "1:1", "z has no formula"},
        Malformed{"[[surface]]\nz = \"cos(u)*foo(v)\"", "2:13", "foo"},
        Malformed{"[[surface]]\nz = \"\"\"\ncos(u)*foo(v)\"\"\"", "3:8", "foo"},
        Malformed{"[[surface]]\nz = \"\"", "2:5", "empty"},
        Malformed{kFront + "u = [\"0\", \"v\"]", "3:5", "u"},
        Malformed{kFront + "u = [1, 1]", "3:5", "empty"},
        Malformed{"[params]\na = \"b\"\nb = \"a\"\n" + kFront, "2:5", "a -> b -> a"},
        Malformed{"[params]\nu = 1\n" + kFront, "2:5", "cannot be defined"},
        Malformed{"[functions]\n\"f(s)\" = \"s+\"\n" + kFront, "2:12", "f(s)"},
        // numbers
        Malformed{kFront + "[camera]\nfov = 180", "4:7", "more than 0 and less than 180"},
        Malformed{kFront + "[camera]\nfov = nan", "4:7", "not a finite number"},
        Malformed{"[[surface]]\nz = 9007199254740993", "2:5", "beyond 2^53"},
        Malformed{"[[surface]]\nz = -9223372036854775808", "2:5", "beyond 2^53"},
        Malformed{kFront + "[camera]\nfov = \"0/0\"", "4:8", "not a finite number"},
        Malformed{kFront + "[camera]\nfov = \"90*u\"", "4:8", "not u or v"},
        Malformed{kFront + "[camera]\nfov = \"sin t\"", "4:8", "sin"},
        Malformed{kFront + "[camera]\ndistance = inf", "4:12", "not a finite number"},
        Malformed{kFront + "[camera]\ndistance = -1", "4:12", "more than 0"},
        Malformed{kFront + "[camera]\nview = [0, 0, 0]", "4:8", "needs a length"},
        Malformed{"t = \"t+1\"\n" + kFront, "1:6", "not u, v or t"},
        Malformed{kFront + "front = { shininess = -1 }", "3:23", "at least 0"},
        Malformed{kFront + "[[light]]\ncolor = [1, -1, 0]", "4:13", "at least 0"},
        Malformed{kFront + "[[light]]\ncolor = \"#12345\"", "4:10", "3, 6 or 8"},
        Malformed{kFront + "[animation]\nfps = 0", "4:7", "more than 0.01"},
        Malformed{kFront + "[animation]\nfps = 1000", "4:7", "less than 1000"},
        Malformed{"[[surface]]\nz = \"mode(u)\"\nfront = { shininess = \"2*3\" }", "2:6", "known"},
        Malformed{kFront + "[animation]\nt = [0, 0.0]", "4:6", "the range of t is empty"},
        Malformed{kFront + "[animation]\nt = [2, \"1\"]", "4:10", "runs backwards"},
        Malformed{kFront + "[animation]\nt = [0, \"t\"]", "4:10", "not u, v or t"},
        Malformed{kFront + "[animation]\nt = 12", "4:5", "two moments"},
        Malformed{kFront + "[animation]\nframes = 0", "4:10", "from 1 to 1000000"},
        // lights and nodes
        Malformed{kFront + "[[light]]\ndirection = [0, 0, 1]\nspot = {}", "5:8", "has no spot"},
        Malformed{kFront + "[[light]]\ncolor = \"red\"\nspecular = \"red\"", "4:9", "either color"},
        Malformed{kFront + "[[light]]\nattenuation = [0, 0, 0]", "4:15", "more than 0"},
        Malformed{kFront + "[[light]]\nattenuation = { range = 0 }", "4:25", "more than 0"},
        Malformed{kFront + "[[light]]\nspot = { cutoff = 20, inner = 30 }", "4:31", "cutoff is 20"},
        Malformed{kFront + "[[light]]\nspot = { cutoff = 181 }", "4:19", "from 0 to 180"},
        Malformed{kFront + "[[light]]\nspot = { falloff = \"soft\" }", "4:20", "\"smooth\""},
        Malformed{kFront + "[[light]]\nframe = \"wolrd\"", "4:10", "did you mean 'world'?"},
        Malformed{kFront + "in = \"whel\"\n[[node]]\nname = \"wheel\"", "3:7",
                  "did you mean 'wheel'?"},
        Malformed{kFront + "in = \"wheel\"", "3:7", "no [[node]]"},
        Malformed{kFront + "[[node]]\nname = \"a\"\nin = \"b\"\n[[node]]\nname = \"b\"\nin = \"a\"",
                  "5:7", "a -> b -> a"},
        Malformed{kFront + "[[node]]\nname = \"a\"\nin = \"c\"", "5:7", "no node is called 'c'"},
        Malformed{kFront + "[[node]]\nname = \"a\"\n[[node]]\nname = \"a\"", "4:9", "second node"},
        Malformed{kFront + "[[node]]\nname = \"eye\"", "4:8", "cannot be called"},
        Malformed{kFront + "[[node]]\nin = \"a\"", "3:1", "'name' is missing"},
        Malformed{kFront + "[[node]]\nname = \"a\"\ntransform = { scale = 2 }", "5:13", "a list"},
        Malformed{kFront + "[[node]]\nname = \"a\"\ntransform = [{ turn = 2 }]", "5:16",
                  "translate"},
        Malformed{
            kFront + "[[node]]\nname = \"a\"\ntransform = [{ scale = 1, rotate = [1,0,0,1] }]",
            "5:14", "one of"},
        Malformed{kFront + "[[node]]\nname = \"a\"\ntransform = [{ rotate = [1, 0, 0] }]", "5:25",
                  "an angle and an axis"},
        Malformed{kFront + "[[node]]\nname = \"a\"\ntransform = [{ rotate = [1, 0, 0, 0] }]",
                  "5:25", "needs a length"}));

TEST(MalformedScenes, MayNestAsDeepAsTheyLike) {
  for (const std::string& text :
       {"a" + std::string(200000, '['), "a = " + std::string(200000, '['), "a" + [] {
          std::string dots;
          for (int i = 0; i < 1000000; ++i) dots += ".a";
          return dots;
        }() + " = 1"}) {
    EXPECT_THROW(read(text), Error);
  }
}

TEST(MalformedScenes, MayBeLarge) {
  EXPECT_THROW(read(std::string(kMaxTomlBytes + 1, ' ')), Error);
}

TEST(MalformedScenes, EndChainsOfNodesThatAreTooDeep) {
  std::string text = kFront;
  for (int i = 0; i < 300; ++i) {
    text += "[[node]]\nname = \"n" + std::to_string(i) + "\"\n";
    if (i > 0) text += "in = \"n" + std::to_string(i - 1) + "\"\n";
  }
  EXPECT_THROW(read(text), Error);
}

TEST(SceneFile, HasOwnParametersOfSurfaces) {
  const std::string text =
      "[params]\na = 2\n\n[[surface]]\nparameters = [\"x\", \"angle\"]\ny = \"f(a)*cos(angle)\"\n"
      "z = \"sin(angle)\"\nwhere = \"x < a\"\nx = [\"-4\", \"4\"]\nangle = [\"0\", \"pi\"]\n"
      "params = { a = { value = 3, min = 0, max = 5 } }\nfunctions = { \"f(s)\" = \"s^2\" }\n";
  const Scene scene = read_scene({"scene.toml", text});
  const SurfaceSpec& spec = scene.surfaces.at(0);
  EXPECT_EQ(spec.parameters, (ParameterNames{"x", "angle"}));
  EXPECT_EQ(spec.u.min, "-4");
  EXPECT_EQ(spec.v.max, "pi");
  EXPECT_EQ(spec.where, "x < a");
  ASSERT_EQ(spec.definitions.size(), 2U);
  EXPECT_EQ(spec.sliders.at(0).max, 5);
  EXPECT_EQ(write_scene(scene), text);
}

}  // namespace
}  // namespace saddle
