// A scene as plain data with defaults. The command line, the scene file and the viewer produce a
// Scene; meshing, rendering and writing consume it.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/bounds.h"
#include "base/image.h"
#include "base/vec.h"
#include "formula/scope.h"
#include "mesh/color/drawn_colors.h"

namespace saddle {

/// A number of a scene: plain, or an expression of the parameters and t, whose value resolve() of
/// scene/options/resolve.h fills in. It is used as the double that it is.
struct Number {
  double value = 0;
  std::string text = {};  ///< the expression; empty: a plain number

  Number() = default;
  Number(double plain) : value(plain) {}  // NOLINT: meant to convert
  explicit Number(std::string expression) : text(std::move(expression)) {}
  operator double() const { return value; }  // NOLINT: meant to convert
  /// Two numbers are equal if both their texts and their values are.
  bool operator==(const Number&) const = default;
  /// A plain number is compared with the value.
  template <typename Plain>
  requires std::is_arithmetic_v<Plain>
  bool operator==(Plain plain) const { return value == plain; }
};

/// Three of them: a point or a direction.
struct Vector {
  Number x, y, z;

  Vector() = default;
  Vector(Number a, Number b, Number c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  Vector(const dvec3& v) : x(v.x), y(v.y), z(v.z) {}              // NOLINT: meant to convert
  operator dvec3() const { return {x.value, y.value, z.value}; }  // NOLINT: meant to convert
  bool operator==(const Vector&) const = default;
};

/// Red, green, blue, alpha, each 0 to 1, as they appear on the screen (no gamma is applied).
struct Color {
  Number r = 0, g = 0, b = 0, a = 1;

  bool operator==(const Color&) const = default;
};

/// One side of a surface.
struct Material {
  Color diffuse;
  Color specular;
  Number shininess = 32;              ///< exponent of the specular term, at least 0
  std::optional<Color> ambient = {};  ///< default: the diffuse colour
  Color emission = {};                ///< light of its own

  bool operator==(const Material&) const = default;
};

inline const Material kFrontMaterial{{1, 1, 0.5}, {0.2, 0.2, 0.2}, 32};
inline const Material kBackMaterial{{0.5, 0.5, 1}, {0.1, 0.1, 0.1}, 32};

/// The colour of grid lines, and that of curves and points.
inline const Color kLineColor{0.2, 0.2, 0.2};
inline const Color kStrokeColor{1, 0.25, 0.2};

/// Which background, lines, letters and materials a scene has that names none: scene/model/theme.h.
enum class Theme { Dark, Light, Paper };

/// `u = MIN:MAX`, both constant expressions; those of v may depend on u.
struct Range {
  std::string min = "-1";
  std::string max = "1";
};

/// The values that the viewer offers for a parameter.
struct Slider {
  std::string name;
  Number min = 0;
  Number max = 1;
  Number step = 0;  ///< from `min` on; 0: any value between
  /// The parameter is the number of one of these, from 0 on, and nothing else.
  std::vector<std::string> choices = {};
};

/// `MxN`: M in u, N in v; or across and down.
struct GridSize {
  int u = 0;
  int v = 0;
};

/// Where the lighting equation is computed: at corners; at pixels, with the normal that is blended
/// from the corners'; or there with the formula's. Unlit: nowhere, the colour is the material's or
/// the colour map's.
enum class Shading { Vertex, Pixel, Exact, Unlit };

/// The direction that a highlight's angle is measured from: the mirrored light, or the half vector.
enum class Specular { Phong, Blinn };

/// The ends of a colour bar that the user asks for.
struct ColorEnds {
  bool symmetric = false;  ///< -M:M, M the largest absolute value drawn; else low:high
  Number low = -1;
  Number high = 1;

  bool operator==(const ColorEnds&) const = default;
};

/// Level lines of an expression on a surface.
struct ContourSpec {
  std::string expression;      ///< of u, v, x, y, z, gauss, mean
  std::vector<Number> levels;  ///< none: about ten round ones
  /// Round levels are chosen in this range; default: of what is drawn. An animation has one for all
  /// of its time, which is computed: scene files have none.
  std::optional<ColorRange> range = {};
};

/// How thick a surface is made, and on which of its sides.
struct Thickness {
  enum class Where { Both, Front, Back, Off };
  Number value = 0;           ///< more than 0: in the surface's units, or
  bool millimetres = false;   ///< of what is printed; see print_size
  Where where = Where::Both;  ///< half to each side, all to one, or: it has none

  bool operator==(const Thickness&) const = default;
};

/// A picture file in memory.
struct TexturePicture {
  Image image;
  std::string file;  ///< its bytes
};

/// Where a surface's diffuse colour comes from in place of its materials'. The picture covers the
/// ranges of u, to the right, and v, upward.
struct Texture {
  enum class Wrap { Repeat, Mirror, Clamp };
  enum class Filter { Smooth, Nearest };

  /// The picture's file as the user names it, or kChecker; empty with a picture: it came with the
  /// scene's text.
  std::string name;
  std::shared_ptr<const TexturePicture> picture;  ///< loaded once; null: a chequerboard, or none
  Wrap wrap = Wrap::Repeat;
  Filter filter = Filter::Smooth;
  GridSize repeat{1, 1};  ///< how often the picture fits into the ranges of u and v

  bool is_checker() const { return !picture && !name.empty(); }
  explicit operator bool() const { return picture || !name.empty(); }
};

inline constexpr GridSize kUsualGrid{16, 16};  ///< lines, unless a surface has others

struct SurfaceSpec {
  std::string name = "surface";
  std::string x = "u";  ///< of the usual names; a coordinate that is a parameter has no formula
  std::string y = "v";
  std::string z;
  std::string xyz;    ///< a vector of 3, in place of these; empty: none
  std::string where;  ///< a condition: the part of the surface that is there; empty: all
  ParameterNames parameters = kUsualParameters;  ///< what u and v are called
  Range u;
  Range v;
  /// Lines of constant u and of constant v; 0: none. Default: the usual ones, or fitting_grid().
  std::optional<GridSize> grid = {};
  Material front = kFrontMaterial;
  Material back = kBackMaterial;
  std::string color;  ///< in place of the materials': of u, v, x, y, z, gauss, mean; empty: none
  std::string colormap = "viridis";
  /// From the first to the last colour; default: of what is drawn. An animation has one for all of
  /// its time, which is computed: scene files have none.
  std::optional<ColorRange> color_range = {};
  std::optional<ColorEnds> color_ends = {};  ///< in place of that range
  Texture texture;
  std::vector<ContourSpec> contours;
  bool flip = false;
  std::vector<Definition> definitions;  ///< of its own: they hide the scene's of the same name
  std::vector<Slider> sliders;          ///< for these
  /// In place of the scene's.
  std::optional<Shading> shading = {};
  std::optional<Specular> specular = {};
  std::optional<GridSize> samples = {};
  std::optional<Thickness> thickness = {};
  Number opacity = 1;                     ///< 0 to 1; less than 1: one sees what is behind it
  std::optional<Number> line_width = {};  ///< of grid lines, pixels; default: line_width()
  Color line_color = kLineColor;
  std::string label;            ///< text beside it; empty: none
  bool visible = true;          ///< else it is there for curves and points alone
  std::vector<std::string> in;  ///< the nodes it is drawn in; none: once, in the world
  /// It stands for this curve or point of the scene: see with_strokes() of scene/model/strokes.h.
  std::optional<std::size_t> curve = {}, point = {};

  bool is_stroke() const { return curve || point; }
  GridSize grid_lines() const { return grid.value_or(kUsualGrid); }
};

/// The part that curves and points have in common.
struct StrokeSpec {
  std::string name;
  std::string label;  ///< text beside it; empty: none
  bool visible = true;
  Color color = kStrokeColor;
  /// Pixels: of a line; of a point's dot across. Default: grows with the picture.
  std::optional<Number> width = {};
  std::optional<Number> radius = {};  ///< of a tube or ball, in the scene's units; none: no surface
  std::vector<std::string> in;        ///< nodes; none: those of the surface it is on, or the world
  std::string on;                     ///< the name of the surface it is on; empty: the only one
  std::string u, v;                   ///< where on the surface; empty: it is on none
};

struct CurveSpec : StrokeSpec {
  CurveSpec() { name = "curve"; }
  std::string x, y, z, xyz;  ///< of s, without a surface; empty: 0; xyz: in place of the others
  Range s{"0", "1"};
};

struct PointSpec : StrokeSpec {
  PointSpec() { name = "point"; }
  std::optional<Vector> at = {};  ///< without a surface
};

/// One step of a node's transform.
struct Transform {
  enum class Kind { Translate, Rotate, Scale };
  Kind kind = Kind::Translate;
  Vector vector;     ///< the way, the axis, or the factor of each coordinate
  Number angle = 0;  ///< of a rotation, degrees, counter-clockwise around the axis
};

/// A frame that moves what is in it.
struct SceneNode {
  std::string name;
  std::string in;                    ///< the node around it; empty: the world
  std::vector<Transform> transform;  ///< applied as written, outermost first
};

/// How much of a point light arrives at distance d: 1 / (constant + linear d + quadratic d^2).
struct Attenuation {
  Number constant = 1;
  Number linear = 0;
  Number quadratic = 0;
  std::optional<Number> range;  ///< in place of the three: how far the light reaches
};

/// The cone of a spot light. Angles are between axis and edge, in degrees.
struct Spot {
  enum class Falloff { Linear, Smooth };
  Vector direction{0, 0, -1};         ///< along the light, any length but 0
  Number cutoff = 30;                 ///< 0 to 180: nothing is lit from there on
  std::optional<Number> inner;        ///< up to here all is lit; default: the cutoff, a hard edge
  Number exponent = 0;                ///< of the cosine between axis and ray
  Falloff falloff = Falloff::Linear;  ///< between inner and cutoff
};

/// In eye coordinates the eye at the origin looks down -z, y is up.
struct Light {
  Vector position;  ///< of a point light; toward a directional one, any length but 0
  bool directional = false;
  Color color{1, 1, 1};                ///< of what is reflected diffusely, and else too
  std::optional<Color> specular = {};  ///< of what is mirrored; default: the same
  Color ambient = {};
  std::string frame = "eye";  ///< whose coordinates these are: "eye", "world" or a node's name
  Attenuation attenuation = {};
  std::optional<Spot> spot = {};
  Number enabled = 1;  ///< 0: off
};

/// The three lights of a scene that names none.
std::vector<Light> default_lights();

/// Directions and lengths are those of the picture, the target is a point of the scene: they differ
/// where the picture is stretched along an axis.
struct Camera {
  Vector view{2, -3, 1.5};  ///< from the target toward the eye, any length but 0
  Vector up{0, 0, 1};
  std::optional<Vector> target;    ///< default: what is seen is in the middle
  std::optional<Number> distance;  ///< from the target; default: what is seen just fits
  Number fov = 30;                 ///< vertical, degrees, more than 0 and less than 180
  Number zoom = 1;                 ///< of the picture around its middle, more than 0
  bool ortho = false;              ///< the visible height is the perspective one at the target
  bool turntable = false;          ///< goes once round `up` in the range of time
  /// Radians that the view is turned around `up` at a moment, which resolve() fills in.
  double turn = 0;

  bool operator==(const Camera&) const = default;
};

/// How the picture is stretched along the axes of the world. Meshes, ticks and reports keep the
/// scene's own units.
struct AxisScale {
  /// Equal, but high height fields are compressed: frame_scene() finds the factors.
  bool automatic = true;
  Vector factors{1, 1, 1};  ///< more than 0
};

/// The box that surfaces are cut along.
struct Clip {
  bool automatic = true;      ///< where one goes to infinity: a box that most of it is in
  std::optional<Bounds> box;  ///< this box, whatever the surface does
};

/// A length: in pixels of the picture, or as a share of the bounding box's diagonal.
struct ToleranceValue {
  double value = 0;
  bool pixels = false;
};

/// How surfaces become triangles.
struct MeshSettings {
  std::optional<ToleranceValue> tolerance;  ///< default: of a picture or of a mesh
  double normal_tolerance = 3;              ///< degrees
  /// Default: 4000000; without a tolerance one per pixel, 1000000 at least.
  std::optional<int> max_triangles;
  std::optional<GridSize> samples;          ///< a uniform grid of so many cells instead
  std::optional<Thickness> thickness = {};  ///< makes solids of surfaces
  /// Millimetres of the longest side of an exported mesh; default: the scene's units.
  std::optional<Number> print_size = {};
};

/// Most samples per pixel and side: 256 per pixel are more than eight bits can show.
inline constexpr int kMaxAntialias = 16;

/// How the picture is made.
struct PictureSettings {
  int width = 800;  ///< pixels
  int height = 600;
  int antialias = 2;  ///< samples per pixel and side, 1 (off) to kMaxAntialias
  Shading shading = Shading::Pixel;
  Specular specular = Specular::Phong;
};

/// Time that passes: frame k of n, counted from 0, shows the moment from + (to - from) k / n. The
/// end is that of the last frame, so that what is periodic goes on where it began.
struct Animation {
  Number from = 0;
  Number to = 1;     ///< more than `from`
  Number fps = 30;   ///< frames per second, more than kMinFps, less than kMaxFps
  int frames = 120;  ///< in all

  double moment(int frame) const {
    return from + (to - from) * (static_cast<double>(frame) / frames);
  }
};

/// No display shows more frames per second. A frame of a hundred seconds shows no movement, and no
/// video format has pauses much longer.
inline constexpr double kMinFps = 0.01;
inline constexpr double kMaxFps = 1000;

struct Scene {
  std::string title = "saddle";
  bool show_title = false;  ///< also in a picture without axes; never an empty one
  Theme theme = Theme::Dark;
  std::vector<Definition> definitions;  ///< parameters, shared sub-expressions, helper functions
  std::vector<Slider> sliders;
  std::vector<SurfaceSpec> surfaces;
  std::vector<CurveSpec> curves;
  std::vector<PointSpec> points;
  std::vector<SceneNode> nodes;
  std::vector<Light> lights = default_lights();
  Camera camera;
  AxisScale scale;
  Color background{0, 0, 0, 1};
  Clip clip;
  bool axes = false;  ///< a box with ticks and labels around all of it, and the title
  std::array<std::string, 3> labels = {"x", "y", "z"};  ///< of the axes
  /// That box, stretched as the picture is; computed, as color_range is; default: just around it.
  std::optional<Bounds> box = {};
  MeshSettings mesh;
  PictureSettings picture;
  Number t = 0;  ///< the moment that is drawn; an animation's start unless it is another
  /// Formulas are bound with t as a variable, for code that runs elsewhere; scene files have none.
  bool keeps_time = false;
  std::optional<Animation> animation;
};

/// How a surface is lit and sampled: its own way, else the scene's.
Shading shading_of(const Scene& scene, const SurfaceSpec& spec);
Specular specular_of(const Scene& scene, const SurfaceSpec& spec);
std::optional<GridSize> samples_of(const Scene& scene, const SurfaceSpec& spec);

/// The thickness that a surface has; nothing for one without, and for curves and points.
std::optional<Thickness> thickness_of(const Scene& scene, const SurfaceSpec& spec);

/// A surface is drawn by its u and v: with the normals of its formula, or a texture.
bool draws_parameters(const Scene& scene);

/// The range of time becomes this one, and its start the moment that is drawn.
void set_time_range(Scene& scene, const Number& from, const Number& to);

}  // namespace saddle
