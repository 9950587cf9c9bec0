// The meshes of a scene at one moment after another: what t does not move is meshed once.
#pragma once

#include <exception>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/report/report.h"
#include "base/error.h"
#include "meshing/tessellate.h"

namespace saddle {

class SceneMeshes {
 public:
  /// `threads` 0: all.
  SceneMeshes(Purpose purpose, unsigned threads)
      : purpose_(std::move(purpose)), threads_(threads) {}

  /// Meshes what is not there yet, and what is another surface at the scene's moment. Returns the
  /// numbers of those surfaces. A frame of an animation (`frame`: its number and moment, in words)
  /// may have surfaces of which there is nothing to draw. Throws Error as tessellate() does.
  std::vector<std::size_t> update(const Scene& scene, const std::string& frame = {});

  std::span<const Mesh> meshes() const { return meshes_; }
  /// There is something to warn of.
  bool warn() const;

  /// Adds the surfaces' results to the report. Throws Error (Nothing) if none of the surfaces ever
  /// had anything to draw.
  void report(RunReport& report) const;

 private:
  struct Known {
    SurfaceReport report;
    bool moves = false;
    std::optional<Thickness> thickness = {};
    bool drawn = false;                 ///< there was something to draw
    std::vector<std::string> warnings;  ///< those of the first frame that had any
    std::string first;                  ///< that frame
    int frames = 0;                     ///< that had any
  };

  /// A surface's mesh, or why it has none.
  struct Made {
    std::optional<Tessellation> mesh;
    std::exception_ptr failure;
  };

  std::vector<std::size_t> surfaces_to_mesh(const Scene& scene) const;
  /// Keeps a surface's mesh, or that it has none in this frame.
  void take(const Scene& scene, std::size_t surface, const std::string& frame, Made made);

  Purpose purpose_;
  unsigned threads_;
  std::vector<Mesh> meshes_;
  std::vector<Known> known_;
  RunTimes times_;
  std::optional<Error> nothing_;  ///< the first reason why there was nothing to draw
};

}  // namespace saddle
