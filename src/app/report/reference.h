// Pictures that must not change: --reference.
#pragma once

#include <string>

#include "app/command_line/cli.h"
#include "base/image.h"

namespace saddle {

/// The run reads this file: a scene, or the reference.
bool is_input(const CommandLine& line, const std::string& path);

/// Removes the report and the picture of the difference that an earlier comparison left, so that a
/// run that fails before its own has none. Files that the run reads stay, and without --reference
/// all.
void remove_results_of_comparison(const CommandLine& line);

/// Where the picture of the difference goes; empty without a reference.
std::string difference_path(const std::string& reference);

/// A reference and the picture of a run that is compared with it.
class ReferenceCheck {
 public:
  /// Reads the reference that `path` names. Throws Error as read_png() does.
  ReferenceCheck(std::string path, double threshold);

  void take(const Image& picture) { picture_ = picture; }

  /// After take(): throws Error (Machine) with the figures, after writing a picture of the
  /// difference, if the error is more than `threshold`. Returns the figures as a sentence
  /// otherwise.
  std::string compare() const;

 private:
  std::string path_;
  double threshold_;
  Image reference_;
  Image picture_;
};

}  // namespace saddle
