// Shared libraries that are loaded only when they are needed.
#pragma once

#include <span>

namespace saddle {

/// A library that draws without a window. It is never closed: Mesa and LLVM leave threads and exit
/// handlers behind that must find their code.
class Library {
 public:
  /// The first of `names` that can be loaded. Throws Error (Machine) with the loader's reason and
  /// the `package` that has it.
  Library(std::span<const char* const> names, const char* package);

  /// Sets a pointer to the function of that name. Throws Error (Machine) if the library has none.
  template <typename Function>
  void load(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  void* handle_ = nullptr;
  const char* package_;
};

}  // namespace saddle
