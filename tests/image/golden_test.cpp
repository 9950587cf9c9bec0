// Pictures of the gallery and of the default scene against golden ones that people have looked at.
// Accept new ones with ./dev golden, never blindly: it shows old, new and difference.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/image_compare.h"
#include "base/image_png.h"
#include "paths.h"
#include "scene/model/gallery.h"

namespace saddle {
namespace {

/// The same picture may differ by this on another machine: some edges and lines in a window. A grid
/// line that is missing, a highlight that is gone or a swapped side costs four times more.
constexpr double kSamePicture = 0.02;

struct Golden {
  std::string name;
  std::string arguments;
};

std::vector<Golden> golden_pictures() {
  std::vector<Golden> pictures = {
      {"default-scene",
       "x=u y='2*sin(u)*cos(2*v)' z=v u=-6:6 v=-6:6 --flip --view 2,1,3 --up 0,1,0 "
       "--target 0,0,0 --distance 24 --fov 45 -s 250x250"},
      {"height-field", "z='sin(u)*cos(v)' u=-3:3 v=-3:3"},
      {"saddle-from-below", "hyperbolic-paraboloid --view 1,-2,-1"},
      {"sphere-from-inside", "sphere --target 0,0,0 --distance 0.5 --fov 80"},
      {"torus-orthographic", "torus --ortho --view 0,0,1"},
      {"torus-transparent", "torus --background transparent"},
      {"mobius-coloured", "mobius --front tomato --back '#00ff00' --grid off"},
      {"hole-where-undefined", "z='sqrt(u*v)' u=-1:1 v=-1:1"},
      {"no-antialiasing", "enneper --antialias 1"},
      {"axes-torus", "torus --axes -s 320x240"},
      {"axes-from-above", "torus --axes --view 0,0,1 -s 320x240"},
      {"axes-orthographic",
       "monkey-saddle --axes --ortho --view 1,0,0 --background white -s 320x240"},
      {"axes-from-below", "z='u*v^2+1e6' --axes --view -2,1,-1.5 -s 320x240"},
      {"color-height", "z='sin(u)*cos(v)' u=-3:3 v=-3:3 --axes --color z -s 320x240"},
      {"curves-and-points",
       "curve x=s y='abs(s)' s=-1:1 --radius 0.1 + curve x='2+cos(s)' y='sin(s)' s=0:tau "
       "--radius 0.1 --color gold + curve x=s y=1/s z=0.5 s=-2:2 --color lime --line-width 2 "
       "+ point 0,-1,0 --radius 0.2 --color white --label ball + point 1,-1,0 --label dot "
       "--clip -1:3.5,-2:2,-1:1"},
      {"contours-peak", "z='exp(-(u^2+v^2))' u=-2:2 v=-2:2 --contours z --grid off -s 320x240"},
      {"contours-gauss",
       "torus --color gauss --colormap coolwarm --color-range symmetric --contours gauss=0 "
       "--shading unlit --grid off -s 320x240"},
      {"color-cyclic",
       "z='u*v' --color 'atan2(v,u)' --colormap twilight --shading unlit --view 0,-1,3 -s 320x240"},
      {"color-range", "torus --color z --color-range -0.2:0.5 --contours z -s 320x240"},
      {"color-undefined", "z='u*v' --color 'sqrt(u)+floor(2*v)' --colormap plasma -s 320x240"},
  };
  for (const auto& [name, arguments] :
       std::vector<std::pair<std::string, std::string>>{{"catenoid-helicoid", "--t 1.2"},
                                                        {"drum", ""},
                                                        {"shell", ""},
                                                        {"over-a-disc", "--t 0.5"},
                                                        {"knot", ""},
                                                        {"planets", "--t 2"},
                                                        {"axes", ""},
                                                        {"curvature", ""},
                                                        {"torus-knot", ""},
                                                        {"color", ""},
                                                        {"texture", ""},
                                                        {"colonnade", ""}}) {
    pictures.push_back({"example-" + name, source_folder() + "/examples/" + name + ".toml " +
                                               arguments + " -s 240x180"});
  }
  const std::string examples = source_folder() + "/examples/lighting/";
  pictures.push_back({"exact-normals", source_folder() + "/examples/exact-normals.toml"});
  pictures.push_back({"see-through", source_folder() + "/examples/see-through.toml"});
  for (const auto& [name, arguments] : std::vector<std::pair<std::string, std::string>>{
           {"viewpoint-cube", "light=0"},
           {"viewpoint-cube", "light=1"},
           {"specular-torus", "--shading vertex --samples 16x8"},
           {"side-by-side", ""},
           {"specular-torus", "light=4"},
           {"low-resolution", ""},
           {"low-resolution", "--shading vertex"},
           {"function-grapher", ""},
           {"spotlights", "exponent=0"},
           {"spotlights", ""},
           {"spotlights", "exponent=20"},
           {"spotlights", "animate=1 --t 2"},
           {"diskworld", ""},
           {"diskworld", "--t 5"},
           {"light-casters", "light=0"},
           {"light-casters", "light=1"},
           {"light-casters", "light=2"},
           {"light-casters", "light=3"},
           {"light-casters", "light=4"},
           {"light-casters", "light=4 --t 10"},
           {"diffuse-reflection", "light=3"},
           {"pedestals", ""},
           {"spot-edges", "edge=2"}}) {
    std::string suffix = arguments;
    for (char& c : suffix) c = c == ' ' || c == '=' ? '-' : c;
    for (std::size_t at = 0; (at = suffix.find("--")) != std::string::npos;) suffix.erase(at, 1);
    if (suffix.starts_with('-')) suffix.erase(0, 1);
    pictures.push_back({"lighting-" + name + (suffix.empty() ? "" : "-" + suffix),
                        examples + name + ".toml " + arguments +
                            (name == "low-resolution" ? " -s 400x160"
                             : name == "side-by-side" ? " -s 400x200"
                                                      : " -s 200x200")});
  }
  for (const GalleryEntry& entry : gallery()) {
    pictures.push_back({"gallery-" + std::string(entry.name), std::string(entry.name)});
  }
  return pictures;
}

/// Where `./dev golden` wants the fresh pictures; by default they are thrown away.
std::string output_folder() {
  const char* const wanted = std::getenv("SADDLE_GOLDEN_OUT");
  return wanted != nullptr ? wanted : ::testing::TempDir();
}

class GoldenPicture : public ::testing::TestWithParam<Golden> {};

TEST_P(GoldenPicture, LooksAsItDid) {
  const Golden& golden = GetParam();
  const std::filesystem::path fresh =
      std::filesystem::path(output_folder()) / (golden.name + ".png");
  const std::string size = golden.arguments.find("-s ") == std::string::npos ? " -s 240x180" : "";
  const std::string command =
      program_path() + " " + golden.arguments + size + " --quiet -o " + fresh.string();
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  const std::string known = source_folder() + "/tests/golden/" + golden.name + ".png";
  ASSERT_TRUE(std::filesystem::exists(known)) << "no golden picture; look at it: ./dev golden";
  const ImageDifference difference =
      compare_images(read_png(known).image, read_png(fresh.string()).image);
  EXPECT_LE(difference.error, kSamePicture)
      << "largest difference " << difference.largest << ", mean " << difference.mean << "\n"
      << "compare " << known << "\nwith the picture of " << command;
  if (std::getenv("SADDLE_GOLDEN_OUT") == nullptr) std::filesystem::remove(fresh);
}

std::string test_name(const ::testing::TestParamInfo<Golden>& info) {
  std::string name = info.param.name;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, GoldenPicture, ::testing::ValuesIn(golden_pictures()), test_name);

}  // namespace
}  // namespace saddle
