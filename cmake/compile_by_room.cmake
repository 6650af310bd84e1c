# Compiles the sources of a room as one, where PARALLEL_ASPECTS_BY_ROOM is on: half the processor time, most of which goes
# into the headers that they share. Only names of one room can clash. Rooms named after HALVED, which hold one instance for
# each task space, or Eigen's decompositions, are compiled as two, each of every second source, so that no compiler takes much
# more than a gigabyte. Small rooms that match the same of the patterns TOGETHER are compiled as one, since most of their time
# goes into headers; their names can clash as well. Rooms whose names match UNHURRIED are optimized less, as nothing waits for
# them.
function(parallel_aspects_compile_by_room target)
  cmake_parse_arguments(PARSE_ARGV 1 by_room "" "UNHURRIED" "HALVED;TOGETHER")
  if(NOT PARALLEL_ASPECTS_BY_ROOM OR CMAKE_VERSION VERSION_LESS 3.18)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  get_target_property(directory ${target} SOURCE_DIR)
  foreach(listed IN LISTS sources)
    get_filename_component(source "${listed}" ABSOLUTE BASE_DIR "${directory}")
    get_filename_component(room "${source}" DIRECTORY)
    file(RELATIVE_PATH room "${PROJECT_SOURCE_DIR}/src" "${room}")
    if(room IN_LIST by_room_HALVED)
      math(EXPR half_of_${room} "1 - 0${half_of_${room}}")
      string(APPEND room "_${half_of_${room}}")
    endif()
    string(MAKE_C_IDENTIFIER "${room}" room)
    set(group ${room})
    foreach(pattern IN LISTS by_room_TOGETHER)
      if(room MATCHES "^(${pattern})$")
        string(MAKE_C_IDENTIFIER "rooms_${pattern}" group)
      endif()
    endforeach()
    set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
    if(by_room_UNHURRIED AND room MATCHES "${by_room_UNHURRIED}")
      get_target_property(folder ${target} BINARY_DIR)
      set_source_files_properties("${folder}/CMakeFiles/${target}.dir/Unity/unity_${group}_cxx.cxx" TARGET_DIRECTORY ${target}
                                  PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>)
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
