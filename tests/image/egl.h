// EGL in tests.
#pragma once

#include <dlfcn.h>
#include <link.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "render/gl/context.h"

namespace saddle {

/// Drivers of OpenGL that are loaded now stay until the process ends: what an unloaded one has kept
/// looks like a leak.
inline void keep_drivers_loaded() {
  std::vector<std::string> names;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* all) {
        const std::string_view name = info->dlpi_name;
        if (name.ends_with("_dri.so"))
          static_cast<std::vector<std::string>*>(all)->emplace_back(name);
        return 0;
      },
      &names);
  for (const std::string& name : names) dlopen(name.c_str(), RTLD_LAZY | RTLD_NODELETE);
}

/// Why EGL cannot draw here; empty: it can.
inline std::string fault_of_egl() {
  try {
    const auto context = make_context(Backend::Egl);
    keep_drivers_loaded();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace saddle
