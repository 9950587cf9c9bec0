// The program's own words.
#pragma once

#include <string>
#include <vector>

namespace saddle {

/// `saddle --help TOPIC`: an option's name (with or without its dashes), `functions`, `scene`,
/// `status` or `keys`; several of them; without a topic a line for every option. Throws Error
/// (Input) with the nearest topic for an unknown word.
std::string help_text(const std::vector<std::string>& topics);

/// `saddle --version`.
std::string version_text();

/// "0.1.0", for reports.
std::string version();

}  // namespace saddle
