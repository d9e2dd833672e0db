# Everything that meets ROS: messages, the node classes, nodes, nodelets, programs, rostests,
# install rules.

set(SEMANTIC_SLAM_CATKIN_COMPONENTS
  cv_bridge diagnostic_msgs diagnostic_updater geometry_msgs image_transport nav_msgs nodelet
  pluginlib rosbag roscpp rosgraph_msgs sensor_msgs std_msgs std_srvs tf2 tf2_msgs tf2_ros
  visualization_msgs)
find_package(catkin REQUIRED COMPONENTS message_generation ${SEMANTIC_SLAM_CATKIN_COMPONENTS})

file(GLOB message_files CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/msg msg/*.msg)
file(GLOB service_files CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/srv srv/*.srv)
add_message_files(FILES ${message_files})
add_service_files(FILES ${service_files})
generate_messages(DEPENDENCIES geometry_msgs nav_msgs std_msgs)

# Exported are the messages and the headers. The libraries are this package's own: who wants the core
# in another program adds this repository with SEMANTIC_SLAM_CORE_ONLY and links its rooms.
catkin_package(
  INCLUDE_DIRS src
  CATKIN_DEPENDS message_runtime ${SEMANTIC_SLAM_CATKIN_COMPONENTS})

# Gives `target` the ROS headers (as system headers: their warnings are not ours), ROS libraries and
# our messages.
function(semantic_slam_uses_ros target)
  target_include_directories(${target} SYSTEM PUBLIC ${catkin_INCLUDE_DIRS})
  target_include_directories(${target} SYSTEM PUBLIC
    ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_INCLUDE_DESTINATION})
  target_link_libraries(${target} PUBLIC ${catkin_LIBRARIES})
  add_dependencies(${target} ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
  semantic_slam_compile_options(${target})
endfunction()

# Where there is no simulator, takes what belongs to it out of the list of files of that name.
function(semantic_slam_without_simulator list_name)
  if(NOT TARGET semantic_slam_simulation)
    list(FILTER ${list_name} EXCLUDE REGEX "/(simulator_|render_|draw_world|background_writer)")
  endif()
  set(${list_name} ${${list_name}} PARENT_SCOPE)
endfunction()

# The ROS side as one library: parameters, conversions, node classes.
function(semantic_slam_ros_library)
  file(GLOB sources CONFIGURE_DEPENDS src/semantic_slam_ros/*.cpp)
  semantic_slam_without_simulator(sources)
  add_library(semantic_slam_ros STATIC ${sources})
  target_include_directories(semantic_slam_ros PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/src)
  foreach(room ${SEMANTIC_SLAM_ROOMS})
    target_link_libraries(semantic_slam_ros PUBLIC semantic_slam_${room})
  endforeach()
  semantic_slam_uses_ros(semantic_slam_ros)
endfunction()

# An executable per src/nodes/*.cpp, and all of src/nodelets as one library of plugins.
function(semantic_slam_nodes)
  file(GLOB node_sources CONFIGURE_DEPENDS src/nodes/*.cpp)
  semantic_slam_without_simulator(node_sources)
  foreach(source ${node_sources})
    get_filename_component(node ${source} NAME_WE)
    semantic_slam_executable(${node} ${source})
  endforeach()
  file(GLOB nodelet_sources CONFIGURE_DEPENDS src/nodelets/*.cpp)
  semantic_slam_without_simulator(nodelet_sources)
  if(nodelet_sources)
    add_library(semantic_slam_nodelets SHARED ${nodelet_sources})
    target_link_libraries(semantic_slam_nodelets PRIVATE semantic_slam_ros)
    semantic_slam_compile_options(semantic_slam_nodelets)
    install(TARGETS semantic_slam_nodelets LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  endif()
endfunction()

# A program per src/tools/*.cpp. A source with a header of the same name is shared by all of them.
function(semantic_slam_programs)
  file(GLOB sources CONFIGURE_DEPENDS src/tools/*.cpp)
  semantic_slam_without_simulator(sources)
  set(programs "")
  set(shared "")
  foreach(source ${sources})
    string(REGEX REPLACE "\\.cpp$" ".h" header ${source})
    if(EXISTS ${header})
      list(APPEND shared ${source})
    else()
      list(APPEND programs ${source})
    endif()
  endforeach()
  add_library(semantic_slam_tools STATIC ${shared})
  target_link_libraries(semantic_slam_tools PUBLIC semantic_slam_ros Boost::program_options)
  target_compile_definitions(semantic_slam_tools PRIVATE
    SEMANTIC_SLAM_SOURCE_CONFIG="${CMAKE_CURRENT_SOURCE_DIR}/config")
  semantic_slam_compile_options(semantic_slam_tools)
  foreach(source ${programs})
    get_filename_component(program ${source} NAME_WE)
    semantic_slam_executable(${program} ${source} semantic_slam_tools)
  endforeach()
  # Mappers side by side. Its sources lie with the benchmarks, but it is a program for everyone.
  file(GLOB sources CONFIGURE_DEPENDS benchmark/semantic_octree/*.cpp)
  semantic_slam_executable(semantic_octree_benchmark "${sources}" semantic_slam_tools)
  target_include_directories(semantic_octree_benchmark PRIVATE benchmark)
  # The small textured room that tests use.
  set(room test/testing/render_textured_room_main.cpp)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${room})
    semantic_slam_executable(render_textured_room ${room} semantic_slam_tools semantic_slam_testing)
  endif()
endfunction()

# semantic_slam_executable(NAME SOURCE LIBRARY...) makes and installs one of the package's programs.
function(semantic_slam_executable name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE semantic_slam_ros ${ARGN})
  semantic_slam_compile_options(${name})
  install(TARGETS ${name} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  set_property(GLOBAL APPEND PROPERTY SEMANTIC_SLAM_EXECUTABLES ${name})
endfunction()

function(semantic_slam_install)
  install(DIRECTORY src/semantic_slam/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION}
    FILES_MATCHING PATTERN "*.h")
  install(DIRECTORY src/semantic_slam_ros/
    DESTINATION ${CATKIN_GLOBAL_INCLUDE_DESTINATION}/semantic_slam_ros
    FILES_MATCHING PATTERN "*.h")
  install(PROGRAMS scripts/start_realsense scripts/start_gazebo
    DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  install(DIRECTORY launch config models DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
    PATTERN "*.pt" EXCLUDE)
  install(FILES nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
endfunction()

# The tests in test/ros: X_test.cpp beside X.test is a node that rostest runs, any other X_test.cpp a
# plain one. They may start everything that the package has.
function(semantic_slam_ros_tests)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  find_package(roslaunch REQUIRED)
  find_package(rostest REQUIRED)
  get_property(executables GLOBAL PROPERTY SEMANTIC_SLAM_EXECUTABLES)
  file(GLOB sources CONFIGURE_DEPENDS test/ros/*_test.cpp)
  semantic_slam_without_simulator(sources)
  foreach(source ${sources})
    get_filename_component(target ${source} NAME_WE)
    string(REGEX REPLACE "_test$" ".test" launch_file test/ros/${target})
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${launch_file})
      add_rostest_gtest(${target} ${launch_file} ${source})
    else()
      catkin_add_gtest(${target} ${source})
    endif()
    target_link_libraries(${target} semantic_slam_ros semantic_slam_testing gtest gtest_main)
    target_compile_definitions(${target} PRIVATE
      SEMANTIC_SLAM_SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
      SEMANTIC_SLAM_PROGRAM_DIR="${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION}")
    add_dependencies(${target} ${executables})
    if(TARGET semantic_slam_nodelets)
      add_dependencies(${target} semantic_slam_nodelets)
    endif()
    semantic_slam_compile_options(${target})
  endforeach()
  # The same tests of nodes, started in another way.
  file(GLOB nodelet_tests RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} test/ros/*_nodelet.test)
  semantic_slam_without_simulator(nodelet_tests)
  foreach(nodelet_test ${nodelet_tests})
    string(REGEX REPLACE "^test/ros/(.*)_nodelet.test$" "\\1_node_test" node_test ${nodelet_test})
    add_rostest(${nodelet_test} DEPENDENCIES ${node_test})
  endforeach()
  roslaunch_add_file_check(launch IGNORE_UNSET_ARGS)
endfunction()

function(semantic_slam_ros_targets)
  semantic_slam_ros_library()
  semantic_slam_nodes()
  semantic_slam_programs()
  semantic_slam_install()
  semantic_slam_ros_tests()
endfunction()
