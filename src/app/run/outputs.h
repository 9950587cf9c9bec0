// The files that a run writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_line/cli.h"
#include "base/error.h"
#include "base/file.h"
#include "export/formats/formats.h"

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
  /// That, and those that may be written beside it; none for standard output.
  std::vector<std::string> files_of(int frame) const;
  /// The path without its extension, which files beside it begin with; empty for what is no file.
  std::string stem_of(int frame) const;
};

/// Nothing is written: the command line asks for the viewer.
bool wants_viewer(const CommandLine& line);

/// The outputs of the command line, checked before anything is computed. Throws Error: Input for
/// an unknown extension, a terminal, two things for standard output, a path with two numbers;
/// Machine for a path that cannot be written, the report's included.
std::vector<Output> checked_outputs(const CommandLine& line);

/// Writes to the paths, or to standard output for one that is "-": all of them or none.
void write_all(const std::vector<FileToWrite>& files);

/// The file of the meshes of a frame, and those that go beside it. `content` gets the stem, and is
/// there when they are written.
std::vector<FileToWrite> mesh_files(const Output& output, int frame, MeshContent& content);

}  // namespace saddle
