// The files that a run writes.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "app/command_line/cli.h"
#include "base/error.h"
#include "export/formats.h"

namespace saddle {

struct Output {
  std::string path;  ///< "-": standard output
  const Format* format = nullptr;
  /// Where in the path the frame's number goes: "%04d" in the file's name, in which "%%" stands for
  /// a percent sign; those of folders are as they are.
  std::optional<Span> number = {};

  bool is(Format::Kind kind) const { return format->kind == kind; }
  /// It is about an animation's frames, not about one moment.
  bool takes_frames() const { return number || is(Format::Kind::Animation); }
  /// It is about one moment.
  bool is_still() const { return !takes_frames() && !is(Format::Kind::Scene); }
  /// The path of a frame.
  std::string path_of(int frame) const;
};

/// Nothing is written: the command line asks for the viewer.
bool wants_viewer(const CommandLine& line);

/// The outputs of the command line, checked before anything is computed. Throws Error: Input for
/// an unknown extension, a terminal, two things for standard output, a path with two numbers;
/// Machine for a path that cannot be written, the report's included.
std::vector<Output> checked_outputs(const CommandLine& line);

/// Throws Error (Input) where two outputs, among them the report and the picture of differences,
/// meet in one file. `frames`: the numbers that numbered outputs are written for.
void check_names_differ(const CommandLine& line, const std::vector<Output>& outputs,
                        std::span<const int> frames);

/// Lets `write` write to the path, or to standard output for "-".
void write_to(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace saddle
