#include "scene/command_text.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "scene/color.h"
#include "scene/scene_file.h"
#include "scene/values.h"

namespace saddle {
namespace {

/// In single quotes, unless no shell makes anything of its characters.
std::string quoted(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-+=:.,/%@").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// The part of a scene that a command line can say.
Scene sayable(const Scene& scene) {
  Scene result;
  const SurfaceSpec& spec = scene.surfaces[0];
  SurfaceSpec plain;
  plain.name = spec.name;
  plain.x = spec.x;
  plain.y = spec.y;
  plain.z = spec.z;
  plain.u = spec.u;
  plain.v = spec.v;
  plain.grid_u = spec.grid_u;
  plain.grid_v = spec.grid_v;
  plain.color = spec.color;
  plain.colormap = spec.colormap;
  plain.flip = spec.flip;
  plain.opacity = double(spec.opacity);
  plain.front.diffuse = spec.front.diffuse;
  plain.back.diffuse = spec.back.diffuse;
  result.surfaces = {plain};
  result.definitions = scene.definitions;
  result.camera = scene.camera;
  result.background = scene.background;
  result.axes = scene.axes;
  result.mesh = scene.mesh;
  result.picture = scene.picture;
  result.clip = scene.clip;
  result.t = scene.t;
  result.animation = scene.animation;
  // These change nothing about the picture.
  result.title = scene.title;
  result.sliders = scene.sliders;
  return result;
}

class Command {
 public:
  void argument(const std::string& text) { text_ += " " + quoted(text); }
  void assignment(const std::string& name, const std::string& value) {
    argument(name + "=" + value);
  }
  void option(const std::string& name, const std::string& value) {
    text_ += " --" + name + " " + quoted(value);
  }
  void flag(const std::string& name) { text_ += " --" + name; }
  const std::string& text() const { return text_; }

 private:
  std::string text_ = "saddle";
};

std::string vector(const dvec3& v) {
  return format_number(v.x) + "," + format_number(v.y) + "," + format_number(v.z);
}

std::string range(double low, double high) {
  return format_number(low) + ":" + format_number(high);
}

std::string pair(int a, int b) {
  return std::to_string(a) + "x" + std::to_string(b);
}

void add_camera(Command& command, const Camera& camera) {
  const Camera usual;
  if (dvec3(camera.view) != dvec3(usual.view)) command.option("view", vector(camera.view));
  if (dvec3(camera.up) != dvec3(usual.up)) command.option("up", vector(camera.up));
  if (camera.target) command.option("target", vector(*camera.target));
  if (camera.distance) command.option("distance", format_number(*camera.distance));
  if (double(camera.fov) != double(usual.fov)) command.option("fov", format_number(camera.fov));
  if (camera.ortho) command.flag("ortho");
}

void add_look(Command& command, const Scene& scene) {
  const SurfaceSpec& spec = scene.surfaces[0];
  const auto color = [&](const std::string& name, const Color& is, const Color& usual) {
    const std::string text = format_color(is);
    if (text != format_color(usual)) command.option(name, text);
  };
  color("background", scene.background, Scene{}.background);
  color("front", spec.front.diffuse, kFrontMaterial.diffuse);
  color("back", spec.back.diffuse, kBackMaterial.diffuse);
  if (scene.axes) command.flag("axes");
  if (!spec.color.empty()) command.option("color", spec.color);
  if (!spec.color.empty() && spec.colormap != SurfaceSpec{}.colormap) {
    command.option("colormap", spec.colormap);
  }
  if (spec.flip) command.flag("flip");
  if (double(spec.opacity) != 1) command.option("opacity", format_number(spec.opacity));
  const bool off = spec.grid_u == 0 && spec.grid_v == 0;
  if (off || spec.grid_u != SurfaceSpec{}.grid_u || spec.grid_v != SurfaceSpec{}.grid_v) {
    command.option("grid", off ? "off" : pair(spec.grid_u, spec.grid_v));
  }
}

std::string text_of(const Number& number) {
  return number.text.empty() ? format_number(number) : number.text;
}

void add_time(Command& command, const Scene& scene) {
  Number start;
  if (scene.animation) {
    const Animation& a = *scene.animation;
    command.assignment("t", text_of(a.from) + ":" + text_of(a.to));
    if (a.frames != Animation{}.frames) command.option("frames", std::to_string(a.frames));
    if (double(a.fps) != double(Animation{}.fps)) command.option("fps", text_of(a.fps));
    start = a.from;
  }
  if (double(scene.t) != double(start)) command.option("t", format_number(scene.t));
}

void add_settings(Command& command, const Scene& scene) {
  const auto& [width, height, antialias, shading, specular] = scene.picture;
  const PictureSettings usual;
  if (width != usual.width || height != usual.height) command.option("size", pair(width, height));
  if (antialias != usual.antialias) command.option("antialias", std::to_string(antialias));
  if (shading == Shading::Vertex) command.option("shading", "vertex");
  if (shading == Shading::Exact) command.option("shading", "exact");
  if (specular == Specular::Blinn) command.option("specular", "blinn");
  const MeshSettings& mesh = scene.mesh;
  if (mesh.tolerance) {
    command.option("tolerance",
                   format_number(mesh.tolerance->value) + (mesh.tolerance->pixels ? "px" : ""));
  }
  if (mesh.normal_tolerance != MeshSettings{}.normal_tolerance) {
    command.option("normal-tolerance", format_number(mesh.normal_tolerance));
  }
  if (mesh.max_triangles) {
    command.option("max-triangles", std::to_string(*mesh.max_triangles));
  }
  if (mesh.samples) command.option("samples", pair(mesh.samples->u, mesh.samples->v));
  if (scene.clip.box) {
    const Bounds& box = *scene.clip.box;
    command.option("clip", range(box.low.x, box.high.x) + "," + range(box.low.y, box.high.y) + "," +
                               range(box.low.z, box.high.z));
  } else if (!scene.clip.automatic) {
    command.option("clip", "off");
  }
}

}  // namespace

std::optional<std::string> command_text(const Scene& scene) {
  if (scene.surfaces.size() != 1) return std::nullopt;
  const Scene plain = sayable(scene);
  if (write_scene(plain) != write_scene(scene)) return std::nullopt;
  const SurfaceSpec& spec = plain.surfaces[0];
  Command command;
  if (spec.x != SurfaceSpec{}.x) command.assignment("x", spec.x);
  if (spec.y != SurfaceSpec{}.y) command.assignment("y", spec.y);
  command.assignment("z", spec.z);
  for (const auto& [name, ends] : {std::pair{"u", spec.u}, std::pair{"v", spec.v}}) {
    if (ends.min != Range{}.min || ends.max != Range{}.max) {
      command.assignment(name, ends.min + ":" + ends.max);
    }
  }
  for (const Definition& d : plain.definitions) command.assignment(display_name(d), d.text);
  add_time(command, plain);
  add_camera(command, plain.camera);
  add_look(command, plain);
  add_settings(command, plain);
  return command.text();
}

}  // namespace saddle
