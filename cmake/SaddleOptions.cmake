# Compiler settings shared by everything that is ours.
add_library(saddle_options INTERFACE)
target_compile_options(saddle_options INTERFACE
  -Wall -Wextra -Wpedantic
  # Files compiled together see each other's names, and their unnamed namespaces look like a header's.
  $<IF:$<BOOL:${SADDLE_UNITY}>,$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>,-Wshadow>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 sees overlaps where a string gets a literal
  $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-pragmas>  # GCC's
  -ffp-contract=off  # no fused multiply-add behind our back: the same picture on every machine
  -fno-math-errno -fno-trapping-math)  # nobody asks: sqrt is one instruction, min and max are

if(SADDLE_SANITIZE)
  target_compile_options(saddle_options INTERFACE
    -fsanitize=${SADDLE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    # GCC 12's false alarms in instrumented code
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>)
  target_link_options(saddle_options INTERFACE -fsanitize=${SADDLE_SANITIZE})
endif()
