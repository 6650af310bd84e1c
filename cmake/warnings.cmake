# Warnings for our own targets; errors where PARALLEL_ASPECTS_WERROR is on. Where rooms are compiled as one, a local name
# may be that of a constant in another source.
function(parallel_aspects_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wnon-virtual-dtor $<$<NOT:$<BOOL:${PARALLEL_ASPECTS_BY_ROOM}>>:-Wshadow>
                                           $<$<BOOL:${PARALLEL_ASPECTS_WERROR}>:-Werror>)
endfunction()
