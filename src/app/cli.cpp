// The command line, read with CLI11 (a slow header: no other file includes it). Options are taken
// as text and read by app/values.h, so that every error names its place.
#include "app/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>

#include "app/values.h"
#include "base/error.h"
#include "base/nearest.h"
#include "scene/color.h"

namespace saddle {
namespace {

constexpr int kMaxPixels = 16384;  // each way: what OpenGL implementations can draw
constexpr int kMaxAntialias = 16;  // 256 samples per pixel: more than eight bits can show
constexpr int kMaxThreads = 1024;
constexpr int kMaxTriangles = 1'000'000'000;  // three corners each are numbered in 32 bits

using Text = const std::string&;

/// A text that must not be empty: a shell variable that is not set should not go unnoticed.
CLI::Option* add_text_option(CLI::App& app, const std::string& name, std::string& text) {
  return app.add_option_function<std::string>(name, [name, &text](Text value) {
    if (value.empty()) throw Error(Status::Input, "the value is empty", {name, "", {}});
    text = value;
  });
}

void add_output_options(CLI::App& app, CommandLine& line) {
  app.add_option("-o,--output", line.outputs)->allow_extra_args(false);
  add_text_option(app, "--format", line.format);
  app.add_option_function<std::string>("-s,--size", [&line](Text text) {
    const GridSize size = parse_pair("--size", text, 1, kMaxPixels);
    line.width = size.u;
    line.height = size.v;
  });
  CLI::Option* const reference = add_text_option(app, "--reference", line.reference);
  app.add_option_function<std::string>(
         "--threshold", [&line](Text text) { line.threshold = parse_share("--threshold", text); })
      ->needs(reference);
  add_text_option(app, "--report", line.report);
}

void add_camera_options(CLI::App& app, CommandLine& line) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  app.add_option_function<std::string>(
      "--view", [&line](Text text) { line.view = parse_direction("--view", text); });
  app.add_option_function<std::string>(
      "--up", [&line](Text text) { line.up = parse_direction("--up", text); });
  app.add_option_function<std::string>(
      "--target", [&line](Text text) { line.target = parse_vector("--target", text); });
  app.add_option_function<std::string>("--distance", [&line](Text text) {
    line.distance = parse_number_between("--distance", text, 0, kUnlimited);
  });
  app.add_option_function<std::string>(
      "--fov", [&line](Text text) { line.fov = parse_number_between("--fov", text, 0, 180); });
  app.add_flag("--ortho", line.ortho);
}

void add_look_options(CLI::App& app, CommandLine& line) {
  app.add_option_function<std::string>(
      "--background", [&line](Text text) { line.background = parse_color("--background", text); });
  app.add_option_function<std::string>(
      "--front", [&line](Text text) { line.front = opaque_color("--front", text); });
  app.add_option_function<std::string>(
      "--back", [&line](Text text) { line.back = opaque_color("--back", text); });
  app.add_flag("--flip", line.flip);
  app.add_option_function<std::string>(
      "--grid", [&line](Text text) { line.grid = parse_grid_lines("--grid", text); });
  app.add_option_function<std::string>("--antialias", [&line](Text text) {
    line.antialias = parse_whole("--antialias", text, 1, kMaxAntialias);
  });
}

void add_mesh_options(CLI::App& app, CommandLine& line) {
  app.add_option_function<std::string>(
      "--tolerance", [&line](Text text) { line.tolerance = parse_tolerance("--tolerance", text); });
  app.add_option_function<std::string>("--normal-tolerance", [&line](Text text) {
    line.normal_tolerance = parse_degrees("--normal-tolerance", text);
  });
  app.add_option_function<std::string>("--max-triangles", [&line](Text text) {
    line.max_triangles = parse_whole("--max-triangles", text, 2, kMaxTriangles);
  });
  app.add_option_function<std::string>("--clip", [&line](Text text) {
    const bool automatic = text == "auto" || text == "AUTO";
    line.clip = Clip{automatic, {}};
    if (!automatic && text != "off") line.clip->box = parse_box("--clip", text);
  });
  app.add_option_function<std::string>(
      "--samples", [&line](Text text) { line.samples = parse_samples("--samples", text); });
}

void add_computing_options(CLI::App& app, CommandLine& line) {
  app.add_option_function<std::string>("--t", [&line](Text text) { line.t = text; });
  app.add_option_function<std::string>("--threads", [&line](Text text) {
    line.threads = static_cast<unsigned>(parse_whole("--threads", text, 1, kMaxThreads));
  });
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

/// `list` and `show` take no options: none would do anything.
void check_no_options(const CLI::App& app, const std::string& verb) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0) continue;
    throw Error(Status::Input, "saddle " + verb + " takes no option " + option->get_name());
  }
}

void take_verb(const CLI::App& app, const std::string& first, CommandLine& line) {
  if (first != "list" && first != "show") return;
  check_no_options(app, first);
  line.command = first == "list" ? CommandLine::Command::List : CommandLine::Command::Show;
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
  add_look_options(app, line);
  add_mesh_options(app, line);
  add_computing_options(app, line);
  app.add_flag("-h,--help", help);
  app.add_flag("--version", version);
  parse_with_cli11(app, argc, argv);
  line.arguments = plain_arguments(app);
  if (help) {
    const bool functions = line.arguments == std::vector<std::string>{"functions"};
    line.command = functions ? CommandLine::Command::Functions : CommandLine::Command::Help;
  } else if (version) {
    line.command = CommandLine::Command::Version;
  } else if (argc > 1) {
    take_verb(app, argv[1], line);
  }
  return line;
}

}  // namespace saddle
