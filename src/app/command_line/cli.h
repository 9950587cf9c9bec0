// The command line as data.
#pragma once

#include <string>
#include <vector>

#include "scene/options/options.h"
#include "scene/options/run_settings.h"

namespace saddle {

/// An option of the command line with its value, "" for a flag.
struct GivenOption {
  const Option* option;
  std::string text;
};

/// The first word of a command line.
struct Verb {
  std::string_view name;
  Command command;
  std::string_view hint;  ///< where it is given an option that it does not take
};

/// nullptr if no verb has the name.
const Verb* find_verb(std::string_view name);

/// The words between two lone `+`: an object of the scene, or, first and without a surface of its
/// own, what holds for all objects.
struct Segment {
  std::vector<std::string> arguments;  ///< assignments and names, without a verb
  std::vector<GivenOption> given;      ///< options of objects, in their order
};

struct CommandLine {
  Command command = Command::Graph;
  std::vector<Segment> segments = std::vector<Segment>(1);  ///< one at least
  std::vector<GivenOption> given;                           ///< all other options, in their order
  RunSettings run;                                          ///< what those of the run say
  std::vector<std::string> help_topics;  ///< the words after a first argument --help

  /// Those of all segments.
  std::vector<std::string> arguments() const;
  /// The last of these options that is given, by name and without "--"; nullptr: none is.
  const Option* last_given(const std::vector<std::string_view>& names) const;
};

/// Options are those of scene/options/options.h: `--name VALUE`, `--name=VALUE`, `-n VALUE`,
/// `-nVALUE`, flags together (`-qh`), in any place; what follows `--` is no option. An option that
/// is given again replaces its value, an object's within its segment. Throws Error (Input): an
/// unknown option or one that the command does not take, a value that is missing, a segment without
/// arguments after another; of the run's options also one that is malformed or out of range. `line`
/// then has what stands before it, and the paths of reference and report.
void parse_command_line(int argc, const char* const* argv, CommandLine& line);

}  // namespace saddle
