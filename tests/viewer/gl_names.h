// Counts the names that OpenGL has handed out and not got back, whoever asked for them, in any
// thread.
#pragma once

#include <atomic>

#include "render/gl/gl.h"

namespace saddle {

/// Stands between callers and two functions of the loader, one that makes names and one that takes
/// them back, from its making to its end. One at a time for each pair.
template <auto& generate, auto& remove>
class CountedNames {
 public:
  CountedNames() : generate_(generate), remove_(remove) {
    live_ = 0;
    made_ = 0;
    real_generate_ = generate;
    real_remove_ = remove;
    generate = [](GLsizei count, GLuint* names) {
      live_ += count;
      made_ += count;
      real_generate_(count, names);
    };
    remove = [](GLsizei count, const GLuint* names) {
      live_ -= count;
      real_remove_(count, names);
    };
  }
  ~CountedNames() {
    generate = generate_;
    remove = remove_;
  }
  CountedNames(const CountedNames&) = delete;
  CountedNames& operator=(const CountedNames&) = delete;

  int live() const { return live_; }
  int made() const { return made_; }

 private:
  using Generate = void (*)(GLsizei, GLuint*);
  using Remove = void (*)(GLsizei, const GLuint*);
  static inline std::atomic<int> live_ = 0;
  static inline std::atomic<int> made_ = 0;
  static inline Generate real_generate_ = nullptr;
  static inline Remove real_remove_ = nullptr;
  Generate generate_;
  Remove remove_;
};

/// The same for shaders and programs, which come one by one.
class CountedPrograms {
 public:
  CountedPrograms() {
    live_ = 0;
    create_shader_ = glad_glCreateShader;
    delete_shader_ = glad_glDeleteShader;
    create_program_ = glad_glCreateProgram;
    delete_program_ = glad_glDeleteProgram;
    glad_glCreateShader = [](GLenum stage) { return ++live_, create_shader_(stage); };
    glad_glDeleteShader = [](GLuint name) { --live_, delete_shader_(name); };
    glad_glCreateProgram = [] { return ++live_, create_program_(); };
    glad_glDeleteProgram = [](GLuint name) { --live_, delete_program_(name); };
  }
  ~CountedPrograms() {
    glad_glCreateShader = create_shader_;
    glad_glDeleteShader = delete_shader_;
    glad_glCreateProgram = create_program_;
    glad_glDeleteProgram = delete_program_;
  }
  CountedPrograms(const CountedPrograms&) = delete;
  CountedPrograms& operator=(const CountedPrograms&) = delete;

  int live() const { return live_; }

 private:
  static inline std::atomic<int> live_ = 0;
  static inline PFNGLCREATESHADERPROC create_shader_ = nullptr;
  static inline PFNGLDELETESHADERPROC delete_shader_ = nullptr;
  static inline PFNGLCREATEPROGRAMPROC create_program_ = nullptr;
  static inline PFNGLDELETEPROGRAMPROC delete_program_ = nullptr;
};

/// Of everything that OpenGL 3.3 names.
struct GlNames {
  CountedNames<glad_glGenBuffers, glad_glDeleteBuffers> buffers;
  CountedNames<glad_glGenVertexArrays, glad_glDeleteVertexArrays> vertex_arrays;
  CountedNames<glad_glGenFramebuffers, glad_glDeleteFramebuffers> framebuffers;
  CountedNames<glad_glGenRenderbuffers, glad_glDeleteRenderbuffers> renderbuffers;
  CountedNames<glad_glGenTextures, glad_glDeleteTextures> textures;
  CountedNames<glad_glGenQueries, glad_glDeleteQueries> queries;
  CountedNames<glad_glGenSamplers, glad_glDeleteSamplers> samplers;
  CountedPrograms programs;

  int live() const {
    return buffers.live() + vertex_arrays.live() + framebuffers.live() + renderbuffers.live() +
           textures.live() + queries.live() + samplers.live() + programs.live();
  }
  int made() const { return buffers.made() + framebuffers.made(); }
};

}  // namespace saddle
