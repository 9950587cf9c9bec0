#include "render/context.h"

#include "base/error.h"
#include "render/gl.h"

namespace saddle {

void load_gl_functions(void (*(*address)(const char* name))()) {
  if (gladLoadGL(address) < GLAD_MAKE_VERSION(3, 3)) {
    throw Error(Status::Machine, "the OpenGL of this display is older than 3.3", {},
                "saddle ... -o FILE.png draws without a display");
  }
}

}  // namespace saddle
