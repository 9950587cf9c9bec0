// A library with a variable of its own for each thread. It is loaded at run time, so that these are
// in the heap; there, 8 bytes may begin at a multiple of 16 that is none of 32.
extern "C" double* variable_of_thread() {
  static thread_local double variable = 1;
  return &variable;
}
