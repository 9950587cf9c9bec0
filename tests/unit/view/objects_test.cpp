#include "view/model/objects.h"

#include <gtest/gtest.h>

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
