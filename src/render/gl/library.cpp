#include "render/gl/library.h"

#include <dlfcn.h>

#include <string>

#include "base/error.h"

namespace saddle {

Library::Library(std::span<const char* const> names, const char* package) : package_(package) {
  std::string reason;
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    if (handle_ != nullptr) return;
    const char* why = dlerror();
    if (reason.empty() && why != nullptr) reason = why;  // the preferred one's
  }
  // Where --max-memory or the system leaves too little, the loader says so in these words.
  for (const char* lack : {"failed to map segment", "annot allocate memory"}) {
    if (reason.find(lack) == std::string::npos) continue;
    throw Error(Status::Machine, "not enough memory for OpenGL: " + reason, {},
                "--max-memory and ulimit -v say how much there may be");
  }
  throw Error(Status::Machine,
              "drawing without a window needs a library that cannot be loaded: " + reason, {},
              "install the package " + std::string(package));
}

void* Library::symbol(const char* name) const {
  if (void* address = dlsym(handle_, name)) return address;
  throw Error(Status::Machine, "the installed library is too old: it has no " + std::string(name),
              {}, "update the package " + std::string(package_));
}

}  // namespace saddle
