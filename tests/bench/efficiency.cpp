// Triangles against the least possible, and the distance of mesh and surface both ways, as a table:
// ./dev efficiency [SURFACE...], or all for the whole gallery (minutes). The distances are measured
// by study/mesh_distance, which shares nothing with the mesher, in 50 digits.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/mesher/mesher.h"
#include "meshing/tessellate.h"
#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"
#include "study/mesh_distance.h"

namespace {

using namespace saddle;

/// Of the diagonal of the bounding box.
constexpr std::array kTolerances = {1e-2, 1e-3, 1e-4};

const std::vector<std::string> kSurfaces = {"sphere",
                                            "torus",
                                            "catenoid",
                                            "enneper",
                                            "seashell",
                                            "peak",
                                            "monkey-saddle",
                                            "helicoid",
                                            "dini",
                                            "trefoil-tube",
                                            "boy",
                                            "klein-figure8",
                                            "ellipsoid",
                                            "scherk-1",
                                            "kuen",
                                            "mobius",
                                            "superellipsoid",
                                            "hyperbolic-paraboloid"};

Scene scene_of(const std::string& name) {
  Scene scene;
  if (name == "peak") {
    assign(scene, "z=exp(-40*((u-0.3)^2+(v+0.2)^2))");
  } else if (const GalleryEntry* const entry = find_gallery_entry(name)) {
    scene = gallery_scene(*entry);
  } else {
    throw unknown_gallery_name(name);
  }
  return resolve(scene);
}

/// Sums of logarithms, of a table's ratios.
struct Mean {
  double sum = 0;
  int count = 0;

  void add(double ratio) {
    sum += std::log(ratio);
    ++count;
  }
  double value() const { return std::exp(sum / count); }
};

/// The box that the program clips a surface to, by itself if it goes to infinity.
std::optional<Bounds> clip_of(const Scene& scene) {
  if (scene.clip.box || !scene.clip.automatic) return scene.clip.box;
  Scene coarse = scene;
  coarse.mesh.tolerance = ToleranceValue{kTolerances[0], false};
  Purpose purpose;
  purpose.mesh = true;
  return tessellate(coarse, coarse.surfaces.at(0), purpose, 0).report.clip;
}

void measure(const std::string& name, Mean& mean) {
  const Scene scene = scene_of(name);
  Subject subject(scene, scene.surfaces.at(0));
  subject.clip = clip_of(scene);
  const MeshDistance distance(subject);
  for (const double share : kTolerances) {
    double length = 0;
    MeshRequest options;
    options.tolerance = [&](const Probe& probe) -> Tolerance {
      length = share * probe.bounds().diagonal();
      return [length](const dvec3&) { return length; };
    };
    options.clip = subject.clip;
    options.lines = {0, 0};
    const auto mesh = try_mesh(subject.surface, options);
    if (!mesh) throw Error(Status::Nothing, name + " has no mesh");
    const auto triangles = static_cast<double>(mesh->mesh.triangles.size());
    const double ratio = triangles / mesh->report.least_triangles;
    std::printf("%-24s %8.0e %10.3f %10.3f %10.0f ", name.c_str(), share,
                distance(mesh->mesh) / length, mesh->report.max_error / length, triangles);
    // Where the surface is not curved there is no least, and of what is clipped away too much.
    if (mesh->report.least_triangles >= 1 && !subject.clip) {
      mean.add(ratio);
      std::printf("%10.0f %7.2f\n", std::ceil(mesh->report.least_triangles), ratio);
    } else {
      std::printf("%10s %7s\n", "-", "-");
    }
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> asked(argv + 1, argv + argc);
  if (asked == std::vector<std::string>{"all"}) {
    asked.clear();
    for (const GalleryEntry& entry : gallery()) asked.emplace_back(entry.name);
  }
  std::printf(
      "Meshes without grid lines. Tolerances are parts of the bounding box's diagonal; distances\n"
      "of mesh and surface, the larger of both ways, are in tolerances: measured, and as "
      "reported.\n"
      "T_min: triangles that no mesh with its corners on the surface can do without.\n\n"
      "%-24s %8s %10s %10s %10s %10s %7s\n",
      "surface", "tolerance", "measured", "reported", "triangles", "T_min", "ratio");
  try {
    Mean mean;
    for (const std::string& name : asked.empty() ? kSurfaces : asked) measure(name, mean);
    std::printf("\ngeometric mean of the ratios: %.2f\n", mean.value());
  } catch (const Error& error) {
    std::fputs(format_error(error).c_str(), stderr);
    return static_cast<int>(error.status());
  }
  return 0;
}
