#include "scene/toml/scene_file.h"

#include <gtest/gtest.h>

#include "scene/model/assignments.h"
#include "scene/model/gallery.h"

namespace saddle {
namespace {

TEST(SceneFile, LeavesOutDefaults) {
  Scene scene;
  assign(scene, "z=u*v");
  EXPECT_EQ(write_scene(scene), "[[surface]]\nz = \"u*v\"\n");
}

TEST(SceneFile, WritesAGallerySurfaceAsDocumented) {
  EXPECT_EQ(write_scene(gallery_scene(*find_gallery_entry("torus"))),
            "title = \"torus\"\n"
            "\n"
            "[params]\n"
            "R = 2\n"
            "r = 0.8\n"
            "\n"
            "[[surface]]\n"
            "name = \"torus\"\n"
            "x = \"(R+r*cos(v))*cos(u)\"\n"
            "y = \"(R+r*cos(v))*sin(u)\"\n"
            "z = \"r*sin(v)\"\n"
            "u = [\"0\", \"2*pi\"]\n"
            "v = [\"0\", \"2*pi\"]\n"
            "\n"
            "[camera]\n"
            "view = [2, -3, 3]\n");
}

TEST(SceneFile, WritesWhatOptionsChange) {
  Scene scene;
  assign(scene, "z=u");
  scene.background = {1, 1, 1, 0};
  scene.t = 0.1;
  scene.surfaces[0].grid = GridSize{0, 16};
  scene.axes = true;
  scene.surfaces[0].color = "gauss";
  scene.surfaces[0].colormap = "gray";
  scene.surfaces[0].flip = true;
  scene.surfaces[0].opacity = Number("1/3");
  scene.surfaces[0].front.diffuse = {1, 0, 0, 1};
  scene.surfaces[0].back.diffuse = {0.1, 0.2, 0.3, 1};
  scene.surfaces[0].back.shininess = 8;
  scene.camera.up = {0, 1, 0};
  scene.camera.target = dvec3{1, 2, -0.5};
  scene.camera.distance = 24;
  scene.camera.fov = 45;
  scene.camera.ortho = true;
  scene.lights = {{.position = {1, 2, 3}, .directional = true, .color = {1, 1, 1}}};
  EXPECT_EQ(write_scene(scene),
            "background = \"#ffffff00\"\n"
            "axes = true\n"
            "t = 0.1\n"
            "\n"
            "[[surface]]\n"
            "z = \"u\"\n"
            "color = \"gauss\"\n"
            "colormap = \"gray\"\n"
            "grid = [0, 16]\n"
            "front = { diffuse = \"#ff0000\" }\n"
            "back = { diffuse = [0.1, 0.2, 0.3], shininess = 8 }\n"
            "flip = true\n"
            "opacity = \"1/3\"\n"
            "\n"
            "[[light]]\n"
            "direction = [1, 2, 3]\n"
            "color = \"#ffffff\"\n"
            "\n"
            "[camera]\n"
            "up = [0, 1, 0]\n"
            "target = [1, 2, -0.5]\n"
            "distance = 24\n"
            "fov = 45\n"
            "ortho = true\n");
}

TEST(SceneFile, WritesTheClipBoxAsItsOption) {
  Scene scene;
  scene.clip = {false, Bounds{dvec3(-1, -2, 0), dvec3(1, 2.5, 1e300)}};
  EXPECT_EQ(write_scene(scene), "clip = \"-1:1,-2:2.5,0:1e+300\"\n");
  scene.clip = {false, {}};
  EXPECT_EQ(write_scene(scene), "clip = \"off\"\n");
}

TEST(SceneFile, WritesParametersThatAreNumbersInTomlTooAsNumbers) {
  Scene scene;
  for (const char* text : {"a=2", "b=-0.5", "c=1e-3", "d=2.50E+4"}) assign(scene, text);
  const std::string params = "[params]\na = 2\nb = -0.5\nc = 1e-3\nd = 2.50E+4\n";
  EXPECT_EQ(write_scene(scene), params);
}

TEST(SceneFile, WritesOtherParametersAsStrings) {
  Scene scene;
  for (const char* text : {"a=.5", "b=1.", "c=007", "d=2*pi", "e=1e", "f=12345678901234567890",
                           "g=0x10", "h=--1", "i=1.5.2", "j=-"}) {
    assign(scene, text);
  }
  EXPECT_EQ(write_scene(scene),
            "[params]\na = \".5\"\nb = \"1.\"\nc = \"007\"\nd = \"2*pi\"\ne = \"1e\"\n"
            "f = \"12345678901234567890\"\ng = \"0x10\"\nh = \"--1\"\ni = \"1.5.2\"\nj = \"-\"\n");
}

TEST(SceneFile, WritesFunctionsWithTheirArguments) {
  Scene scene;
  assign(scene, "a=1");
  assign(scene, "bump(s,u)=exp(-s*s)*u");
  EXPECT_EQ(write_scene(scene),
            "[params]\na = 1\n\n[functions]\n\"bump(s, u)\" = \"exp(-s*s)*u\"\n");
}

TEST(SceneFile, EscapesWhatTomlStringsCannotHold) {
  Scene scene;
  scene.title = "a\"b\\c\n\td\x7f \xcf\x80";
  EXPECT_EQ(write_scene(scene), "title = \"a\\\"b\\\\c\\u000A\\u0009d\\u007F \xcf\x80\"\n");
}

TEST(SceneFile, NumbersReadBackAsTheSameDouble) {
  Scene scene;
  scene.t = 0.1 + 0.2;
  EXPECT_EQ(write_scene(scene), "t = 0.30000000000000004\n");
}

}  // namespace
}  // namespace saddle
