# Parts that nothing else stands on. One that is off is missing in command and Python module alike; the tests need all of them.
option(PARALLEL_ASPECTS_SETUP "Find what a bare URDF leaves open: `aspects setup`, and `describe` without a YAML" ON)
option(PARALLEL_ASPECTS_SWEEP "Vary designs: `aspects sweep`, `merge` and `chart`; `sweep` in Python" ON)

set(all_wings_are_on ON)
foreach(wing IN ITEMS setup sweep)
  string(TOUPPER ${wing} name)
  set(with_${wing} true)
  if(NOT PARALLEL_ASPECTS_${name})
    set(with_${wing} false)
    set(all_wings_are_on OFF)
  endif()
endforeach()
configure_file(cmake/wings.h.in generated/parallel_aspects/model/wings.h)
