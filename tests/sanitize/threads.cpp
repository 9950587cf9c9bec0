// A program without a leak: the preset's options must let LeakSanitizer see that. As OpenGL's
// drivers do, it has threads at its end that use variables of a library loaded at run time, so many
// that the heap puts some variables at the start of a page.
#include <dlfcn.h>

#include <cstdio>
#include <latch>
#include <thread>

int main() {
  constexpr int kThreads = 300;  // variables: one of 128 is there
  void* const library = dlopen(SADDLE_THREAD_VARIABLE, RTLD_NOW);
  if (library == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 2;
  }
  const auto variable = reinterpret_cast<double* (*)()>(dlsym(library, "variable_of_thread"));
  static std::latch begun(kThreads);
  static std::latch never(1);
  for (int i = 0; i < kThreads; ++i) {
    std::thread([=] {
      *variable() = 2;
      begun.count_down();
      never.wait();
    }).detach();
  }
  begun.wait();
  return 0;
}
