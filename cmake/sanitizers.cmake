# One build serves the tests under sanitizers and the fuzz targets: Clang's, with what libFuzzer counts by in some rooms.
option(PARALLEL_ASPECTS_SANITIZERS "Build with Address- and UndefinedBehaviorSanitizer, and the fuzz targets; needs Clang" OFF)
if(PARALLEL_ASPECTS_SANITIZERS)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "PARALLEL_ASPECTS_SANITIZERS needs Clang; configure with -DCMAKE_CXX_COMPILER=clang++-14.")
  endif()
  # Eigen takes blocks of empty matrices, which are null and an offset. Null and misaligned pointers and the sizes of objects
  # are AddressSanitizer's and Eigen's to find; asked of every access, they double the build.
  add_compile_options(-O1 -fno-omit-frame-pointer -fsanitize=address,undefined
                      -fno-sanitize=pointer-overflow,null,alignment,object-size -fno-sanitize-recover=all
                      -fsanitize-coverage=inline-8bit-counters,pc-table -fsanitize-coverage-allowlist=${PROJECT_SOURCE_DIR}/cmake/fuzzed_sources.txt)
  # The runtime is shared: programs that were built without are run against these libraries. It is loaded before all others, by
  # LD_PRELOAD.
  add_link_options(-fsanitize=address,undefined -shared-libasan)
endif()
