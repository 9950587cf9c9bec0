#include "scene/options/unused_definitions.h"

#include <gtest/gtest.h>

#include "scene/model/assignments.h"
#include "scene/model/gallery.h"

namespace saddle {
namespace {

using Names = std::vector<std::string>;

Scene scene_of(const Names& assignments) {
  Scene scene;
  for (const std::string& assignment : assignments) assign(scene, assignment);
  return scene;
}

TEST(UnusedDefinitions, AreThoseThatNothingDependsOn) {
  EXPECT_EQ(unused_definitions(scene_of({"z=a*u", "a=1"})), Names{});
  EXPECT_EQ(unused_definitions(scene_of({"z=u", "k=3"})), Names{"k"});
  EXPECT_EQ(unused_definitions(scene_of({"z=f(u)", "f(s)=b*s", "b=2"})), Names{});
  EXPECT_EQ(unused_definitions(scene_of({"z=u", "m=k", "k=1"})), (Names{"m", "k"}));
  EXPECT_EQ(unused_definitions(scene_of({"z=kk", "kk=u", "k=1"})), Names{"k"}) << "whole names";
  EXPECT_EQ(unused_definitions(scene_of({"z=φ*θ", "phi=1", "θ=2"})), Names{});
  EXPECT_EQ(unused_definitions(scene_of({"z=u", "u=0:k", "v=a:1", "k=3", "a=0"})), Names{});
}

TEST(UnusedDefinitions, ArgumentsOfHelperFunctionsAreOtherNames) {
  EXPECT_EQ(unused_definitions(scene_of({"z=f(u)", "f(k)=k^2", "k=3"})), Names{"k"});
}

TEST(UnusedDefinitions, MayBeUsedByAnyNumberOfTheScene) {
  Scene scene = scene_of({"z=u", "k=3", "d=2", "c=1"});
  scene.camera.distance = Number("k+1");
  scene.surfaces[0].color = "c*z";
  EXPECT_EQ(unused_definitions(scene), Names{"d"});
  scene.lights[0].enabled = Number("d");
  EXPECT_EQ(unused_definitions(scene), Names{});
}

TEST(UnusedDefinitions, AreInNoSurfaceOfTheGallery) {
  for (const GalleryEntry& entry : gallery()) {
    EXPECT_EQ(unused_definitions(gallery_scene(entry)), Names{}) << entry.name;
  }
}

}  // namespace
}  // namespace saddle
