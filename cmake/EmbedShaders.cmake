# shaders/*.glsl become C++ string constants, so that the program is one file. The sources stay
# real GLSL files, which glslangValidator checks.
file(GLOB SADDLE_SHADERS CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/*.glsl)
set(SHADERS_CPP ${CMAKE_BINARY_DIR}/shaders/shaders.cpp)
add_custom_command(
  OUTPUT ${SHADERS_CPP}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${SHADERS_CPP} "-DFILES=${SADDLE_SHADERS}"
          -DHEADER=render/shading/shaders.h -DFUNCTION=shader_source
          -P ${CMAKE_SOURCE_DIR}/cmake/WriteTexts.cmake
  DEPENDS ${SADDLE_SHADERS} ${CMAKE_SOURCE_DIR}/cmake/WriteTexts.cmake
  COMMENT "Embedding the shaders"
  VERBATIM)
add_library(saddle_shaders STATIC ${SHADERS_CPP})
target_include_directories(saddle_shaders PRIVATE ${CMAKE_SOURCE_DIR}/src)
target_link_libraries(saddle_shaders PRIVATE saddle_options)
set_target_properties(saddle_shaders PROPERTIES CXX_CLANG_TIDY "")  # nobody wrote it
