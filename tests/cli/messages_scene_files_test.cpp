// Messages about scene files: lights, nodes, surfaces, curves and the rest of their keys.
#include <fstream>
#include <string>

#include "base/file.h"
#include "cli/messages.h"

namespace saddle {
namespace {

/// What stands in scene.toml behind the prefix of its table.
struct FileRow {
  const char* text;
  const char* message;  ///< its line and column first
  const char* hint;
  const char* instead;  ///< what the hint says, done; empty: nothing to try
};

class SceneFileMessages : public Messages {
 protected:
  Outcome draw(const std::string& text) {
    std::ofstream(path("scene.toml")) << text;
    return run("scene.toml -o a.toml");
  }

  /// `prefix`: the lines before each text.
  void expect_in_files(const std::string& prefix, std::span<const FileRow> rows) {
    for (const FileRow& row : rows) {
      const std::string error = error_of(draw(prefix + row.text), 2);
      EXPECT_TRUE(error.starts_with(std::string("saddle: scene.toml:") + row.message))
          << row.text << error;
      EXPECT_TRUE(contains(error, row.hint)) << row.text << error;
      if (std::string_view(row.instead).empty()) continue;
      const Outcome instead = draw(prefix + row.instead);
      EXPECT_EQ(instead.status, 0) << row.instead << instead.err;
    }
  }
};

constexpr FileRow kLights[] = {
    {"colour = 'red'\n", "4:1: unknown key 'colour'", "did you mean 'color'?", "color = 'red'\n"},
    {"color = 'rde'\n", "4:10: light 1: color: unknown colour 'rde'", "did you mean 'red'?",
     "color = 'red'\n"},
    {"color = '#ff000080'\n", "4:10: light 1: color: this colour cannot be see-through",
     "write #rrggbb, or a CSS colour name", "color = '#ff0000'\n"},
    {"ambient = [2, 0]\n", "4:11: light 1: ambient: must be a colour such as", "not an array of 2",
     "ambient = [1, 1, 0.5]\n"},
    {"color = 'red'\ndiffuse = 'red'\n", "4:9: light: color is both, diffuse and specular",
     "give either color, or diffuse and specular", "diffuse = 'red'\n"},
    {"direction = [0, 0, 1]\nposition = [1, 2, 3]\n", "5:12: light: a directional light has no pos",
     "a point light has a position instead", "position = [1, 2, 3]\n"},
    {"direction = [0, 0, 1]\nspot = { cutoff = 20 }\n", "5:8: light: a directional light has no sp",
     "a point light has a position instead", "position = [0, 0, 1]\nspot = { cutoff = 20 }\n"},
    {"direction = [0, 0, 0]\n", "4:13: light 1: direction: a direction needs a length",
     "one of its three numbers must not be 0", "direction = [0, 0, 1]\n"},
    {"position = [1, 2]\n", "4:12: light 1: position: must be three numbers",
     "such as [2, -3, 1.5], not an array of 2", "position = [2, -3, 1.5]\n"},
    {"position = ['foo', 0, 1]\n", "4:14: light 1: position: unknown name 'foo'",
     "known names: t pi e tau phi", "position = ['t', 0, 1]\n"},
    {"position = ['u', 0, 1]\n", "4:14: light 1: position: this must be a constant", "not u or v",
     "position = ['pi', 0, 1]\n"},
    {"spot = { angle = 20 }\n", "4:10: unknown key 'angle'", "known keys: direction cutoff inner",
     "spot = { cutoff = 20 }\n"},
    {"spot = { cutoff = 200 }\n", "4:19: light 1: cutoff: must be from 0 to 180", "", ""},
    {"spot = { cutoff = 20, inner = 30 }\n", "4:31: light 1: inner: the inner angle is larger",
     "cutoff is 20", "spot = { cutoff = 30, inner = 20 }\n"},
    {"spot = { cutoff = 20, exponent = -1 }\n", "4:34: light 1: exponent: must be at least 0", "",
     ""},
    {"spot = { falloff = 'hard' }\n", "4:20: light 1: falloff: must be \"linear\" or \"smooth\"",
     "", "spot = { falloff = 'smooth' }\n"},
    {"attenuation = [1, 0]\n", "4:15: light 1: attenuation: must be constant, linear and quadr",
     "[1, 0, 0], or { range = 50 }", "attenuation = { range = 50 }\n"},
    {"attenuation = [0, 0, 0]\n", "4:15: light 1: attenuation: one of the three must be more",
     "for example attenuation = [1, 0, 0]", "attenuation = [1, 0, 0]\n"},
    {"attenuation = [1, -1, 0]\n", "4:19: light 1: attenuation: must be at least 0", "", ""},
    {"attenuation = {}\n", "4:15: attenuation: 'range' is missing", "for example { range = 50 }",
     "attenuation = { range = 50 }\n"},
    {"attenuation = { range = 0 }\n", "4:25: light 1: range: must be more than 0", "", ""},
    {"frame = 'wrold'\n", "4:10: light 1: frame: no node is called 'wrold'",
     "known: eye world; did you mean 'world'?", "frame = 'world'\n"},
    {"enabled = [1]\n", "4:11: light 1: enabled: must be true, false or an expression in quotes",
     "", "enabled = 'sin(t)'\n"},
};

TEST_F(SceneFileMessages, OfLights) {
  expect_in_files("[[surface]]\nz = 'u'\n[[light]]\n", kLights);
}

constexpr FileRow kNodes[] = {
    {"transform = []\n", "3:1: node: 'name' is missing", "refer to a node by its name",
     "name = 'a'\ntransform = []\n"},
    {"name = 'eye'\n", "4:8: node: a node cannot be called 'eye'", "choose another name",
     "name = 'e'\n"},
    {"name = ''\n", "4:8: node: a node cannot be called ''", "choose another name", ""},
    {"name = 'a'\n[[node]]\nname = 'a'\n", "4:9: node a: name: a second node is called 'a'",
     "give each its own name", "name = 'a'\n[[node]]\nname = 'b'\n"},
    {"name = 'a'\nin = 'b'\n[[node]]\nname = 'b'\nin = 'a'\n",
     "5:7: node a: in: a node that is in itself: a -> b -> a", "break the circle",
     "name = 'a'\nin = 'b'\n[[node]]\nname = 'b'\n"},
    {"name = 'a'\nin = 'weel'\n[[node]]\nname = 'wheel'\n",
     "5:7: node a: in: no node is called 'weel'", "did you mean 'wheel'?",
     "name = 'a'\nin = 'wheel'\n[[node]]\nname = 'wheel'\n"},
    {"name = 'a'\ntransform = { scale = 2 }\n", "5:13: transform: must be a list such as",
     "[ { scale = 2 } ], not a table", "name = 'a'\ntransform = [ { scale = 2 } ]\n"},
    {"name = 'a'\ntransform = [ { scale = 2, translate = [1, 0, 0] } ]\n",
     "5:15: transform: each step is one of translate, rotate and scale",
     "for example [ { rotate = [90, 0, 0, 1] }, { scale = 2 } ]",
     "name = 'a'\ntransform = [ { rotate = [90, 0, 0, 1] }, { scale = 2 } ]\n"},
    {"name = 'a'\ntransform = [ { move = [1, 0, 0] } ]\n", "5:17: unknown key 'move'",
     "known keys: translate rotate scale",
     "name = 'a'\ntransform = [ { translate = [1, 0, 0] } ]\n"},
    {"name = 'a'\ntransform = [ { rotate = [90, 0, 0] } ]\n",
     "5:26: node a: rotate: must be an angle and an axis", "[90, 0, 0, 1], not an array of 3",
     "name = 'a'\ntransform = [ { rotate = [90, 0, 0, 1] } ]\n"},
    {"name = 'a'\ntransform = [ { rotate = [90, 0, 0, 0] } ]\n",
     "5:26: node a: rotate: a direction needs a length", "one of its three numbers must not be 0",
     ""},
    {"name = 'a'\ntransform = [ { scale = 'big' } ]\n", "5:26: node a: scale: unknown name 'big'",
     "known names: t pi", "name = 'a'\ntransform = [ { scale = 'pi' } ]\n"},
};

TEST_F(SceneFileMessages, OfNodes) {
  expect_in_files("[[surface]]\nz = 'u'\n[[node]]\n", kNodes);
  std::string chain = "[[surface]]\nz = 'u'\n";
  for (int i = 0; i < 300; ++i) {
    chain += "[[node]]\nname = 'n" + std::to_string(i) + "'\n";
    if (i > 0) chain += "in = 'n" + std::to_string(i - 1) + "'\n";
  }
  EXPECT_TRUE(contains(error_of(draw(chain), 2), "nodes in each other more than 256 deep"));
}

constexpr FileRow kSurfaces[] = {
    {"in = 'wheel'\n", "3:7: surface 1: in: no node is called 'wheel'", "the scene has no [[node]]",
     "in = 'wheel'\n[[node]]\nname = 'wheel'\n"},
    {"in = []\n", "3:6: surface 1: in: there is no node in it", "leave it out", ""},
    {"u = [0]\n", "3:5: surface 1: u: must be two ends", "such as [\"0\", \"2*pi\"]",
     "u = [\"0\", \"2*pi\"]\n"},
    {"opacity = 2\n", "3:11: surface 1: opacity: must be from 0 to 1", "", ""},
    {"opacity = 'foo'\n", "3:12: surface 1: opacity: unknown name 'foo'", "known names: t pi",
     "opacity = '1/pi'\n"},
    {"colormap = 'magma'\n", "3:12: surface 1: colormap: there is nothing to colour",
     "color = \"z\" colours by height", "colormap = 'magma'\ncolor = \"z\"\n"},
    {"color = 'z'\ncolormap = 'mgma'\n", "4:13: surface 1: colormap: no colormap is called 'mgma'",
     "did you mean 'magma'?", "color = 'z'\ncolormap = 'magma'\n"},
    {"p = [0, 1]\n", "3:1: unknown key 'p'", "known keys:", "u = [0, 1]\n"},
    {"[light]\ncolor = 'red'\n", "3:1: light: must be written as [[light]]", "",
     "[[light]]\ncolor = 'red'\n"},
    {"[animation]\nframes = 2.5\n", "4:10: frames: must be a whole number from 1 to 1000000", "",
     ""},
    {"[camera]\nviw = 'front'\n", "4:1: unknown key 'viw'", "did you mean 'view'?",
     "[camera]\nview = 'front'\n"},
    {"[camera]\nview = 'frnt'\n", "4:9: view: no view has this name", "front back left right",
     "[camera]\nview = 'front'\n"},
    {"[params]\nk = { min = 0, max = 1 }\n", "4:5: k: 'value' is missing",
     "for example { value = 1, min = 0, max = 2 }",
     "[params]\nk = { value = 1, min = 0, max = 2 }\n"},
    {"[params]\nk = { value = 1, min = 2, max = 1 }\n", "4:33: k: max: min must be less than max",
     "", ""},
    {"[params]\n'2a' = 3\n", "4:1: ", "does not begin with a digit", "[params]\na2 = 3\n"},
    {"[params]\nk = 9007199254740993\n", "4:5: a whole number beyond 2^53, which is not exact",
     "write 9007199254740993.0 for the nearest double", "[params]\nk = 9007199254740993.0\n"},
    {"[functions]\nf = 's'\n", "4:1: 'f' is not a function", "\"bump(s)\" = \"exp(-s*s)\"",
     "[functions]\n\"bump(s)\" = \"exp(-s*s)\"\n"},
    {"parameters = ['p', 'p']\n", "3:14: surface 1: parameters: both parameters are called 'p'",
     "give each its own name", "parameters = ['p', 'q']\nx = 'p'\ny = 'q'\n"},
    {"params = { u = 3 }\n", "3:16: u: 'u' cannot be defined",
     "u is a parameter of the surface; choose another name", "params = { w = 3 }\n"},
    {"params = { t = 3 }\n", "3:16: t: 't' cannot be defined",
     "u, v and t are what formulas depend on", "params = { w = 3 }\n"},
    {"u = ['u', 1]\n", "3:5: u: the range of u depends on itself",
     "both ends are constant expressions, for example u = [\"0\", \"2*pi\"]",
     "u = [\"0\", \"2*pi\"]\n"},
    {"v = ['v', 1]\n", "3:5: v: the range of v depends on itself",
     "its ends may depend on u, for example v = [\"0\", \"sin(u)\"]", "v = [\"0\", \"sin(u)\"]\n"},
    {"u = [1, 1]\n", "3:5: u: the range of u is empty", "for example u = [\"0\", \"2*pi\"]",
     "u = [\"0\", \"2*pi\"]\n"},
    {"[animation]\nt = [1, 1]\n", "4:6: animation: t: the range of t is empty",
     "for example t = [\"0\", \"2*pi\"]", "[animation]\nt = [\"0\", \"2*pi\"]\n"},
    {"color = 'z'\ntexture = 'checker'\n",
     "3:10: surface 1: color: a surface has a colour by a formula or a texture, not both",
     "leave one of them out", "color = 'z'\n"},
    {"[camera]\nview = [1, 2, 3]\nangles = [1, 2]\n", "5:10: angles: says again what 'view' says",
     "leave one of the two out", "[camera]\nangles = [1, 2]\n"},
    {"[params]\nk = { value = 0, choices = [''] }\n",
     "4:29: k: choices: '' cannot be the name of a choice",
     "for example choices = [\"sun\", \"lamp\"]",
     "[params]\nk = { value = 0, choices = [\"sun\", \"lamp\"] }\n"},
    {"[params]\nk = { value = 0, choices = ['a', 'a'] }\n", "4:34: k: choices: 'a' is there twice",
     "for example choices", ""},
    {"[params]\nk = { value = 0, choices = ['a'] }\n",
     "4:28: k: choices: a choice is between two names or more", "for example choices", ""},
    {"[params]\nk = { value = 1, min = 2, max = 1 }\n", "4:33: k: max: min must be less than max",
     "", ""},
    {"[params]\nf = 2\n[functions]\n'f(s)' = 's'\n", "6:10: f(s): 'f' is defined twice",
     "choose another name", "[params]\nf = 2\n[functions]\n'g(s)' = 's'\n"},
    {"[params]\n'k(s)' = 's'\n", "4:1: 'k(s)' is not a name", "functions go into [functions]",
     "[functions]\n'k(s)' = 's'\n"},
    {"[params]\nu = 2\n", "4:5: u: 'u' cannot be defined", "u, v and t are what formulas depend on",
     "[params]\nw = 2\n"},
    {"parameters = ['p', 'q']\nu = [0, 1]\n", "4:1: unknown key 'u'", "p q",
     "parameters = ['p', 'q']\np = [0, 1]\n"},
};

TEST_F(SceneFileMessages, OfSurfacesAndTheirTables) {
  expect_in_files("[[surface]]\nz = '1'\n", kSurfaces);
}

constexpr FileRow kFiles[] = {
    {"grif = 3\n", "1:1: unknown key 'grif'", "known keys:", ""},
    {"title = 3\n", "1:9: title: must be", "", ""},
    {"title = torus\n", "1:10: ", "text stands in quotes: title = \"Torus\"", ""},
    {"title = 'nothing'\n", "1:1: the scene has no [[surface]], [[curve]] or [[point]]",
     "saddle show torus", ""},
    {"t = nan\n[[surface]]\nz = 'u'\n", "1:5: not a finite number", "every number of a scene", ""},
    {"axes = 1\n[[surface]]\nz = 'u'\n", "1:8: axes: must be true or false, not a number", "",
     "axes = true\n[[surface]]\nz = 'u'\n"},
    {"size = [0, 5]\n[[surface]]\nz = 'u'\n", "1:8: size: must be from 1 to 16384", "",
     "size = [1, 5]\n[[surface]]\nz = 'u'\n"},
    {"z = 'u*v'\n", "1:1: unknown key 'z'", "'z' belongs below [[surface]]",
     "[[surface]]\nz = 'u*v'\n"},
    {"zoom = 2\n[[surface]]\nz = 'u'\n", "1:1: unknown key 'zoom'", "'zoom' belongs below [camera]",
     "[camera]\nzoom = 2\n[[surface]]\nz = 'u'\n"},
    {"[[surface]]\nz = 'u'\naxes = true\n", "3:1: unknown key 'axes'",
     "'axes' belongs above all tables", "axes = true\n[[surface]]\nz = 'u'\n"},
    {"[[surface]]\nz = 'a*u'\n", "2:6: z: unknown name 'a'", "a = 1 below [params] defines it",
     "[params]\na = 1\n[[surface]]\nz = 'a*u'\n"},
    {"surface = 3\n", "1:11: surface: must be written as [[surface]]", "",
     "[[surface]]\nz = 'u'\n"},
    {"[[surface]]\nx = 'u'\n", "1:1: surface: z has no formula",
     "z has no default: for example z = \"u*v\"", "[[surface]]\nx = 'u'\nz = \"u*v\"\n"},
    {"[[surface]]\nz = ''\n", "2:5: surface 1: z: the expression is empty", "", ""},
    {"[[surface]]\nz = 9007199254740993\n", "2:5: a whole number beyond 2^53, which is not exact",
     "write 9007199254740993.0 for the nearest double", "[[surface]]\nz = 9007199254740993.0\n"},
    {"labels = ['a', 'b']\n[[surface]]\nz = 'u'\n", "1:10: labels: must be three texts", "",
     "labels = ['a', 'b', 'c']\n[[surface]]\nz = 'u'\n"},
    {"[[surface]]\nz = true\n", "2:5: surface 1: z: must be a formula in quotes, or a number", "",
     "[[surface]]\nz = 1\n"},
    {"[[surface]]\nz = 'foo(u)'\n", "2:6: z: unknown name 'foo'", "did you mean 'floor'?",
     "[[surface]]\nz = 'floor(u)'\n"},
    {"[[curve]]\nu = 's'\nv = 0\n", "2:6: u: there is no surface for u and v", "x, y and z",
     "[[curve]]\nx = 's'\ny = 0\nz = 0\n"},
    {"[[curve]]\ns = [0, 1]\n", "1:1: the curve has no place", "x='cos(s)'",
     "[[curve]]\ns = [0, 1]\nx='cos(s)'\n"},
    {"[[curve]]\nu = 's'\non = 'tours'\nv = 0\n[[surface]]\nname = 'torus'\nz = 'u'\n",
     "3:7: on: no surface is called 'tours'", "did you mean 'torus'?",
     "[[curve]]\nu = 's'\non = 'torus'\nv = 0\n[[surface]]\nname = 'torus'\nz = 'u'\n"},
    {"[[curve]]\nu = 's'\nv = 0\n[[surface]]\nname = 'a'\nz = 'u'\n[[surface]]\nname='b'\nz='u'\n",
     "2:6: u: 'on' must say which surface u and v are of", "known surfaces: 'a' 'b'",
     "[[curve]]\nu='s'\nv=0\non='a'\n[[surface]]\nname='a'\nz='u'\n[[surface]]\nname='b'\nz='u'\n"},
    {"[[point]]\nx = 1\n", "2:1: unknown key 'x'", "at", "[[point]]\nat = [1, 2, 3]\n"},
    {"[[point]]\nat = [1, 2]\n", "2:6: point 1: at: must be three numbers", "[2, -3, 1.5]",
     "[[point]]\nat = [2, -3, 1.5]\n"},
    {"[[point]]\nat = [1, 2, 3]\nu = 1\nv = 2\n[[surface]]\nz = 'u'\n",
     "3:5: u: the point has two places", "leave one of them out",
     "[[point]]\nu = 1\nv = 2\n[[surface]]\nz = 'u'\n"},
};

TEST_F(SceneFileMessages, OfTheWholeFile) {
  expect_in_files("", kFiles);
  std::string deep = "a";
  for (int i = 0; i < 80; ++i) deep += ".a";
  EXPECT_TRUE(contains(error_of(draw(deep + " = 1\n"), 2), "a key of more than 64 parts"));
}

constexpr MessageRow kNoScenes[] = {
    {"plain.png -o a.toml", "plain.png is not a PNG file", "", ""},
    {"cut.png -o a.toml", "cut.png is a damaged PNG file: ", "", ""},
    {"bare.png -o a.toml", "bare.png holds no scene",
     "a file keeps its scene until another program saves it", ""},
    {"solid.stl -o a.toml", "solid.stl holds no scene",
     ".stl has no room for one; these have: .png .ply .obj", ""},
    {"large.toml -o a.toml", "large.toml is larger than 4 MiB", "saddle show torus prints one",
     "show torus"},
    {"large.obj -o a.toml", "large.obj:1:1: a scene file of more than 4 MiB",
     "saddle show torus prints a scene", "show torus"},
};

TEST_F(SceneFileMessages, OfFilesWithoutAScene) {
  std::ofstream(path("plain.png")) << "no picture";
  ASSERT_EQ(run("sphere -s 32x24 -o sphere.png -o solid.stl").status, 0);
  const std::string picture = read_file(path("sphere.png"));
  std::ofstream(path("cut.png")) << picture.substr(0, picture.size() / 2);
  ASSERT_EQ(run("torus -s 32x24 --reference sphere.png").status, 1);
  std::filesystem::rename(path("sphere.png.diff.png"), path("bare.png"));
  std::ofstream(path("large.toml")) << std::string(std::size_t{5} << 20, ' ');
  std::ofstream large(path("large.obj"));
  for (int i = 0; i < 30'000; ++i) large << "# scene # " << std::string(180, 'a') << '\n';
  large.close();
  expect_errors(kNoScenes, 2);
}

constexpr MessageRow kNodesOfSecond[] = {
    {"node.toml + node.toml -o a.toml", "the nodes of a second scene, 'saddle'",
     "name that scene first", "torus + node.toml -o a.toml"},
};

constexpr MessageRow kOwnParameters[] = {
    {"own.toml r=0.3 -o a.toml", "argument: the scene has no 'r' of its own",
     "surface 'two' has one, which its file alone changes: params = { r = ... }",
     "own.toml k=3 -o a.toml"},
    {"own.toml q=0.3 -o a.toml", "argument: the scene has no 'q'", "known names: k x y z u v t",
     "own.toml k=3 -o a.toml"},
};

TEST_F(SceneFileMessages, OfOverridesTellWhoseAParameterIs) {
  std::ofstream(path("own.toml")) << "[params]\nk = 2\n[[surface]]\nz = 'k*u'\n[[surface]]\n"
                                     "name = 'two'\nz = 'r*u'\nparams = { r = 1 }\n";
  expect_errors(kOwnParameters, 2);
}

TEST_F(SceneFileMessages, OfTwoFilesWithNodes) {
  std::ofstream(path("node.toml"))
      << "[[surface]]\nz = \"u\"\nin = \"w\"\n[[node]]\nname = \"w\"\n";
  expect_errors(kNodesOfSecond, 2);
}

}  // namespace
}  // namespace saddle
