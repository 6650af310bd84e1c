# The ROS side of the package as catkin sees it: messages, what is exported, and helpers to install and test.
# Included before any target, since catkin sets where they are built.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(catkin REQUIRED COMPONENTS
  actionlib
  actionlib_msgs
  diagnostic_updater
  dynamic_reconfigure
  geometry_msgs
  message_generation
  nav_msgs
  nodelet
  pluginlib
  roscpp
  sensor_msgs
  std_msgs
  tf2
  tf2_geometry_msgs
  tf2_msgs
  tf2_ros
  trajectory_msgs
  visualization_msgs
)
# Optional: the handle of the probe in rviz.
find_package(interactive_markers QUIET)

add_message_files(FILES
  AssemblyCandidates.msg
  AspectState.msg
  AspectSummary.msg
  AspectTransition.msg
  ChangeOfPosture.msg
  Configuration.msg
  DistanceBounds.msg
  GuardState.msg
  Jacobian.msg
  LargestShape.msg
  LastHazard.msg
  MapProgress.msg
  MetricDistance.msg
  ModeChoice.msg
  ModeConnection.msg
  ProbeState.msg
  RoadmapComponents.msg
  SingularityReport.msg
  SolvedConfiguration.msg
  Status.msg
  TrajectoryEvent.msg
  UniquenessState.msg
)
add_service_files(FILES
  ChooseWorkingMode.srv
  Connect.srv
  CheckTrajectory.srv
  GetCurrentAspect.srv
  GetJacobian.srv
  GetMap.srv
  GetRegularWorkspace.srv
  GetSingularityDistance.srv
  GetWorkingMode.srv
  ListAspects.srv
  Reload.srv
  SetAssemblyMode.srv
)
add_action_files(FILES
  ComputeMap.action
  PlanPath.action
)
generate_dynamic_reconfigure_options(
  cfg/Display.cfg
  cfg/Thresholds.cfg
)
generate_messages(DEPENDENCIES actionlib_msgs geometry_msgs nav_msgs std_msgs trajectory_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${optional_catkin_libraries} parallel_aspects_core parallel_aspects_ros
  CATKIN_DEPENDS
    actionlib
    actionlib_msgs
    diagnostic_updater
    dynamic_reconfigure
    geometry_msgs
    message_runtime
    nav_msgs
    nodelet
    pluginlib
    roscpp
    sensor_msgs
    std_msgs
    tf2
    tf2_geometry_msgs
    tf2_msgs
    tf2_ros
    trajectory_msgs
    visualization_msgs
  DEPENDS EIGEN3 ${optional_catkin_dependencies}
)

# What catkin has added to every source from here on is for those that know ROS: the core is compiled the same with and
# without it, so that what `scripts/aspects` has compiled serves the node too.
get_directory_property(catkin_definitions COMPILE_DEFINITIONS)
get_directory_property(catkin_generated_headers INCLUDE_DIRECTORIES)
set_directory_properties(PROPERTIES COMPILE_DEFINITIONS "" INCLUDE_DIRECTORIES "")
