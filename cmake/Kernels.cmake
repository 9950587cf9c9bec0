# The loops over many numbers, compiled once for each CPU level; the program picks one when it starts.
# errno and floating point traps are not used: without them floor, sqrt and choices vectorise.
find_library(SADDLE_SLEEF sleef REQUIRED)
set(KERNEL_FLAGS_sse2)
set(KERNEL_FLAGS_sse2_without_fma -DSADDLE_WITHOUT_FMA)
set(KERNEL_FLAGS_avx2 -mavx2 -mfma)
set(KERNEL_FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mfma -mprefer-vector-width=512)
add_library(saddle_kernels INTERFACE)

# add_kernel(FILE FUNCTION LEVEL...): src/FILE with SADDLE_LEVEL as FUNCTION_LEVEL.
function(add_kernel file function)
  foreach(level IN LISTS ARGN)
    set(name saddle_${function}_${level})
    add_library(${name} OBJECT ${CMAKE_SOURCE_DIR}/src/${file})
    target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/src)
    target_compile_definitions(${name} PRIVATE SADDLE_LEVEL=${function}_${level})
    target_compile_options(${name} PRIVATE
      -fno-math-errno -fno-trapping-math -funroll-loops ${KERNEL_FLAGS_${level}})
    target_link_libraries(${name} PRIVATE saddle_options)
    target_sources(saddle_kernels INTERFACE $<TARGET_OBJECTS:${name}>)
  endforeach()
  set(SADDLE_SEPARATE ${SADDLE_SEPARATE} ${CMAKE_SOURCE_DIR}/src/${file} PARENT_SCOPE)
endfunction()

add_kernel(eval/kernel_loops.cpp kernels sse2 sse2_without_fma avx2 avx512)
add_kernel(eval/vector_loops.cpp vectors sse2 avx2 avx512)
add_kernel(mesh/grid/cut_cells.cpp cut_cells sse2 avx2 avx512)
add_kernel(mesh/error/estimate_leaves.cpp estimate_leaves sse2 avx2 avx512)
add_kernel(mesh/error/validate_leaves.cpp validate_leaves sse2 avx2 avx512)
target_link_libraries(saddle_kernels INTERFACE ${SADDLE_SLEEF})
