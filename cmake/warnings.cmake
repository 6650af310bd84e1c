# Warnings for our own targets; errors where PARALLEL_ASPECTS_WERROR is on. In a unity build a local name may be that of a
# constant in another source.
function(parallel_aspects_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wnon-virtual-dtor $<$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wshadow>
                                           $<$<BOOL:${PARALLEL_ASPECTS_WERROR}>:-Werror>)
endfunction()
