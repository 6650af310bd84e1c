# What rviz's plugins are built with. Node and command need neither rviz nor Qt, so that the plugins are left out where
# these are missing.
find_package(rviz QUIET)
find_package(Qt5Widgets QUIET)
if(rviz_FOUND AND Qt5Widgets_FOUND)
  set(rviz_is_found ON)
else()
  set(rviz_is_found OFF)
endif()
option(PARALLEL_ASPECTS_RVIZ "Build the display and the panel for rviz; needs rviz and Qt 5" ${rviz_is_found})
if(PARALLEL_ASPECTS_RVIZ AND NOT rviz_is_found)
  message(FATAL_ERROR "rviz or Qt 5 was not found; install librviz-dev, or set PARALLEL_ASPECTS_RVIZ to OFF.")
endif()
