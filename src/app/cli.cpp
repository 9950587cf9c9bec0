// The command line, read with CLI11 (a slow header: no other file includes it). Options are taken
// as text and read by scene/values.h, so that every error names its place. Those that are keys of
// the scene file become edits of the scene.
#include "app/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/nearest.h"
#include "scene/color.h"
#include "scene/colormap.h"
#include "scene/prepare.h"
#include "scene/values.h"

namespace saddle {
namespace {

constexpr int kMaxThreads = 1024;

using Text = const std::string&;

/// A text that must not be empty: a shell variable that is not set should not go unnoticed.
CLI::Option* add_text_option(CLI::App& app, const std::string& name, std::string& text) {
  return app.add_option_function<std::string>(name, [name, &text](Text value) {
    if (value.empty()) throw Error(Status::Input, "the value is empty", {name, "", {}});
    text = value;
  });
}

/// An option that changes the scene: `read` makes a value of its text, which `edit` puts there.
template <typename Read, typename Edit>
void add_edit(CLI::App& app, CommandLine& line, const std::string& names, Read read, Edit edit) {
  const std::string name = names.substr(names.find("--"));
  app.add_option_function<std::string>(names, [&line, name, read, edit](Text text) {
    line.edits.push_back([value = read(name, text), edit](Scene& scene) { edit(scene, value); });
  });
}

void add_output_options(CLI::App& app, CommandLine& line) {
  app.add_option("-o,--output", line.outputs)->allow_extra_args(false);
  add_text_option(app, "--format", line.format);
  CLI::Option* const reference = add_text_option(app, "--reference", line.reference);
  app.add_option_function<std::string>(
         "--threshold", [&line](Text text) { line.threshold = parse_share("--threshold", text); })
      ->needs(reference);
  add_text_option(app, "--report", line.report);
  app.add_flag("--strict", line.strict);
}

void add_picture_options(CLI::App& app, CommandLine& line) {
  add_edit(
      app, line, "-s,--size",
      [](Text name, Text text) { return parse_pair(name, text, 1, kMaxPixels); },
      [](Scene& scene, GridSize size) {
        scene.picture.width = size.u;
        scene.picture.height = size.v;
      });
  add_edit(
      app, line, "--antialias",
      [](Text name, Text text) { return parse_whole(name, text, 1, kMaxAntialias); },
      [](Scene& scene, int samples) { scene.picture.antialias = samples; });
  add_edit(app, line, "--shading", parse_shading,
           [](Scene& scene, Shading shading) { scene.picture.shading = shading; });
  add_edit(app, line, "--specular", parse_specular,
           [](Scene& scene, Specular specular) { scene.picture.specular = specular; });
  app.add_flag_callback("--axes",
                        [&line] { line.edits.push_back([](Scene& s) { s.axes = true; }); });
  add_edit(app, line, "--background", parse_color,
           [](Scene& scene, const Color& color) { scene.background = color; });
}

void add_camera_options(CLI::App& app, CommandLine& line) {
  const auto positive = [](Text name, Text text) {
    return parse_number_between(name, text, 0, std::numeric_limits<double>::infinity());
  };
  const auto angle = [](Text name, Text text) { return parse_number_between(name, text, 0, 180); };
  add_edit(app, line, "--view", parse_direction,
           [](Scene& scene, const dvec3& view) { scene.camera.view = view; });
  add_edit(app, line, "--up", parse_direction,
           [](Scene& scene, const dvec3& up) { scene.camera.up = up; });
  add_edit(app, line, "--target", parse_vector,
           [](Scene& scene, const dvec3& target) { scene.camera.target = target; });
  add_edit(app, line, "--distance", positive,
           [](Scene& scene, double distance) { scene.camera.distance = distance; });
  add_edit(app, line, "--fov", angle, [](Scene& scene, double fov) { scene.camera.fov = fov; });
  app.add_flag_callback("--ortho",
                        [&line] { line.edits.push_back([](Scene& s) { s.camera.ortho = true; }); });
}

/// Calls `edit` with each surface.
template <typename Edit>
auto each_surface(Edit edit) {
  return [edit](Scene& scene, const auto& value) {
    for (SurfaceSpec& spec : scene.surfaces) edit(spec, value);
  };
}

void add_surface_options(CLI::App& app, CommandLine& line) {
  add_edit(app, line, "--front", opaque_color,
           each_surface([](SurfaceSpec& spec, const Color& c) { spec.front.diffuse = c; }));
  add_edit(app, line, "--back", opaque_color,
           each_surface([](SurfaceSpec& spec, const Color& c) { spec.back.diffuse = c; }));
  add_edit(app, line, "--opacity", parse_share,
           each_surface([](SurfaceSpec& spec, double opacity) { spec.opacity = opacity; }));
  add_edit(
      app, line, "--color",
      [](Text name, Text text) {
        if (text.empty()) throw Error(Status::Input, "the value is empty", {name, "", {}});
        return text == "off" ? std::string() : text;
      },
      each_surface([](SurfaceSpec& spec, Text formula) { spec.color = formula; }));
  add_edit(app, line, "--colormap", parse_colormap, [](Scene& scene, Text name) {
    if (std::ranges::all_of(scene.surfaces, &std::string::empty, &SurfaceSpec::color)) {
      throw Error(Status::Input, "there is nothing to colour", {"--colormap", name, {}},
                  "--color z colours by height, --color gauss by curvature");
    }
    for (SurfaceSpec& spec : scene.surfaces) spec.colormap = name;
  });
  add_edit(app, line, "--grid", parse_grid_lines,
           each_surface([](SurfaceSpec& spec, GridSize lines) {
             spec.grid_u = lines.u;
             spec.grid_v = lines.v;
           }));
  app.add_flag_callback("--flip", [&line] {
    line.edits.push_back([](Scene& scene) {
      for (SurfaceSpec& spec : scene.surfaces) spec.flip = !spec.flip;
    });
  });
}

void add_mesh_options(CLI::App& app, CommandLine& line) {
  const auto triangles = [](Text name, Text text) {
    return parse_whole(name, text, 2, kMaxTriangles);
  };
  add_edit(app, line, "--tolerance", parse_tolerance,
           [](Scene& scene, ToleranceValue t) { scene.mesh.tolerance = t; });
  add_edit(app, line, "--normal-tolerance", parse_degrees,
           [](Scene& scene, double degrees) { scene.mesh.normal_tolerance = degrees; });
  add_edit(app, line, "--max-triangles", triangles,
           [](Scene& scene, int count) { scene.mesh.max_triangles = count; });
  add_edit(app, line, "--clip", parse_clip,
           [](Scene& scene, const Clip& clip) { scene.clip = clip; });
  add_edit(app, line, "--samples", parse_samples,
           [](Scene& scene, GridSize cells) { scene.mesh.samples = cells; });
}

void add_time_options(CLI::App& app, CommandLine& line) {
  add_edit(
      app, line, "--t",
      [&line](Text, Text text) {
        line.has_moment = true;
        return text;
      },
      [](Scene& scene, Text text) { scene.t = finite_constant(scene, "--t", text); });
  const auto animation = [](Scene& scene) -> Animation& {
    return scene.animation ? *scene.animation : scene.animation.emplace();
  };
  add_edit(
      app, line, "--frames",
      [&line](Text name, Text text) {
        line.frame_option = name;
        return parse_whole(name, text, 1, kMaxFrames);
      },
      [animation](Scene& scene, int frames) { animation(scene).frames = frames; });
  add_edit(
      app, line, "--fps",
      [&line](Text name, Text text) {
        line.frame_option = name;
        return parse_number_between(name, text, kMinFps, kMaxFps);
      },
      [animation](Scene& scene, double fps) { animation(scene).fps = fps; });
  app.add_option_function<std::string>("--frame-range", [&line](Text text) {
    line.frame_option = "--frame-range";
    line.frame_range = parse_frame_range("--frame-range", text);
  });
}

Backend parse_backend(const std::string& option, Text text) {
  if (text == "osmesa") return Backend::Osmesa;
  if (text == "egl") return Backend::Egl;
  throw Error(Status::Input, "no renderer is called '" + text + "'",
              {option, text, {0, text.size()}}, "known: osmesa egl");
}

void add_computing_options(CLI::App& app, CommandLine& line) {
  app.add_option_function<std::string>(
      "--renderer", [&line](Text text) { line.renderer = parse_backend("--renderer", text); });
  app.add_option_function<std::string>("--threads", [&line](Text text) {
    line.threads = static_cast<unsigned>(parse_whole("--threads", text, 1, kMaxThreads));
  });
  app.add_flag("--watch", line.watch);
  CLI::Option* const quiet = app.add_flag("-q,--quiet", line.quiet);
  app.add_flag("-v,--verbose", line.verbose)->excludes(quiet);
}

/// "--output" and so on.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// What CLI11 left over: arguments that are no options. Throws Error for those that look like one.
std::vector<std::string> plain_arguments(const CLI::App& app) {
  std::vector<std::string> arguments;
  bool after_marker = false;  // what follows `--` is no option
  for (const std::string& argument : app.remaining()) {
    if (argument == "--" && !after_marker) {
      after_marker = true;
      continue;
    }
    if (after_marker || argument.size() < 2 || argument[0] != '-') {
      arguments.push_back(argument);
      continue;
    }
    const std::string name = argument.substr(0, argument.find('='));
    std::string hint = "saddle --help lists the options";
    if (const auto nearest = nearest_name(name, option_names(app))) {
      hint = "did you mean '" + *nearest + "'? " + hint;
    }
    throw Error(Status::Input, "unknown option '" + name + "'", {}, hint);
  }
  return arguments;
}

/// A verb takes no options that would do nothing.
void check_options(const CLI::App& app, const std::string& verb) {
  // What a chart compares, and the look of its exact image, are not for options to choose.
  const std::vector<std::string> of_graph_alone = {
      "--reference",  "--threshold",   "--report",   "--strict",   "--grid",
      "--samples",    "--tolerance",   "--front",    "--back",     "--verbose",
      "--background", "--shading",     "--specular", "--opacity",  "--frames",
      "--fps",        "--frame-range", "--color",    "--colormap", "--axes",
  };
  for (const CLI::Option* option : app.get_options()) {
    const auto names_option = [&](const std::string& name) { return option->check_name(name); };
    if (option->count() == 0) continue;
    if (verb == "chart" && std::ranges::none_of(of_graph_alone, names_option)) continue;
    if (verb == "list" && names_option("--verbose")) continue;
    throw Error(Status::Input, "saddle " + verb + " takes no option " + option->get_name());
  }
}

/// `check` writes no pictures and no meshes.
void check_no_outputs(const CommandLine& line) {
  if (!line.outputs.empty() || !line.format.empty() || !line.reference.empty()) {
    throw Error(Status::Input, "saddle check writes no pictures and no meshes", {},
                "its report goes to a file with --report FILE");
  }
  if (line.frame_option.empty()) return;
  throw Error(Status::Input, "saddle check takes no option " + line.frame_option, {},
              "--t is the moment that it looks at");
}

void take_verb(const CLI::App& app, const std::string& first, CommandLine& line) {
  using Command = CommandLine::Command;
  static const std::map<std::string, Command> kVerbs = {{"check", Command::Check},
                                                        {"chart", Command::Chart},
                                                        {"list", Command::List},
                                                        {"show", Command::Show}};
  const auto verb = kVerbs.find(first);
  if (verb == kVerbs.end()) return;
  if (verb->second == Command::Check) {
    check_no_outputs(line);
  } else {
    check_options(app, first);
  }
  line.command = verb->second;
  line.arguments.erase(line.arguments.begin());
}

void parse_with_cli11(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ArgumentMismatch& error) {
    // The only mismatch that our options can have: CLI11 says "--size: 1 required TEXT missing".
    const std::string what = error.what();
    throw Error(Status::Input, "the value is missing", {what.substr(0, what.find(':')), "", {}},
                "saddle --help lists the options");
  } catch (const CLI::ParseError& error) {
    throw Error(Status::Input, error.what(), {}, "saddle --help lists the options");
  }
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  bool help = false;
  bool version = false;
  CLI::App app;
  app.set_help_flag();  // ours is a text of its own
  app.allow_extras();
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  add_output_options(app, line);
  add_camera_options(app, line);
  add_picture_options(app, line);
  add_surface_options(app, line);
  add_mesh_options(app, line);
  add_time_options(app, line);
  add_computing_options(app, line);
  app.add_flag("-h,--help", help);
  app.add_flag("--version", version);
  parse_with_cli11(app, argc, argv);
  line.arguments = plain_arguments(app);
  if (help) {
    const auto asks = [&](const char* page) {
      return line.arguments == std::vector<std::string>{page};
    };
    line.command = asks("functions") ? CommandLine::Command::Functions
                   : asks("keys")    ? CommandLine::Command::Keys
                                     : CommandLine::Command::Help;
  } else if (version) {
    line.command = CommandLine::Command::Version;
  } else if (argc > 1) {
    take_verb(app, argv[1], line);
  }
  return line;
}

}  // namespace saddle
