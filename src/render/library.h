// Shared libraries that are loaded only when they are needed.
#pragma once

#include <span>
#include <string>

namespace saddle {

/// A handle for dlsym of the first of `names` that can be loaded. It is never closed: Mesa and LLVM
/// leave threads and exit handlers behind that must find their code. Throws Error (Machine) that
/// says what `purpose` lacks, the loader's reason and the `package` that has it.
void* open_library(std::span<const char* const> names, const std::string& purpose,
                   const std::string& package);

/// The address of `symbol`. Throws Error (Machine) if the library has none.
void* library_symbol(void* library, const char* symbol, const std::string& package);

}  // namespace saddle
