#include "scene/model/object_names.h"

#include <map>
#include <set>
#include <string>

namespace saddle {
namespace {

template <typename Function>
void for_each_name(Scene& scene, const Function& visit) {
  for (SurfaceSpec& surface : scene.surfaces) visit(surface.name);
  for (CurveSpec& curve : scene.curves) visit(curve.name);
  for (PointSpec& point : scene.points) visit(point.name);
}

}  // namespace

void number_names(Scene& scene) {
  std::set<std::string> taken;
  for_each_name(scene, [&](const std::string& name) { taken.insert(name); });
  std::map<std::string, int> numbers;  // the last one behind each name
  for_each_name(scene, [&](std::string& name) {
    int& number = numbers[name];
    if (++number == 1) return;
    std::string numbered = name + " " + std::to_string(number);
    while (!taken.insert(numbered).second) numbered = name + " " + std::to_string(++number);
    name = numbered;
  });
}

}  // namespace saddle
