#include "view/model/objects.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/model/gallery.h"
#include "scene/model/strokes.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

TEST(Objects, HaveNamesOfTheirOwn) {
  Scene scene = new_scene();
  for (int i = 0; i < 2; ++i) {
    add_surface(scene);
    add_curve(scene);
    add_point(scene);
  }
  EXPECT_EQ(scene.surfaces[2].name, scene.surfaces[0].name + " 3");
  EXPECT_EQ(scene.curves[1].name, "curve 2");
  EXPECT_EQ(scene.points[1].name, "point 2");
}

TEST(Objects, StayWhereTheyAreWhenTheirNodeHasAnotherNameOrGoes) {
  Scene scene = new_scene();
  add_curve(scene);
  for (int i = 0; i < 2; ++i) add_node(scene);
  ASSERT_EQ(scene.nodes[1].name, "node 2");
  scene.nodes[1].in = "node";
  scene.surfaces[0].in = {"node 2"};
  scene.curves[0].in = {"node"};
  scene.lights[0].frame = "node";
  rename_node(scene, 0, "car");
  EXPECT_EQ(scene.nodes[1].in, "car");
  EXPECT_EQ(scene.curves[0].in, std::vector<std::string>{"car"});
  EXPECT_EQ(scene.lights[0].frame, "car");
  EXPECT_NO_THROW(resolve(scene));
  delete_node(scene, 1);
  EXPECT_EQ(scene.surfaces[0].in, std::vector<std::string>{"car"}) << "in the node around it";
  delete_node(scene, 0);
  EXPECT_TRUE(scene.surfaces[0].in.empty());
  EXPECT_TRUE(scene.curves[0].in.empty());
  EXPECT_EQ(scene.lights[0].frame, "world");
  EXPECT_NO_THROW(resolve(scene));
}

TEST(Objects, KeepNodesApartThatAreGivenOneName) {
  Scene scene = new_scene();
  for (int i = 0; i < 2; ++i) add_node(scene);
  scene.surfaces[0].in = {"node 2"};
  rename_node(scene, 0, "node 2");  // on the way to "node 23", say
  EXPECT_THROW(resolve(scene), Error);
  rename_node(scene, 0, "node 23");
  EXPECT_EQ(scene.surfaces[0].in, std::vector<std::string>{"node 2"});
  EXPECT_NO_THROW(resolve(scene));
}

TEST(Objects, GoOntoASurfaceAndBackIntoSpace) {
  for (const GalleryEntry& entry : gallery()) {
    Scene scene = gallery_scene(entry);
    const std::string surface = scene.surfaces[0].name;
    add_curve(scene);
    add_point(scene);
    put_on(scene, scene.curves[0], surface);
    put_on(scene, scene.points[0], surface);
    EXPECT_TRUE(is_on_surface(scene.curves[0]));
    EXPECT_TRUE(is_on_surface(scene.points[0]));
    EXPECT_NO_THROW(with_strokes(resolve(scene))) << entry.name;
    put_on(scene, scene.curves[0], "");
    put_on(scene, scene.points[0], "");
    EXPECT_FALSE(is_on_surface(scene.curves[0]));
    EXPECT_FALSE(is_on_surface(scene.points[0]));
    EXPECT_NO_THROW(with_strokes(resolve(scene))) << entry.name;
  }
}

}  // namespace
}  // namespace saddle
