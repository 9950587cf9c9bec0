#include "render/library.h"

#include <dlfcn.h>

#include <string_view>

#include "base/error.h"

namespace saddle {

void* open_library(std::span<const char* const> names, const std::string& purpose,
                   const std::string& package) {
  std::string reason;
  for (const char* name : names) {
    if (void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) return library;
    const char* why = dlerror();
    if (reason.empty() && why != nullptr) reason = why;  // the preferred one's
  }
  throw Error(Status::Machine, purpose + " needs a library that cannot be loaded: " + reason, {},
              "install the package " + package);
}

void* library_symbol(void* library, const char* symbol, const std::string& package) {
  if (void* address = dlsym(library, symbol)) return address;
  throw Error(Status::Machine, "the installed library is too old: it has no " + std::string(symbol),
              {}, "update the package " + package);
}

}  // namespace saddle
