// A scene on the GPU: its meshes are uploaded once, its shader programs compiled once, and it is
// drawn as often as wanted, into whatever framebuffer is bound.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/model/mesh.h"
#include "render/gl/gpu_mesh.h"
#include "render/gl/program.h"
#include "render/gl/viewport.h"
#include "render/overlay/overlay_drawer.h"
#include "render/picture/drawn_parts.h"
#include "render/picture/layers.h"
#include "render/picture/line_drawer.h"
#include "render/picture/placed_mesh.h"
#include "render/picture/stroke_drawer.h"
#include "render/shading/colormap_textures.h"
#include "render/shading/picture_textures.h"
#include "render/shading/shader_lights.h"
#include "render/shading/surface_program.h"
#include "scene/model/camera.h"
#include "scene/model/color_scale.h"
#include "scene/model/scene.h"

namespace saddle {

/// Settings of a picture that are not part of the scene: the viewer's.
struct Look {
  bool lines = true;               ///< the surfaces' grid lines
  bool wireframe = false;          ///< the edges of the triangles in place of the triangles
  bool bare = false;               ///< the surfaces alone: no lines, no curves, nothing written
  Interruption interruption = {};  ///< between see-through layers
};

/// Needs the same current context from the first to the last of its calls.
class Renderer {
 public:
  /// `lights_at_once`: most lights of a pass; 0: as many as the driver has uniforms for.
  explicit Renderer(std::size_t lights_at_once = 0) : lights_at_once_(lights_at_once) {}

  /// Uploads the mesh of scene.surfaces[surface]; a mesh that is there already is replaced.
  /// Surfaces get their first mesh in order.
  void set_mesh(std::size_t surface, const Mesh& mesh);

  /// The same with what scene.picture.shading needs: for exact normals, the surface's formula.
  void set_surface(const Scene& scene, std::size_t surface, const Mesh& mesh);

  /// Takes the meshes from the `count`th on away.
  void keep_meshes(std::size_t count);

  /// Uploads lines that are no part of the scene, in place of the last ones.
  void set_marks(const Mesh& marks) { marks_.emplace(marks); }
  void remove_marks() { marks_.reset(); }

  /// Draws all meshes of a resolved scene where its nodes have them, with the materials of their
  /// surfaces. Throws Error (Machine) for what OpenGL reports, and if there is no memory. False: it
  /// has paused, and the same call, into the same framebuffer, goes on.
  bool draw(const Scene& scene, const FittedCamera& camera, const Viewport& viewport,
            const Look& look = {});

  /// Differences of the pictures so far from what was asked for.
  std::vector<std::string> warnings() const;

  /// The programs that surfaces have been drawn with, in the order of their first use.
  const std::vector<SurfaceProgram>& surface_programs() const { return surface_programs_; }

  /// Whether the back faces of a surface, by its number, were culled in all places of the last
  /// drawing.
  const std::map<std::size_t, bool>& culled() const { return culled_; }

 private:
  /// How a surface's normals are computed in Shading::Exact.
  struct Normals {
    std::optional<ShaderNormal> formula;  // none: they are interpolated
    std::optional<std::string> warning;   // and why
  };
  using Lights = std::span<const ShaderLight>;
  /// Samples across lines on surfaces.
  struct LineWidths {
    int grid = 1;
    int widest = 1;
  };

  std::vector<PlacedMesh> items_of(const Scene& scene, const FittedCamera& camera, double unit,
                                   const Look& look) const;
  Program& program(const ShaderText& text, const std::string& captured = "");
  Layers& layers(const Viewport& viewport);
  bool has_lines() const;
  bool has_contours() const;
  std::size_t lights_at_once();
  void start_faces(const LineWidths& widths, const Look& look) const;
  static void end_faces();
  void draw_depths(std::span<const PlacedMesh> items, Program& program, const LineWidths& widths,
                   const Look& look);
  void note_culled(std::span<const PlacedMesh> items);
  LineWidths line_widths(const Scene& scene, const Viewport& viewport) const;
  void draw_lines(const Scene& scene, std::span<const PlacedMesh> items,
                  const StrokeDrawer::Screen& screen, const Look& look);
  bool draw_see_through(std::span<const PlacedMesh> items, const std::function<void()>& shade,
                        const Viewport& viewport, const LineWidths& widths, const Look& look);
  std::vector<ColorScale> scales_of(const Scene& scene) const;
  void set_color(Program& program, const Scene& scene, std::size_t surface);
  void set_texture(Program& program, const SurfaceSpec& surface);
  void draw_surfaces(const Scene& scene, std::span<const PlacedMesh> items, Lights lights,
                     const LineWidths& widths, const Look& look);
  Program& surface_program(const ShaderNeeds& needs, const std::string& surface);
  ShaderNeeds needs_of(const Scene& scene, const DrawnPart& part, ShaderNeeds needs,
                       bool first) const;
  void draw_pass(const Scene& scene, std::span<const PlacedMesh> items, Lights lights, bool first);

  std::size_t lights_at_once_ = 0;
  std::vector<GpuMesh> meshes_;
  StrokeDrawer stroke_drawer_;
  LineDrawer line_drawer_;
  std::vector<Normals> normals_;  // of each
  std::optional<GpuMesh> marks_;
  /// Compiled programs that are kept, unless the picture at hand takes more: a driver in software
  /// has about a megabyte for each.
  static constexpr std::size_t kMostPrograms = 8;
  void forget_old_programs();
  struct KeptProgram {
    Program program;
    std::size_t used = 0;  ///< in the last picture that it was wanted for
  };

  std::map<std::string, KeptProgram> programs_;  // for surfaces, by their text
  std::size_t pictures_drawn_ = 0;
  std::vector<SurfaceProgram> surface_programs_;
  std::map<std::size_t, bool> culled_;
  ColormapTextures colormaps_;
  PictureTextures pictures_;
  std::vector<ColorScale> scales_;  // of the scene that is being drawn
  std::optional<Layers> layers_;
  std::size_t layers_drawn_ = 0;  ///< where others were left out behind them; else 0
  std::string unknown_letters_;
  std::optional<OverlayDrawer> overlay_;
};

}  // namespace saddle
