// EGL without a surface: Mesa's other way to draw without a display, and on a graphics card if
// there is one. The only file that knows EGL; its library is loaded at run time.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <memory>
#include <string>

#include "base/error.h"
#include "render/gl/context.h"
#include "render/gl/gl.h"
#include "render/gl/library.h"
#include "render/gl/mesa_room.h"

namespace saddle {
namespace {

constexpr std::array kEglLibraries{"libEGL.so.1", "libEGL.so"};
const char* const kEglPackage = "libegl1";

struct EglFunctions {
  decltype(&eglGetPlatformDisplay) get_platform_display;
  decltype(&eglInitialize) initialize;
  decltype(&eglTerminate) terminate;
  decltype(&eglBindAPI) bind_api;
  decltype(&eglChooseConfig) choose_config;
  decltype(&eglCreateContext) create_context;
  decltype(&eglMakeCurrent) make_current;
  decltype(&eglGetProcAddress) get_proc_address;

  EglFunctions() {
    const Library library(kEglLibraries, kEglPackage);
    library.load(get_platform_display, "eglGetPlatformDisplay");
    library.load(initialize, "eglInitialize");
    library.load(terminate, "eglTerminate");
    library.load(bind_api, "eglBindAPI");
    library.load(choose_config, "eglChooseConfig");
    library.load(create_context, "eglCreateContext");
    library.load(make_current, "eglMakeCurrent");
    library.load(get_proc_address, "eglGetProcAddress");
  }
};

/// Ends a display and its context, which would outlive it while it is a thread's current one.
struct EndOfDisplay {
  decltype(&eglMakeCurrent) make_current;
  decltype(&eglTerminate) terminate;

  void operator()(EGLDisplay display) const {
    make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    terminate(display);
  }
};

[[noreturn]] void fail(const std::string& what) {
  throw Error(
      Status::Machine, what, {},
      std::string("the packages ") + kEglPackage + " and libgl1-mesa-dri have what it needs");
}

class EglContext final : public Context {
 public:
  EglContext()
      : display_(open_display(functions_), {functions_.make_current, functions_.terminate}),
        context_(create_context()) {
    enter();
    if (gladLoadGL(functions_.get_proc_address) < GLAD_MAKE_VERSION(3, 3)) {
      fail("EGL's OpenGL is older than 3.3");
    }
  }

  void leave() override { make_current(EGL_NO_CONTEXT); }
  /// Which API is current is a thread's own.
  void enter() override {
    if (functions_.bind_api(EGL_OPENGL_API) != EGL_TRUE) fail("EGL has no OpenGL here");
    make_current(context_);
  }

  std::string name() const override { return "egl"; }

 private:
  static EGLDisplay open_display(const EglFunctions& functions) {
    make_room_for_mesa();
    EGLDisplay display =
        functions.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || functions.initialize(display, nullptr, nullptr) != EGL_TRUE) {
      fail("EGL cannot draw without a display here");
    }
    return display;
  }

  EGLContext create_context() const {
    constexpr std::array wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    constexpr std::array attributes{EGL_CONTEXT_MAJOR_VERSION,
                                    3,
                                    EGL_CONTEXT_MINOR_VERSION,
                                    3,
                                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                    EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    EGLContext context = EGL_NO_CONTEXT;
    if (functions_.bind_api(EGL_OPENGL_API) == EGL_TRUE &&
        functions_.choose_config(display_.get(), wanted.data(), &config, 1, &count) == EGL_TRUE &&
        count > 0) {
      context =
          functions_.create_context(display_.get(), config, EGL_NO_CONTEXT, attributes.data());
    }
    if (context == EGL_NO_CONTEXT) fail("EGL cannot make an OpenGL 3.3 core context");
    return context;
  }

  void make_current(EGLContext context) const {
    if (functions_.make_current(display_.get(), EGL_NO_SURFACE, EGL_NO_SURFACE, context) !=
        EGL_TRUE) {
      fail("EGL cannot draw without a surface here");
    }
  }

  EglFunctions functions_;
  std::unique_ptr<void, EndOfDisplay> display_;
  EGLContext context_;
};

}  // namespace

std::unique_ptr<Context> make_egl_context() {
  return std::make_unique<EglContext>();
}

}  // namespace saddle
