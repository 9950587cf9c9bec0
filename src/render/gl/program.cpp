#include "render/gl/program.h"

#include <array>
#include <vector>

#include "base/error.h"

namespace saddle {
namespace {

constexpr GLsizei kLongestName = 64;  // of a uniform or attribute, with room to spare

[[noreturn]] void defect(const std::string& message) {
  throw Error(Status::Machine, "a shader does not work: " + message, {},
              "this is a defect of saddle or of the OpenGL driver; please report it");
}

GlShader compile(GLenum stage, const std::string& source) {
  GlShader shader(glCreateShader(stage));
  const char* text = source.c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    std::array<char, 2048> log{};
    glGetShaderInfoLog(shader.get(), log.size(), nullptr, log.data());
    defect(log.data());
  }
  return shader;
}

GlProgram link(const GlShader& vertex, const GlShader& fragment, const std::string& captured) {
  GlProgram program(glCreateProgram());
  glAttachShader(program.get(), vertex.get());
  glAttachShader(program.get(), fragment.get());
  if (!captured.empty()) {
    const char* const name = captured.c_str();
    glTransformFeedbackVaryings(program.get(), 1, &name, GL_SEPARATE_ATTRIBS);
  }
  glLinkProgram(program.get());
  glDetachShader(program.get(), vertex.get());
  glDetachShader(program.get(), fragment.get());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    std::array<char, 2048> log{};
    glGetProgramInfoLog(program.get(), log.size(), nullptr, log.data());
    defect(log.data());
  }
  return program;
}

}  // namespace

Program::Program(const std::string& vertex_source, const std::string& fragment_source,
                 const std::string& captured)
    : source_(vertex_source + fragment_source),
      program_(link(compile(GL_VERTEX_SHADER, vertex_source),
                    compile(GL_FRAGMENT_SHADER, fragment_source), captured)) {
  find_uniforms();
  check_attributes();
}

void Program::find_uniforms() {
  GLint count = 0;
  glGetProgramiv(program_.get(), GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    std::array<char, kLongestName> text{};
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program_.get(), i, kLongestName, nullptr, &size, &type, text.data());
    std::string name = text.data();
    const GLint location = glGetUniformLocation(program_.get(), name.c_str());
    uniforms_[name.substr(0, name.find('['))] = {location, false};  // arrays come as "name[0]"
  }
}

void Program::check_attributes() const {
  static const std::map<std::string, GLint> known{
      {"position", kPosition},  {"corner_normal", kNormal}, {"parameters", kParameters},
      {"corner_color", kColor}, {"trust", kTrust},          {"far_end", kFarEnd},
      {"on_mesh", kOnMesh},     {"corner_place", kTexture}, {"far_on_mesh", kFarOnMesh}};
  GLint count = 0;
  glGetProgramiv(program_.get(), GL_ACTIVE_ATTRIBUTES, &count);
  for (GLint i = 0; i < count; ++i) {
    std::array<char, kLongestName> name{};
    GLint size = 0;
    GLenum type = 0;
    glGetActiveAttrib(program_.get(), i, kLongestName, nullptr, &size, &type, name.data());
    const GLint location = glGetAttribLocation(program_.get(), name.data());
    const auto found = known.find(name.data());
    if (location >= 0 && (found == known.end() || found->second != location)) {
      defect("no mesh supplies its attribute " + std::string(name.data()));
    }
  }
}

GLint Program::location(const std::string& name) {
  const auto found = uniforms_.find(name);
  if (found != uniforms_.end()) {
    found->second.set = true;
    return found->second.location;
  }
  if (source_.find(name) == std::string::npos) defect("it has no uniform " + name);
  return -1;  // optimized away; GL ignores -1
}

void Program::set(const std::string& name, double value) {
  glUniform1f(location(name), static_cast<float>(value));
}

void Program::set(const std::string& name, const dvec3& value) {
  set(name, std::span(&value, 1));
}

void Program::set(const std::string& name, const glm::dmat4& value) {
  const glm::mat4 rounded(value);
  glUniformMatrix4fv(location(name), 1, GL_FALSE, &rounded[0][0]);
}

void Program::set(const std::string& name, const glm::dmat3& value) {
  const glm::mat3 rounded(value);
  glUniformMatrix3fv(location(name), 1, GL_FALSE, &rounded[0][0]);
}

void Program::set(const std::string& name, std::span<const dvec3> values) {
  std::vector<glm::vec3> rounded(values.begin(), values.end());
  glUniform3fv(location(name), static_cast<GLsizei>(rounded.size()), &rounded[0][0]);
}

void Program::set(const std::string& name, std::span<const double> values) {
  std::vector<float> rounded(values.begin(), values.end());
  glUniform1fv(location(name), static_cast<GLsizei>(rounded.size()), rounded.data());
}

void Program::set_texture(const std::string& name, int unit) {
  glUniform1i(location(name), unit);
}

void Program::check_all_set() const {
  for (const auto& [name, uniform] : uniforms_) {
    if (!uniform.set) defect("its uniform " + name + " is not set");
  }
}

}  // namespace saddle
