# OpenGL 3.3 core functions, loaded at run time through a table that glad writes at build time from
# the registry inside its own package: no download. Only our own loader works under OSMesa; epoxy,
# GLEW and glbinding resolve functions through libGL.
find_program(SADDLE_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
set(GLAD_DIR ${CMAKE_BINARY_DIR}/glad)
set(GLAD_NO_EXTENSIONS ${CMAKE_BINARY_DIR}/glad-extensions.txt)
file(WRITE ${GLAD_NO_EXTENSIONS} "")
add_custom_command(
  OUTPUT ${GLAD_DIR}/src/gl.c ${GLAD_DIR}/include/glad/gl.h
  COMMAND ${SADDLE_PYTHON} -m glad --api gl:core=3.3 --extensions ${GLAD_NO_EXTENSIONS}
          --out-path ${GLAD_DIR} --reproducible --quiet c
  COMMENT "Generating the OpenGL loader"
  VERBATIM)
add_library(saddle_gl STATIC ${GLAD_DIR}/src/gl.c ${GLAD_DIR}/include/glad/gl.h)
target_include_directories(saddle_gl SYSTEM PUBLIC ${GLAD_DIR}/include)
