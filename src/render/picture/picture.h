// A scene and its meshes become a picture.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"
#include "mesh/model/mesh.h"
#include "render/gl/context.h"
#include "render/shading/surface_program.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

/// Milliseconds of each stage.
struct RenderTimes {
  double context = 0;  ///< library, context, GL functions and warming up
  double upload = 0;   ///< meshes to the GPU
  double draw = 0;     ///< compiling shaders, drawing, reading back, averaging
};

/// Pictures of a scene: its meshes and programs stay on the GPU from one picture to the next. All
/// calls from the thread that made it, or that entered it after that one had left it.
class PictureMaker {
 public:
  /// Throws Error (Machine) if there is no OpenGL.
  explicit PictureMaker(Backend backend = Backend::Any);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// Makes ready what pictures with grid lines need, whatever they are of.
  void warm_up();
  void leave();
  void enter();

  /// Uploads the mesh of scene.surfaces[surface], in place of the one that is there, with what the
  /// scene's shading needs.
  void set_surface(const Scene& scene, std::size_t surface, const Mesh& mesh);

  /// Draws the meshes as they are uploaded: `meshes[i]` is that of `scene.surfaces[i]`. Throws
  /// Error as render() does.
  Image draw(const Scene& scene, std::span<const Mesh> meshes, const PictureSettings& options);
  /// The same, at most `tile_samples` samples a side at once; for tests.
  Image draw_in_tiles(const Scene& scene, std::span<const Mesh> meshes,
                      const PictureSettings& options, int tile_samples);

  /// The sum over all calls so far.
  const RenderTimes& times() const { return times_; }
  std::string renderer() const;  ///< "osmesa" ...
  /// The programs that the surfaces were drawn with.
  const std::vector<SurfaceProgram>& surface_programs() const;
  /// Whether the last picture left out the back faces of a surface, by its number.
  const std::map<std::size_t, bool>& culled() const;
  /// Differences of the pictures from what was asked for.
  std::vector<std::string> warnings() const;

 private:
  struct Gpu;

  RenderTimes times_;
  std::unique_ptr<Gpu> gpu_;
};

struct Rendering {
  Image image;
  RenderTimes times;
  std::string renderer;               ///< "osmesa" ...
  std::string shaders;                ///< the programs of the surfaces, as text
  std::vector<std::string> warnings;  ///< in which ways it is not what was asked for
};

/// Draws `meshes[i]` with the materials of `scene.surfaces[i]`. Throws Error: Machine if there is
/// no OpenGL, or the picture is larger than it can draw; Input for a camera that cannot be.
Rendering render(const Scene& scene, std::span<const Mesh> meshes, const PictureSettings& options,
                 Backend backend = Backend::Any);
/// The same, at most `tile_samples` samples a side at once; for tests.
Rendering render_in_tiles(const Scene& scene, std::span<const Mesh> meshes,
                          const PictureSettings& options, int tile_samples,
                          Backend backend = Backend::Any);

/// The surfaces alone, seen by this camera: no lines, no curves, nothing written.
Image render_surfaces(const Scene& scene, std::span<const Mesh> meshes, const FittedCamera& camera,
                      const PictureSettings& options, Backend backend);

/// A maker that has warmed up, entered by no thread. For a thread beside tessellation, which takes
/// about as long.
std::unique_ptr<PictureMaker> start_picture_maker(Backend backend);

}  // namespace saddle
