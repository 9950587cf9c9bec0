// What to draw, as plain data with defaults. The command line (and later the scene file and the
// viewer) produce a Scene; meshing, rendering and writing consume it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "formula/scope.h"
#include "mesh/mesh.h"

namespace saddle {

/// Red, green, blue, alpha, each 0 to 1, as they appear on the screen (no gamma is applied).
struct Color {
  double r = 0, g = 0, b = 0, a = 1;
};

/// One side of a surface.
struct Material {
  Color diffuse;
  Color specular;
  double shininess = 32;  ///< exponent of the specular term, at least 0
};

inline constexpr Material kFrontMaterial{{1, 1, 0.5}, {0.2, 0.2, 0.2}, 32};
inline constexpr Material kBackMaterial{{0.5, 0.5, 1}, {0.1, 0.1, 0.1}, 32};

/// `u = MIN:MAX`, both constant expressions.
struct Range {
  std::string min = "-1";
  std::string max = "1";
};

struct SurfaceSpec {
  std::string name = "surface";
  std::string x = "u";
  std::string y = "v";
  std::string z;
  Range u;
  Range v;
  int grid_u = 16;  ///< lines of constant u and of constant v; 0 and 0: no lines
  int grid_v = 16;
  Material front = kFrontMaterial;
  Material back = kBackMaterial;
  bool flip = false;
};

/// A light in eye coordinates: the eye at the origin looks down -z, y is up.
struct Light {
  dvec3 position{0, 0, 0};  ///< of a point light; toward a directional one, any length but 0
  bool directional = false;
  Color color;
};

/// The three lights of a scene that names none.
std::vector<Light> default_lights();

struct Camera {
  dvec3 view{2, -3, 1.5};  ///< from the target toward the eye, any length but 0
  dvec3 up{0, 0, 1};
  std::optional<dvec3> target;     ///< default: centre of the bounding box
  std::optional<double> distance;  ///< from the target; default: the bounding sphere just fits
  double fov = 30;                 ///< vertical, degrees, more than 0 and less than 180
  bool ortho = false;              ///< the visible height is the perspective one at the target
};

/// The box that surfaces are cut along.
struct Clip {
  bool automatic = true;      ///< where one goes to infinity: a box that most of it is in
  std::optional<Bounds> box;  ///< this box, whatever the surface does
};

struct Scene {
  std::string title = "saddle";
  std::vector<Definition> definitions;  ///< parameters, shared sub-expressions, helper functions
  std::vector<SurfaceSpec> surfaces;
  std::vector<Light> lights = default_lights();
  Camera camera;
  Color background{0, 0, 0, 1};
  Clip clip;
  double t = 0;  ///< the moment that is drawn
};

}  // namespace saddle
