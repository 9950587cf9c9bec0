// Off-screen Mesa. The only file that knows OSMesa; its library is loaded at run time, so that a
// run without a picture does not pay for it.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "base/error.h"
#include "render/gl/context.h"
#include "render/gl/gl.h"
#include "render/gl/library.h"
#include "render/gl/mesa_room.h"

// After glad's header: the two define the same functions, and the first one wins.
#include <GL/osmesa.h>

namespace saddle {
namespace {

constexpr std::array kOsmesaLibraries{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
const char* const kOsmesaPackage = "libosmesa6";

struct OsmesaFunctions {
  decltype(&OSMesaCreateContextAttribs) create;
  decltype(&OSMesaDestroyContext) destroy;
  decltype(&OSMesaMakeCurrent) make_current;
  decltype(&OSMesaGetProcAddress) get_proc_address;

  OsmesaFunctions() {
    const Library library(kOsmesaLibraries, kOsmesaPackage);
    library.load(create, "OSMesaCreateContextAttribs");
    library.load(destroy, "OSMesaDestroyContext");
    library.load(make_current, "OSMesaMakeCurrent");
    library.load(get_proc_address, "OSMesaGetProcAddress");
  }
};

/// Mesa crashes when this names a driver that is not in its library.
void refuse_unknown_driver() {
  const char* const driver = std::getenv("GALLIUM_DRIVER");
  if (driver == nullptr) return;
  const std::string_view name = driver;
  if (name == "llvmpipe" || name == "softpipe" || name.empty()) return;
  throw Error(Status::Machine,
              "GALLIUM_DRIVER names a driver that OSMesa lacks: " + std::string(name), {},
              "unset it, or set it to llvmpipe");
}

class OsmesaContext final : public Context {
 public:
  OsmesaContext() : context_(create(functions_)) {
    enter();
    if (gladLoadGL(functions_.get_proc_address) < GLAD_MAKE_VERSION(3, 3)) refuse();
  }

  void leave() override {
    if (functions_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0) != GL_TRUE) refuse();
  }
  void enter() override {
    if (functions_.make_current(context_.get(), pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
      refuse();
    }
  }

  std::string name() const override { return "osmesa"; }

 private:
  [[noreturn]] static void refuse() {
    throw Error(Status::Machine, "OSMesa's OpenGL 3.3 cannot be used", {},
                std::string("update the package ") + kOsmesaPackage);
  }

  using Handle = std::unique_ptr<osmesa_context, decltype(&OSMesaDestroyContext)>;

  /// No depth: OSMesa's own framebuffer must exist, but is never shown. It is a single pixel.
  static Handle create(const OsmesaFunctions& functions) {
    refuse_unknown_driver();
    make_room_for_mesa();
    constexpr std::array attributes{OSMESA_FORMAT,
                                    OSMESA_RGBA,
                                    OSMESA_PROFILE,
                                    OSMESA_CORE_PROFILE,
                                    OSMESA_CONTEXT_MAJOR_VERSION,
                                    3,
                                    OSMESA_CONTEXT_MINOR_VERSION,
                                    3,
                                    0};
    Handle context(functions.create(attributes.data(), nullptr), functions.destroy);
    if (!context) {
      throw Error(Status::Machine, "OSMesa cannot make an OpenGL 3.3 core context", {},
                  "Mesa 12 or newer is needed; unset GALLIUM_DRIVER and MESA_* if they are set");
    }
    return context;
  }

  OsmesaFunctions functions_;
  std::array<std::uint8_t, 4> pixel_{};  // before the context, which may still flush into it
  Handle context_;
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() {
  return std::make_unique<OsmesaContext>();
}

}  // namespace saddle
