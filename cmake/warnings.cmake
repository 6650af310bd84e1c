# Warnings for our own targets; errors where PARALLEL_ASPECTS_WERROR is on.
function(parallel_aspects_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
                                           $<$<BOOL:${PARALLEL_ASPECTS_WERROR}>:-Werror>)
endfunction()
