#include "view/window/display_end.h"

#include <dlfcn.h>

#include <cstdlib>

#include "base/error.h"

namespace saddle {
namespace {

// Found by their names: GLFW has its part for X, and X the last of them, not everywhere.
using Display = void*;
using GetDisplay = Display (*)();
using Broken = int (*)(Display display);
using SetBroken = Broken (*)(Broken broken);
using Gone = void (*)(Display display, void* act);
using SetGone = void (*)(Display display, Gone gone, void* act);

}  // namespace

void call_when_display_goes(const std::function<void()>& act) {
  const auto get_display = reinterpret_cast<GetDisplay>(dlsym(RTLD_DEFAULT, "glfwGetX11Display"));
  void* const library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  if (get_display == nullptr || library == nullptr) return;
  const auto set_broken = reinterpret_cast<SetBroken>(dlsym(library, "XSetIOErrorHandler"));
  const auto set_gone = reinterpret_cast<SetGone>(dlsym(library, "XSetIOErrorExitHandler"));
  const Display display = get_display();
  if (set_broken == nullptr || set_gone == nullptr || display == nullptr) return;
  // The first handler of X would end the process before the second one is called.
  set_broken([](Display) { return 0; });
  // Threads are at work, so nothing is destroyed.
  const Gone gone = [](Display, void* what) {
    (*static_cast<const std::function<void()>*>(what))();
    std::_Exit(static_cast<int>(Status::Machine));
  };
  set_gone(display, gone, const_cast<std::function<void()>*>(&act));
}

}  // namespace saddle
