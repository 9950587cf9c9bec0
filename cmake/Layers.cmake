# saddle_core: all of src/ but the program's main file, folder by folder. A new source file or folder
# needs no line here. With SADDLE_UNITY the files of a folder are compiled together, UNITY_FILES at a
# time: their headers are read once for all of them.
set(UNITY_FILES 18)

# What all of them are compiled with.
add_library(saddle_needs INTERFACE)
target_include_directories(saddle_needs INTERFACE ${CMAKE_SOURCE_DIR}/src)
target_include_directories(saddle_needs SYSTEM INTERFACE ${Boost_INCLUDE_DIRS})
target_link_libraries(saddle_needs INTERFACE saddle_options Threads::Threads)

add_library(saddle_core STATIC)
set_target_properties(saddle_core PROPERTIES LINKER_LANGUAGE CXX)
set(libraries muparser::muparser PNG::PNG ZLIB::ZLIB tomlplusplus::tomlplusplus saddle_gl saddle_font)
if(SADDLE_VIEWER)
  list(APPEND libraries saddle_window)
endif()
target_link_libraries(saddle_core
  PUBLIC saddle_needs PRIVATE ${libraries} saddle_kernels saddle_shaders saddle_page ${CMAKE_DL_LIBS})

# add_objects(NAME SOURCE...): objects of saddle_core.
function(add_objects name)
  add_library(saddle_${name} OBJECT ${ARGN})
  target_link_libraries(saddle_${name} PRIVATE saddle_needs ${libraries})
  if(SADDLE_UNITY)
    set_target_properties(saddle_${name} PROPERTIES
      UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${UNITY_FILES})
  endif()
  target_sources(saddle_core PRIVATE $<TARGET_OBJECTS:saddle_${name}>)
endfunction()

# Every folder of src/ that has sources: a layer, or a room of one.
file(GLOB_RECURSE folders RELATIVE ${CMAKE_SOURCE_DIR}/src CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/src/*.cpp)
list(TRANSFORM folders REPLACE "/[^/]*$" "")
list(REMOVE_DUPLICATES folders)
# Ninja starts with the objects that come first: those that take longest.
list(SORT folders ORDER DESCENDING)
list(REMOVE_ITEM folders study)
foreach(folder study ${folders})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${folder}/*.cpp)
  list(REMOVE_ITEM sources ${SADDLE_SEPARATE})
  if(folder STREQUAL study)
    # Boost's numbers of 50 digits are half a minute's work for the optimizer.
    set(exact ${sources})
    list(FILTER exact INCLUDE REGEX "/(high_precision|exact_surface|truth)\\.cpp$")
    list(REMOVE_ITEM sources ${exact})
    add_objects(exact ${exact})
    # GCC 12 has false alarms where numbers of 700 digits become ones of 50.
    target_compile_options(saddle_exact PRIVATE -O1 -Wno-array-bounds)
  elseif(folder MATCHES "^view/(panel|window)$" AND NOT SADDLE_VIEWER)
    continue()
  endif()
  if(NOT sources)
    continue()
  endif()
  string(REPLACE "/" "_" name ${folder})
  add_objects(${name} ${sources})
  # They compute little: -O3 takes a third longer to compile, and gains nothing measurable.
  if(folder MATCHES "^(app|view)(/|$)" AND NOT CMAKE_BUILD_TYPE STREQUAL Debug)
    target_compile_options(saddle_${name} PRIVATE -O1)
  endif()
endforeach()
target_compile_definitions(saddle_app_command_line PRIVATE SADDLE_VERSION="${PROJECT_VERSION}")
if(NOT SADDLE_VIEWER)
  target_compile_definitions(saddle_app_commands PRIVATE SADDLE_WITHOUT_VIEWER)
endif()
