# OMPL's headers and libraries, in OMPL_INCLUDE_DIRS and OMPL_LIBRARIES, and what catkin exports of them.
find_package(ompl QUIET CONFIG)
if(NOT ompl_FOUND)
  message(FATAL_ERROR "OMPL was not found; install libompl-dev, or set PARALLEL_ASPECTS_OMPL to OFF.")
endif()
# The compiler has the one in its order, and the core brings its own Eigen.
list(FILTER OMPL_INCLUDE_DIRS EXCLUDE REGEX "^/usr/include(/eigen3)?$")
set(optional_catkin_libraries parallel_aspects_ompl)
set(optional_catkin_dependencies OMPL)
