# tinyxml2::tinyxml2: from its package configuration where there is one, as on Debian 12, else from header and library,
# as on Ubuntu 20.04 and Debian 11.
include(FindPackageHandleStandardArgs)
find_package(tinyxml2 CONFIG QUIET)
if(TARGET tinyxml2::tinyxml2)
  find_package_handle_standard_args(tinyxml2 CONFIG_MODE)
  return()
endif()

find_path(tinyxml2_INCLUDE_DIR tinyxml2.h)
find_library(tinyxml2_LIBRARY tinyxml2)
mark_as_advanced(tinyxml2_INCLUDE_DIR tinyxml2_LIBRARY)
find_package_handle_standard_args(tinyxml2 REQUIRED_VARS tinyxml2_LIBRARY tinyxml2_INCLUDE_DIR)
if(tinyxml2_FOUND)
  add_library(tinyxml2::tinyxml2 UNKNOWN IMPORTED)
  set_target_properties(tinyxml2::tinyxml2 PROPERTIES IMPORTED_LOCATION "${tinyxml2_LIBRARY}"
                                                      INTERFACE_INCLUDE_DIRECTORIES "${tinyxml2_INCLUDE_DIR}")
endif()
