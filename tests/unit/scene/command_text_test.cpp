#include "scene/options/command_text.h"

#include <gtest/gtest.h>

#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

TEST(CommandText, SaysFormulasAndRangesThatAreNotTheDefault) {
  Scene scene;
  assign(scene, "z=sin(u)");
  assign(scene, "u=0:tau");
  EXPECT_EQ(command_text(scene), "saddle 'z=sin(u)' u=0:tau");
}

TEST(CommandText, QuotesForAShell) {
  Scene scene;
  assign(scene, "z=f(u)");
  assign(scene, "f(s)=s'");  // no formula, but a text
  EXPECT_EQ(command_text(scene), R"(saddle 'z=f(u)' 'f(s)=s'\''')");
}

TEST(CommandText, SaysCameraLookAndSettings) {
  Scene scene;
  assign(scene, "z=u");
  scene.camera.view = dvec3(0, 0, 1);
  scene.camera.ortho = true;
  scene.background = {1, 1, 1};
  scene.surfaces[0].flip = true;
  scene.surfaces[0].opacity = 0.5;
  scene.surfaces[0].color = "u*v";
  scene.surfaces[0].colormap = "magma";
  scene.axes = true;
  scene.surfaces[0].grid = GridSize{0, 0};
  scene.picture.width = 100;
  scene.picture.shading = Shading::Exact;
  scene.picture.specular = Specular::Blinn;
  scene.mesh.tolerance = ToleranceValue{0.25, true};
  EXPECT_EQ(command_text(scene),
            "saddle z=u --view 0,0,1 --ortho --background '#ffffff' --axes --size 100x600 "
            "--shading exact --specular blinn --color 'u*v' --colormap magma --grid off --flip "
            "--opacity 0.5 --tolerance 0.25px");
}

TEST(CommandText, RepeatsWhatMayBeRepeated) {
  Scene scene;
  assign(scene, "z=u");
  assign(scene, "k=3");
  scene.surfaces[0].contours = {{"z", {}}, {"gauss", {0, Number("2*k")}}};
  EXPECT_EQ(command_text(resolve(scene)), "saddle z=u k=3 --contours z --contours 'gauss=0,2*k'");
}

TEST(CommandText, SaysTheRangeOfTime) {
  Scene scene;
  assign(scene, "z=u*t");
  assign(scene, "t=1:tau");
  scene.animation->frames = 60;
  EXPECT_EQ(command_text(resolve(scene)), "saddle 'z=u*t' t=1:tau --frames 60");
  scene.t = 3;
  EXPECT_EQ(command_text(resolve(scene)), "saddle 'z=u*t' t=1:tau --t 3 --frames 60");
}

TEST(CommandText, LeavesToASceneFileWhatOnlyThatCanSay) {
  Scene scene;
  assign(scene, "z=u");
  scene.lights.pop_back();
  EXPECT_FALSE(command_text(scene));
  scene = Scene{};
  scene.surfaces.resize(2);
  EXPECT_FALSE(command_text(scene));
}

TEST(CommandText, SaysTheWholeGallery) {
  for (const GalleryEntry& entry : gallery()) {
    EXPECT_TRUE(command_text(gallery_scene(entry))) << entry.name;
  }
}

TEST(CommandText, HasNamesOfParametersAndRegions) {
  Scene scene;
  assign_all(scene, {"y=s*cos(x)", "z=s", "where=s<y", "u=0:1", "x=-1:1", "s=3"});
  const auto text = command_text(scene);
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "saddle 'y=s*cos(x)' z=s 'where=s<y' u=0:1 x=-1:1 s=3");
  // The command line calls x the first parameter.
  scene.surfaces[0].parameters = {"a", "x"};
  EXPECT_FALSE(command_text(scene));
}

}  // namespace
}  // namespace saddle
