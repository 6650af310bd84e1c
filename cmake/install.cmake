# What an installation holds of the core: headers, library, the `aspects` command and the shipped robots.
set(share_folder ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME})

install(TARGETS parallel_aspects_core
        EXPORT parallel_aspects_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(optional_headers PATTERN ompl EXCLUDE)
if(PARALLEL_ASPECTS_OMPL)
  install(TARGETS parallel_aspects_ompl
          EXPORT parallel_aspects_targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(optional_headers)
endif()
install(TARGETS aspects RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(BUILD_SHARED_LIBS)  # else it is part of the command
  install(TARGETS parallel_aspects_tools LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
if(PARALLEL_ASPECTS_ROS)
  install(DIRECTORY include/parallel_aspects/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION}
          FILES_MATCHING PATTERN "*.h" ${optional_headers})
else()
  install(DIRECTORY include/parallel_aspects DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h" ${optional_headers})
endif()
install(DIRECTORY urdf config DESTINATION ${share_folder})

# In a catkin workspace, catkin writes the package configuration.
if(NOT PARALLEL_ASPECTS_ROS)
  include(CMakePackageConfigHelpers)
  set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})
  set_target_properties(parallel_aspects_core PROPERTIES EXPORT_NAME core)
  if(PARALLEL_ASPECTS_OMPL)
    set_target_properties(parallel_aspects_ompl PROPERTIES EXPORT_NAME ompl)
  endif()
  install(EXPORT parallel_aspects_targets NAMESPACE parallel_aspects:: DESTINATION ${package_folder})
  configure_package_config_file(cmake/config.cmake.in ${PROJECT_BINARY_DIR}/parallel_aspectsConfig.cmake
                                INSTALL_DESTINATION ${package_folder})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/parallel_aspectsConfigVersion.cmake
                                   COMPATIBILITY SameMinorVersion)
  install(FILES cmake/Findtinyxml2.cmake ${PROJECT_BINARY_DIR}/parallel_aspectsConfig.cmake
                ${PROJECT_BINARY_DIR}/parallel_aspectsConfigVersion.cmake
          DESTINATION ${package_folder})
endif()
