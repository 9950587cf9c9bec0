# saddle_core: all of src/ but the program's main file, layer by layer. A new source file or layer
# needs no line here. With SADDLE_UNITY the files of a layer are compiled together, UNITY_FILES at a
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
  PUBLIC saddle_needs PRIVATE ${libraries} saddle_kernels saddle_shaders ${CMAKE_DL_LIBS})

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

file(GLOB layers RELATIVE ${CMAKE_SOURCE_DIR}/src CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*)
list(REMOVE_ITEM layers README.md study app mesh)
# Ninja starts with the objects that come first: those that take longest.
foreach(layer study app mesh ${layers})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${layer}/*.cpp)
  list(REMOVE_ITEM sources ${SADDLE_SEPARATE})
  if(layer STREQUAL study)
    # Boost's numbers of 50 digits are half a minute's work for the optimizer.
    set(exact ${sources})
    list(FILTER exact INCLUDE REGEX "/(high_precision|exact_surface|truth)\\.cpp$")
    list(REMOVE_ITEM sources ${exact})
    add_objects(exact ${exact})
    # GCC 12 has false alarms where numbers of 700 digits become ones of 50.
    target_compile_options(saddle_exact PRIVATE -O1 -Wno-array-bounds)
  elseif(layer STREQUAL view AND NOT SADDLE_VIEWER)
    list(FILTER sources EXCLUDE REGEX "/(window|panel|overlay|viewer)\\.cpp$")
  endif()
  add_objects(${layer} ${sources})
  # They compute little: -O3 takes a third longer to compile, and gains nothing measurable.
  if(layer MATCHES "^(app|view)$" AND NOT CMAKE_BUILD_TYPE STREQUAL Debug)
    target_compile_options(saddle_${layer} PRIVATE -O1)
  endif()
endforeach()
target_compile_definitions(saddle_app PRIVATE SADDLE_VERSION="${PROJECT_VERSION}")
if(NOT SADDLE_VIEWER)
  target_compile_definitions(saddle_app PRIVATE SADDLE_WITHOUT_VIEWER)
endif()
