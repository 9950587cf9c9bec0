// Shader programs whose interface is checked: a uniform or attribute that is used and not set is an
// error, and so is one that is set and does not exist.
#pragma once

#include <map>
#include <span>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "base/vec.h"
#include "render/gl/gl.h"

namespace saddle {

/// Attribute locations, as the shaders' layout(location = ...) have them.
enum Attribute : GLuint {
  kPosition = 0,
  kNormal = 1,
  kParameters = 2,
  kColor = 3,
  kTrust = 4,
  kFarEnd = 5,
  kOnMesh = 6,
  kTexture = 7,
  kFarOnMesh = 8
};

class Program {
 public:
  /// Compiles and links. Throws Error (Machine) with the compiler's log: the shaders are ours, so
  /// an error in them is a defect of the program or of the driver. `captured`: an output of the
  /// vertex shader for transform feedback.
  Program(const std::string& vertex_source, const std::string& fragment_source,
          const std::string& captured = "");

  void use() const { glUseProgram(program_.get()); }

  /// The program must be in use. A uniform that the compiler found unused is left alone.
  void set(const std::string& name, double value);
  void set(const std::string& name, const dvec3& value);
  void set(const std::string& name, const glm::dmat4& value);
  void set(const std::string& name, const glm::dmat3& value);
  void set(const std::string& name, std::span<const dvec3> values);
  void set(const std::string& name, std::span<const double> values);
  /// Sets a sampler to the unit that its texture is bound to.
  void set_texture(const std::string& name, int unit);

  /// Throws Error (Machine) if a uniform has never been set.
  void check_all_set() const;

 private:
  struct Uniform {
    GLint location = -1;
    bool set = false;
  };

  GLint location(const std::string& name);
  void find_uniforms();
  void check_attributes() const;

  std::string source_;  // of both stages, to tell an unused name from a wrong one
  GlProgram program_;
  std::map<std::string, Uniform> uniforms_;
};

}  // namespace saddle
