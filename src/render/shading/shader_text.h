// Texts of shaders, and the preprocessor's work, done before the compiler sees them: the text of a
// scene's program can be read, and tested.
#pragma once

#include <string>
#include <vector>

namespace saddle {

/// Sources of a program.
struct ShaderText {
  std::string vertex;
  std::string fragment;
};

/// The text without the lines that #ifdef, #ifndef, #else and #endif leave out for these names.
std::string keep_defined(const std::string& text, const std::vector<std::string>& names);

}  // namespace saddle
