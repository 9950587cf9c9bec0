# The evaluator's loops, compiled once for each CPU level; the program picks one when it starts.
# errno and floating point traps are not used: without them floor, sqrt and choices vectorise.
find_library(SADDLE_SLEEF sleef REQUIRED)
set(KERNEL_FLAGS_sse2)
set(KERNEL_FLAGS_sse2_without_fma -DSADDLE_WITHOUT_FMA)
set(KERNEL_FLAGS_avx2 -mavx2 -mfma)
set(KERNEL_FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mfma -mprefer-vector-width=512)
add_library(saddle_kernels INTERFACE)
foreach(level IN ITEMS sse2 sse2_without_fma avx2 avx512)
  add_library(saddle_kernels_${level} OBJECT ${CMAKE_SOURCE_DIR}/src/eval/kernel_loops.cpp)
  target_include_directories(saddle_kernels_${level} PRIVATE ${CMAKE_SOURCE_DIR}/src)
  target_compile_definitions(saddle_kernels_${level} PRIVATE SADDLE_LEVEL=kernels_${level})
  target_compile_options(saddle_kernels_${level} PRIVATE
    -fno-math-errno -fno-trapping-math ${KERNEL_FLAGS_${level}})
  target_link_libraries(saddle_kernels_${level} PRIVATE saddle_options)
  target_sources(saddle_kernels INTERFACE $<TARGET_OBJECTS:saddle_kernels_${level}>)
endforeach()
target_link_libraries(saddle_kernels INTERFACE ${SADDLE_SLEEF})
