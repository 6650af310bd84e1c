# Other libraries' headers are parsed once for many sources, which halves the time of a build from nothing. Own headers
# are never among them. The scripts build the libraries without, so that a room that lacks an #include shows.
set(PARALLEL_ASPECTS_PRECOMPILED_HEADERS all CACHE STRING "Whose headers are precompiled: none, tests, all")
set_property(CACHE PARALLEL_ASPECTS_PRECOMPILED_HEADERS PROPERTY STRINGS none tests all)

set(parallel_aspects_common_headers
    <algorithm> <array> <cmath> <cstdint> <cstdio> <functional> <limits> <map> <memory> <optional> <random> <set>
    <sstream> <string> <tuple> <utility> <variant> <vector> <Eigen/Core> <Eigen/Geometry> <Eigen/LU>)

# Lets ccache look into them.
set(parallel_aspects_precompiled_options $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)

# parallel_aspects_precompile(TARGET HEADER...): the common headers, and these, for this target.
function(parallel_aspects_precompile target)
  if(PARALLEL_ASPECTS_PRECOMPILED_HEADERS STREQUAL "all")
    target_precompile_headers(${target} PRIVATE ${parallel_aspects_common_headers} ${ARGN})
    target_compile_options(${target} PRIVATE ${parallel_aspects_precompiled_options})
  endif()
endfunction()

# parallel_aspects_precompile_for_tests(NAME LIBRARY HEADER...): a target that only holds headers, of LIBRARY's users.
function(parallel_aspects_precompile_for_tests name library)
  if(PARALLEL_ASPECTS_PRECOMPILED_HEADERS MATCHES "^(tests|all)$")
    set(nothing ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    file(GENERATE OUTPUT ${nothing} CONTENT "// Holds what is precompiled.\n")
    add_library(${name} OBJECT ${nothing})
    target_link_libraries(${name} PRIVATE ${library} GTest::gtest)
    parallel_aspects_warnings(${name})
    target_precompile_headers(${name} PRIVATE ${parallel_aspects_common_headers} <gtest/gtest.h> ${ARGN})
    target_compile_options(${name} PRIVATE ${parallel_aspects_precompiled_options})
  endif()
endfunction()

# parallel_aspects_reuse_precompiled(TARGET NAME): takes those of NAME, where there are any.
function(parallel_aspects_reuse_precompiled target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
    target_compile_options(${target} PRIVATE ${parallel_aspects_precompiled_options})
  endif()
endfunction()
