// An OpenGL context without a window. Back ends derive from Context; nothing else in the program
// uses inheritance.
#pragma once

#include <memory>
#include <string>

#include "scene/options/run_settings.h"

namespace saddle {

/// A current OpenGL 3.3 core context; GL functions are loaded once it exists. Pictures are drawn
/// into a Target, never into the context's own framebuffer. It belongs to the thread that made it,
/// until that thread leaves it and another enters it.
class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// From now on no thread's; entered by this one. Throws Error (Machine) if OpenGL refuses.
  virtual void leave() = 0;
  virtual void enter() = 0;

  /// "osmesa" ..., for reports.
  virtual std::string name() const = 0;

 protected:
  Context() = default;
};

/// Loads the functions of a context that is current already, such as a window's. `address` finds a
/// function by its name. Throws Error (Machine) if it is older than OpenGL 3.3.
void load_gl_functions(void (*(*address)(const char* name))());

/// The backends' libraries are loaded here and only here, when a picture is wanted. Throws Error
/// (Machine) that names what is missing and the package that has it.
std::unique_ptr<Context> make_context(Backend backend);
std::unique_ptr<Context> make_osmesa_context();
std::unique_ptr<Context> make_egl_context();

}  // namespace saddle
