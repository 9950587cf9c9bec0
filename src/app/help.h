// The program's own words.
#pragma once

#include <string>

namespace saddle {

/// `saddle --help`: fits one screen.
std::string help_text();

/// `saddle --version`.
std::string version_text();

/// "0.1.0", for reports.
std::string version();

}  // namespace saddle
