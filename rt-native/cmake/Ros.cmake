# ROS 1, where it is wanted: the target rt::ros_libraries, and rt_ros_messages() for messages that no package of the system has.
set(RT_ROS AUTO CACHE STRING "the process that shows the robot in ROS: ON, OFF, or AUTO (where ROS 1 is found)")
set(RT_ROS_PACKAGES "libroscpp-dev libstd-srvs-dev libsensor-msgs-dev libgeometry-msgs-dev libtf2-msgs-dev python3-gencpp python3-genpy")
set(RT_ROS_DEFINITIONS ${CMAKE_CURRENT_LIST_DIR}/../../bundles/org.robotui.message/src/org/robotui/message/definitions)

if(RT_ROS)
  pkg_check_modules(ROSCPP QUIET IMPORTED_TARGET roscpp std_srvs sensor_msgs geometry_msgs tf2_msgs)
  find_file(RT_ROS_GENCPP gen_cpp.py PATHS /usr/lib/gencpp /usr/share/gencpp)
  find_file(RT_ROS_GENPY_MESSAGE genmsg_py.py PATHS /usr/lib/genpy)
  find_file(RT_ROS_GENPY_SERVICE gensrv_py.py PATHS /usr/lib/genpy)
  find_path(RT_ROS_TEMPLATES msg.h.template PATHS /usr/share/gencpp /usr/lib/gencpp)
  find_program(RT_ROS_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  mark_as_advanced(RT_ROS_GENCPP RT_ROS_GENPY_MESSAGE RT_ROS_GENPY_SERVICE RT_ROS_TEMPLATES RT_ROS_PYTHON)
  if(ROSCPP_FOUND AND RT_ROS_GENCPP AND RT_ROS_GENPY_MESSAGE AND RT_ROS_GENPY_SERVICE AND RT_ROS_TEMPLATES AND RT_ROS_PYTHON)
    set(RT_ROS_FOUND TRUE)
    message(STATUS "ROS: roscpp ${ROSCPP_roscpp_VERSION}")
  elseif(RT_ROS STREQUAL "AUTO")
    message(STATUS "ROS: not found, so there is no robotui-rt-ros and no robotui/rt/ros (install ${RT_ROS_PACKAGES})")
  else()
    message(FATAL_ERROR "robotui-rt-ros is wanted (RT_ROS=${RT_ROS}) but ROS 1 was not found: install ${RT_ROS_PACKAGES}")
  endif()
endif()

# rt_ros_generate(PACKAGE FILE GENERATOR OUTPUT EXTRA...): one file made from FILE by a generator of ROS.
# RT_ROS_INCLUDED are packages of our definitions that it may name, beside its own and std_msgs.
function(rt_ros_generate package file generator output)
  list(TRANSFORM RT_ROS_INCLUDED REPLACE "(.+)" "-I\\1:${RT_ROS_DEFINITIONS}/\\1" OUTPUT_VARIABLE included)
  get_filename_component(folder ${output} DIRECTORY)
  add_custom_command(OUTPUT ${output} DEPENDS ${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${RT_ROS_PYTHON} ${generator} ${file} -I${package}:${RT_ROS_SOURCE_${package}} -Istd_msgs:${RT_ROS_DEFINITIONS}/std_msgs ${included} -p ${package}
            -o ${folder} ${ARGN}
    COMMENT "Generating ${output}" VERBATIM)
endfunction()

# rt_ros_messages(PACKAGE FOLDER FILE...): a header of each .msg and .srv in ros/include, appended to the list RT_ROS_HEADERS.
function(rt_ros_messages package folder)
  set(RT_ROS_SOURCE_${package} ${folder})
  foreach(file ${ARGN})
    get_filename_component(name ${file} NAME_WE)
    set(header ${CMAKE_CURRENT_BINARY_DIR}/include/${package}/${name}.h)
    rt_ros_generate(${package} ${file} ${RT_ROS_GENCPP} ${header} -e ${RT_ROS_TEMPLATES})
    list(APPEND RT_ROS_HEADERS ${header})
  endforeach()
  set(RT_ROS_HEADERS ${RT_ROS_HEADERS} PARENT_SCOPE)
endfunction()

# rt_ros_copy_for_cxx20(FOLDER): Debian's headers of ROS name allocator::rebind, which C++20 has no more. Those that do are copied with
# the name that newer generators of ROS write; the copies come first where headers are looked for.
function(rt_ros_copy_for_cxx20 folder)
  foreach(package ros std_msgs std_srvs sensor_msgs geometry_msgs tf2_msgs rosgraph_msgs roscpp)
    find_path(RT_ROS_HEADERS_${package} ${package} HINTS ${ROSCPP_INCLUDE_DIRS})
    mark_as_advanced(RT_ROS_HEADERS_${package})
    file(GLOB_RECURSE headers RELATIVE ${RT_ROS_HEADERS_${package}} ${RT_ROS_HEADERS_${package}}/${package}/*.h)
    foreach(header ${headers})
      file(READ ${RT_ROS_HEADERS_${package}}/${header} text)
      string(REPLACE "typename ContainerAllocator::template rebind<" "typename std::allocator_traits<ContainerAllocator>::template rebind_alloc<" newer "${text}")
      if(NOT newer STREQUAL text)
        string(REPLACE ">::other" ">" newer "${newer}")
        string(REGEX REPLACE "#include \"([A-Za-z0-9_]+\\.h)\"" "#include <${package}/\\1>" newer "${newer}")
        file(CONFIGURE OUTPUT ${folder}/${header} CONTENT "${newer}" @ONLY)
      endif()
    endforeach()
  endforeach()
endfunction()
