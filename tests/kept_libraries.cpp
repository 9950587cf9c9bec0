// In place of the C library's, in programs with sanitizers: no library is unloaded. What an
// unloaded driver of OpenGL has kept would look like a leak, and suppressions could not tell whose
// it is.
extern "C" int dlclose(void* /*library*/) {
  return 0;
}
