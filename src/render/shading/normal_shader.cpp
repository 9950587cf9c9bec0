#include "render/shading/normal_shader.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <vector>

#include "render/shading/shaders.h"

namespace saddle {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool uses(std::string_view text, std::string_view name) {
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string_view::npos; ++at) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_word(text[at - 1]);
    if (begins && (end == text.size() || !is_word(text[end]))) return true;
  }
  return false;
}

/// The name that a definition of shaders/functions.glsl defines: after "#define", "const float" or
/// "float", up to a space or bracket. Empty for a comment.
std::string_view defined_name(std::string_view definition) {
  for (const std::string_view start : {"#define ", "const float ", "float "}) {
    const std::size_t at = definition.find(start);
    if (at != 0 && (at == std::string_view::npos || definition[at - 1] != '\n')) continue;
    definition.remove_prefix(at + start.size());
    return definition.substr(0, std::ranges::find_if_not(definition, is_word) - definition.begin());
  }
  return {};
}

/// The definitions of a file: paragraphs, and each line of those that have no bodies.
std::vector<std::string> definitions(const std::string& text) {
  std::vector<std::string> all;
  std::string paragraph;
  std::istringstream lines(text + "\n\n");
  for (std::string line; std::getline(lines, line);) {
    const bool whole = line.starts_with("#define ") || line.starts_with("const ");
    if (!line.empty()) paragraph += line + "\n";
    if ((!line.empty() && !whole) || paragraph.empty()) continue;
    all.push_back(std::move(paragraph));
    paragraph.clear();
  }
  return all;
}

/// A function stands behind those that it calls.
std::string functions_for(const std::string& code) {
  const std::vector<std::string> all = definitions(std::string(shader_source("functions.glsl")));
  std::string text;
  for (std::size_t i = all.size(); i-- > 0;) {
    const std::string_view name = defined_name(all[i]);
    if (!name.empty() && uses(text + code, name)) text = all[i] + "\n" + text;
  }
  return text;
}

std::string indented(const std::string& code) {
  std::string text;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  return text;
}

}  // namespace

std::string normal_shader(const ShaderNormal& normal) {
  std::vector<std::string> names = {"FORMULA"};
  if (normal.flip) names.emplace_back("FLIP");
  if (!normal.constants.empty()) names.emplace_back("CONSTANTS");
  std::string text = keep_defined(std::string(shader_source("normal.glsl")), names);
  text.erase(0, text.find("\n\n") + 2);  // what the names mean is for the file's reader
  const auto replace = [&text](const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    if (at != std::string::npos) text.replace(at, what.size(), with);
  };
  replace("CONSTANT_COUNT", std::to_string(normal.constants.size()));
  replace("  FORMULA\n", indented(normal.code));
  return functions_for(normal.code) + text;
}

ShaderText trust_shader(const ShaderNormal& normal) {
  std::string vertex(shader_source("trust.vert.glsl"));
  vertex.insert(vertex.find('\n') + 1, normal_shader(normal));  // after #version
  return {vertex, std::string(shader_source("trust.frag.glsl"))};
}

}  // namespace saddle
