# src/export/page/ becomes C++ string constants: the script and the style of exported pages.
file(GLOB SADDLE_PAGE CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/src/export/page/*.js ${CMAKE_SOURCE_DIR}/src/export/page/*.css)
set(PAGE_CPP ${CMAKE_BINARY_DIR}/page/page_sources.cpp)
add_custom_command(
  OUTPUT ${PAGE_CPP}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${PAGE_CPP} "-DFILES=${SADDLE_PAGE}"
          -DHEADER=export/page_sources.h -DFUNCTION=page_source
          -P ${CMAKE_SOURCE_DIR}/cmake/WriteTexts.cmake
  DEPENDS ${SADDLE_PAGE} ${CMAKE_SOURCE_DIR}/cmake/WriteTexts.cmake
  COMMENT "Embedding the page"
  VERBATIM)
add_library(saddle_page STATIC ${PAGE_CPP})
target_include_directories(saddle_page PRIVATE ${CMAKE_SOURCE_DIR}/src)
target_link_libraries(saddle_page PRIVATE saddle_options)
set_target_properties(saddle_page PROPERTIES CXX_CLANG_TIDY "")  # nobody wrote it
