# What plugins outside of this repository are linked with: found in this build, or where `cmake --install` has put it.
include(CMakePackageConfigHelpers)

if(NOT TARGET rt_testing)
  return()
endif()
set_target_properties(rt_malloc_counter PROPERTIES EXPORT_NAME malloc_counter)
set(exported rt_options rt_link rt_malloc_counter rt_config rt_robot rt_plugin rt_testing)
set(headers link config robot hal plugin plugins/testing)
if(TARGET rt_ros_plugin)
  list(APPEND exported rt_ros_plugin rt_ros_libraries)
  list(APPEND headers ros)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/ros/include/ DESTINATION ${RT_INSTALL_HEADERS}-ros)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/python DESTINATION share/robotui-rt)
  install(DIRECTORY ros/xbot_msgs DESTINATION share/robotui-rt/ros)
endif()

export(TARGETS ${exported} NAMESPACE rt:: FILE ${CMAKE_BINARY_DIR}/robotui-rt-targets.cmake)
file(WRITE ${CMAKE_BINARY_DIR}/robotui-rt-config.cmake
  "set(ROBOTUI_RT_TARGETS ${CMAKE_BINARY_DIR}/robotui-rt-targets.cmake)\ninclude(${CMAKE_CURRENT_SOURCE_DIR}/cmake/robotui-rt-config.cmake)\n")

set(package lib/cmake/robotui-rt)
install(TARGETS ${exported} EXPORT robotui-rt ARCHIVE DESTINATION ${RT_INSTALL_LIBRARIES} OBJECTS DESTINATION ${RT_INSTALL_LIBRARIES})
install(EXPORT robotui-rt NAMESPACE rt:: DESTINATION ${package} FILE robotui-rt-targets.cmake)
foreach(folder ${headers})
  install(DIRECTORY ${folder}/include/ DESTINATION ${RT_INSTALL_HEADERS})
endforeach()
write_basic_package_version_file(${CMAKE_BINARY_DIR}/robotui-rt-config-version.cmake COMPATIBILITY ExactVersion)
install(FILES cmake/robotui-rt-config.cmake cmake/RtDependencies.cmake cmake/RtTargets.cmake
  ${CMAKE_BINARY_DIR}/robotui-rt-config-version.cmake DESTINATION ${package})

# It names the program by its path: that of the installation, which is known when it is made.
install(CODE "set(RT_INSTALLED_PREFIX \"\${CMAKE_INSTALL_PREFIX}\")
  configure_file(\"${CMAKE_SOURCE_DIR}/supervisor/robotui-rt@.service.in\" \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/systemd/user/robotui-rt@.service\" @ONLY)")

install(TARGETS robotui-rt robotui-rt-ctl robotui-rt-new robotui-rt-hal robotui-rt-host robotui-rt-joints robotui-rt-drives RUNTIME DESTINATION bin)
if(TARGET robotui-rt-ros)
  install(TARGETS robotui-rt-ros RUNTIME DESTINATION bin)
endif()
if(TARGET rt_hal_mujoco)
  install(TARGETS rt_hal_mujoco LIBRARY DESTINATION ${RT_INSTALL_LIBRARIES})
  install(FILES ${MUJOCO_LIBRARY} DESTINATION ${RT_INSTALL_LIBRARIES})
  install(FILES ${MUJOCO_ROOT}/LICENSE ${MUJOCO_ROOT}/LICENSES_THIRD_PARTY.md DESTINATION share/robotui-rt/mujoco OPTIONAL)
endif()
if(TARGET rt_hal_gazebo)
  install(TARGETS rt_hal_gazebo LIBRARY DESTINATION ${RT_INSTALL_LIBRARIES})
endif()
