# The letters of axes and colour bars: DejaVu Sans from its Debian package, inside the program, so
# that pictures are the same on every machine.
find_file(SADDLE_FONT DejaVuSans.ttf
  PATHS /usr/share/fonts /usr/local/share/fonts
  PATH_SUFFIXES truetype/dejavu dejavu-sans-fonts TTF dejavu NO_DEFAULT_PATH)
if(NOT SADDLE_FONT)
  message(FATAL_ERROR "DejaVuSans.ttf is missing: install fonts-dejavu-core, or set SADDLE_FONT")
endif()
list(APPEND SADDLE_SEPARATE ${CMAKE_SOURCE_DIR}/src/render/overlay/font_file.cpp)
add_library(saddle_font STATIC ${CMAKE_SOURCE_DIR}/src/render/overlay/font_file.cpp)
target_compile_definitions(saddle_font PRIVATE SADDLE_FONT="${SADDLE_FONT}")
set_source_files_properties(${CMAKE_SOURCE_DIR}/src/render/overlay/font_file.cpp PROPERTIES
  OBJECT_DEPENDS ${SADDLE_FONT})
target_include_directories(saddle_font PRIVATE ${CMAKE_SOURCE_DIR}/src)
target_link_libraries(saddle_font PRIVATE saddle_options)
# The library that lays out and draws them; ImGui has it inside, too.
find_library(SADDLE_STB NAMES libstb.a stb REQUIRED)
find_path(SADDLE_STB_INCLUDE stb_truetype.h PATH_SUFFIXES stb REQUIRED)
target_include_directories(saddle_font SYSTEM INTERFACE ${SADDLE_STB_INCLUDE})
target_link_libraries(saddle_font INTERFACE ${SADDLE_STB})
