// Where the program and the sources are that a test looks at.
#pragma once

#include <string>

namespace saddle {

/// The saddle of this build.
std::string program_path();

/// The top of the source tree.
std::string source_folder();

}  // namespace saddle
