#include "render/gl/context.h"

#include <string>

#include "base/error.h"
#include "render/gl/gl.h"

namespace saddle {

void load_gl_functions(void (*(*address)(const char* name))()) {
  if (gladLoadGL(address) < GLAD_MAKE_VERSION(3, 3)) {
    throw Error(Status::Machine, "the OpenGL of this display is older than 3.3");
  }
}

std::unique_ptr<Context> make_context(Backend backend) {
  if (backend == Backend::Osmesa) return make_osmesa_context();
  if (backend == Backend::Egl) return make_egl_context();
  try {
    return make_osmesa_context();
  } catch (const Error& osmesa) {
    try {
      return make_egl_context();
    } catch (const Error& egl) {
      throw Error(egl.status(),
                  "nothing here can draw: " + std::string(osmesa.what()) + "; " + egl.what(), {},
                  osmesa.hint_lines());
    }
  }
}

}  // namespace saddle
