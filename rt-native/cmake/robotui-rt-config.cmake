# For plugins outside of this repository: find_package(robotui-rt), then rt_plugin(NAME SOURCES ... TEST ...). They are linked with the
# libraries that lie beside this file or in the build that includes it; the host that loads them is made of the same ones.
if(NOT ROBOTUI_RT_TARGETS)
  set(ROBOTUI_RT_TARGETS ${CMAKE_CURRENT_LIST_DIR}/robotui-rt-targets.cmake)
endif()
set(RT_WERROR OFF CACHE BOOL "warnings are errors")
include(${CMAKE_CURRENT_LIST_DIR}/RtTargets.cmake)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
find_package(Threads REQUIRED)
include(${CMAKE_CURRENT_LIST_DIR}/RtDependencies.cmake)
pkg_check_modules(ROSCPP QUIET IMPORTED_TARGET roscpp std_srvs sensor_msgs geometry_msgs tf2_msgs)  # of plugins that link rt::ros_plugin
include(${ROBOTUI_RT_TARGETS})
