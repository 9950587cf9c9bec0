#include "scene/model/object_names.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace saddle {
namespace {

std::vector<std::string> numbered(const std::vector<std::string>& surfaces) {
  Scene scene;
  scene.surfaces.clear();
  for (const std::string& name : surfaces) scene.surfaces.emplace_back().name = name;
  number_names(scene);
  std::vector<std::string> names;
  for (const SurfaceSpec& surface : scene.surfaces) names.push_back(surface.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(ObjectNames, GetTheNextNumberThatIsFree) {
  EXPECT_EQ(numbered({"a", "b"}), (Names{"a", "b"}));
  EXPECT_EQ(numbered({"a", "b", "a", "a", "b"}), (Names{"a", "b", "a 2", "a 3", "b 2"}));
  EXPECT_EQ(numbered({"a", "a", "a 2", "a"}), (Names{"a", "a 3", "a 2", "a 4"}));
  EXPECT_EQ(numbered({"a", "a 2", "a 2", "a"}), (Names{"a", "a 2", "a 2 2", "a 3"}));
}

TEST(ObjectNames, AreOfSurfacesCurvesAndPoints) {
  Scene scene;
  scene.surfaces.assign(1, {});
  scene.surfaces[0].name = "curve";
  scene.curves.assign(2, {});
  scene.points.assign(1, {});
  number_names(scene);
  EXPECT_EQ(scene.curves[0].name, "curve 2");
  EXPECT_EQ(scene.curves[1].name, "curve 3");
  EXPECT_EQ(scene.points[0].name, "point");
}

}  // namespace
}  // namespace saddle
