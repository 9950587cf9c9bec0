// Runs the program the way a shell would, and keeps what it says.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace saddle {

struct Outcome {
  int status = -1;  ///< exit status, or 128 + the signal that ended it
  std::string out;
  std::string err;
};

/// Runs saddle in `folder`; standard output goes to `standard_output` where that is given.
/// `limit` is called in the new process: what it may take is less there.
Outcome run_saddle(const std::vector<std::string>& arguments,
                   const std::filesystem::path& folder = ".",
                   const std::string& standard_output = "",
                   const std::function<void()>& limit = {});

/// A folder of its own for each test, removed at the end.
class ProgramTest : public testing::Test {
 protected:
  Outcome saddle(const std::vector<std::string>& arguments) {
    return run_saddle(arguments, folder_);
  }
  /// The same with options for a small, fast picture.
  Outcome small(std::vector<std::string> arguments);
  /// The report of such a run.
  nlohmann::json report_of(std::vector<std::string> arguments);
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Names of all files in the folder, temporaries included, sorted.
  std::vector<std::string> files() const;

  const TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

/// Whether a part occurs in what a run said.
inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Standard error of a run that must end with `status` and leave standard output empty.
std::string error_of(const Outcome& run, int status);

}  // namespace saddle
