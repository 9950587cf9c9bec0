// Frames of the renderer: of a scene with one directional light, beside a program written by hand
// for just that (the same mesh, matrices, framebuffer and picture), and of 200 nodes. Of the pairs,
// ./dev bench --benchmark_filter=one_light --benchmark_enable_random_interleaving=true
// --benchmark_repetitions=9 has medians of processor time that other work does not shift.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench_surfaces.h"
#include "mesh/mesher/grid_mesh.h"
#include "render/gl/context.h"
#include "render/gl/target.h"
#include "render/picture/picture_in_tiles.h"

namespace saddle {
namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 600;

/// What the scene asks of the program.
enum class Look { Dull, Shiny };

// --- by hand ------------------------------------------------------------------------------------

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 corner_normal;
uniform mat4 to_clip;
uniform mat4 to_eye;
out vec3 at;
out vec3 normal;
void main() {
  gl_Position = to_clip * vec4(position, 1.0);
  at = (to_eye * vec4(position, 1.0)).xyz;
  normal = mat3(to_eye) * corner_normal;
}
)";

constexpr const char* kDull = R"(#version 330 core
in vec3 at;
in vec3 normal;
uniform vec3 light;
uniform vec3 light_color;
uniform vec3 front;
uniform vec3 back;
out vec4 pixel;
void main() {
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  pixel = vec4(max(0.0, dot(n, light)) * light_color * (gl_FrontFacing ? front : back), 1.0);
}
)";

constexpr const char* kShiny = R"(#version 330 core
in vec3 at;
in vec3 normal;
uniform vec3 light;
uniform vec3 light_color;
uniform vec3 front;
uniform vec3 back;
uniform vec3 front_specular;
uniform vec3 back_specular;
uniform float shininess;
out vec4 pixel;
void main() {
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  float diffuse = max(0.0, dot(n, light));
  float specular = 0.0;
  if (diffuse > 0.0) {
    specular = pow(max(0.0, dot(reflect(-light, n), normalize(-at))), shininess);
  }
  pixel = vec4(light_color * (diffuse * (gl_FrontFacing ? front : back) +
                   specular * (gl_FrontFacing ? front_specular : back_specular)), 1.0);
}
)";

dvec3 rgb(const Color& color) {
  return {color.r, color.g, color.b};
}

/// The program with all that does not change from frame to frame.
Program program_by_hand(const Scene& scene, const FittedCamera& camera, const ModelFrame& model,
                        Look look) {
  Program program(kVertex, look == Look::Dull ? kDull : kShiny);
  const dvec3 seen = glm::dmat3(camera.world_to_eye) * (model.centre - camera.target) -
                     dvec3(0, 0, camera.distance);
  glm::dmat4 to_eye(glm::dmat3(camera.world_to_eye) * model.size);
  to_eye[3] = {seen, 1};
  const SurfaceSpec& surface = scene.surfaces.front();
  program.use();
  program.set("to_eye", to_eye);
  program.set("to_clip", camera.eye_to_clip * to_eye);
  program.set("light", glm::normalize(dvec3(scene.lights.front().position)));
  program.set("light_color", rgb(scene.lights.front().color));
  program.set("front", rgb(surface.front.diffuse));
  program.set("back", rgb(surface.back.diffuse));
  if (look == Look::Shiny) {
    program.set("front_specular", rgb(surface.front.specular));
    program.set("back_specular", rgb(surface.back.specular));
    program.set("shininess", surface.front.shininess);
  }
  return program;
}

void draw_by_hand(const Program& program, const GpuMesh& mesh) {
  glViewport(0, 0, kWidth, kHeight);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  program.use();
  mesh.draw_triangles();
}

// --- the scene ----------------------------------------------------------------------------------

Scene scene_with_one_light(Look look) {
  Scene scene;
  scene.surfaces.resize(1);
  SurfaceSpec& surface = scene.surfaces.front();
  if (look == Look::Dull) surface.front.specular = surface.back.specular = {};
  scene.lights = {{.position = {1, 2, 3}, .directional = true, .color = {1, 1, 1}}};
  return scene;
}

/// A plane sheet with waves, so that both sides are seen and nothing is culled.
Mesh waves(std::size_t cells) {
  const Surface surface = compile_surface({"waves", "u", "v", "sin(3*u)*cos(3*v)", {-2, 2, -2, 2}});
  GridOptions grid;
  grid.cells_u = grid.cells_v = cells;
  grid.lines_u = grid.lines_v = 0;
  return mesh_on_grid(surface, grid).mesh;
}

// --- side by side -------------------------------------------------------------------------------

/// Everything that both need.
struct Setup {
  std::unique_ptr<Context> context = make_osmesa_context();
  Target target{kWidth, kHeight};
  Scene scene;
  Mesh mesh;
  FittedCamera camera;
  Renderer renderer;
  GpuMesh plain;
  Program program;

  Setup(Look look, std::size_t cells)
      : scene(scene_with_one_light(look)),
        mesh(waves(cells)),
        camera(fit_to_meshes(scene, std::span(&mesh, 1), dvec2(kWidth, kHeight))),
        plain(mesh),
        program(program_by_hand(scene, camera, plain.frame(), look)) {
    renderer.set_mesh(0, mesh);
  }

  void draw_scene() {
    renderer.draw(scene, camera, {kWidth, kHeight, {0, 0, kWidth, kHeight}, 0, 1});
  }

  Image picture() const {
    Image image(kWidth, kHeight);
    target.read(0, 0, 1, true, {0, 0, kWidth, kHeight}, image);
    return image;
  }

  /// Largest difference of the two pictures, in levels; but for normals that lean away from the
  /// eye, of which the program by hand knows nothing.
  int difference() {
    draw_scene();
    const Image one = picture();
    draw_by_hand(program, plain);
    const Image other = picture();
    std::vector<int> levels;
    for (std::size_t i = 0; i < one.rgba.size(); ++i) {
      levels.push_back(std::abs(one.rgba[i] - other.rgba[i]));
    }
    constexpr double kMost = 0.999;
    const auto at = levels.begin() + static_cast<std::ptrdiff_t>(kMost * levels.size());
    std::ranges::nth_element(levels, at);
    return *at;
  }
};

template <typename Draw>
void frames(benchmark::State& state, Setup& setup, const Draw& draw) {
  if (setup.difference() > 1) state.SkipWithError("the pictures differ");
  for (auto _ : state) {
    draw();
    glFinish();
  }
  state.counters["triangles"] = static_cast<double>(setup.mesh.triangles.size());
}

void by_hand(benchmark::State& state, Look look, std::size_t cells) {
  Setup setup(look, cells);
  frames(state, setup, [&] { draw_by_hand(setup.program, setup.plain); });
}

void by_saddle(benchmark::State& state, Look look, std::size_t cells) {
  Setup setup(look, cells);
  frames(state, setup, [&] { setup.draw_scene(); });
}

// --- nodes --------------------------------------------------------------------------------------

constexpr int kNodes = 200;

/// Spheres in a row: one that is in 200 nodes, or 200 that are in one each.
void spheres(benchmark::State& state, bool share) {
  const auto context = make_osmesa_context();
  const Target target(kWidth, kHeight);
  const Surface surface = compile_surface(
      {"sphere", "cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)", {0, 2 * kPi, -kPi / 2, kPi / 2}});
  GridOptions grid;
  grid.cells_u = grid.cells_v = 24;
  const Mesh mesh = mesh_on_grid(surface, grid).mesh;
  Scene scene;
  scene.surfaces.resize(share ? 1 : kNodes);
  for (int i = 0; i < kNodes; ++i) {
    const std::string name = std::to_string(i);
    const Vector way(3.0 * (i % 20), 3.0 * (i / 20), 0);  // NOLINT: rows of whole spheres
    scene.nodes.push_back({name, "", {{Transform::Kind::Translate, way, 0}}});
    scene.surfaces[share ? 0 : static_cast<std::size_t>(i)].in.push_back(name);
  }
  Renderer renderer;
  const std::vector<Mesh> meshes(scene.surfaces.size(), mesh);
  for (std::size_t i = 0; i < meshes.size(); ++i) renderer.set_mesh(i, meshes[i]);
  const FittedCamera camera = fit_to_meshes(scene, meshes, dvec2(kWidth, kHeight));
  for (auto _ : state) {
    renderer.draw(scene, camera, {kWidth, kHeight, {0, 0, kWidth, kHeight}, 0, 1});
    glFinish();
  }
  state.counters["meshes"] = static_cast<double>(meshes.size());
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::size_t cells : {50, 300}) {
    for (const Look look : {Look::Dull, Look::Shiny}) {
      const std::string name = std::string("one_light/") + (look == Look::Dull ? "dull" : "shiny") +
                               " " + std::to_string(2 * cells * cells) + " triangles/";
      const auto add = [&](const char* what, auto function) {
        benchmark::RegisterBenchmark((name + what).c_str(), function, look, cells)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime();
      };
      add("by hand", by_hand);
      add("saddle", by_saddle);
    }
  }
  for (const bool share : {true, false}) {
    const char* const name = share ? "nodes/200 of one mesh" : "nodes/200 meshes";
    benchmark::RegisterBenchmark(name, spheres, share)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
  }
  return true;
}();

}  // namespace
}  // namespace saddle
