#!/usr/bin/env bash
# Generates packages of interfaces that are not on PyPI for an environment of rclpy, of the definitions that RobotUI ships, and builds them.
# Needs gcc, g++ and the headers of its Python. Usage: ros2-interfaces.sh ENVIRONMENT DEFINITIONS
# where DEFINITIONS is the folder 'definitions' of org.robotui.message. Each package is made once.
set -euo pipefail

readonly V=$1 DEFINITIONS=$2
readonly PYTHON=$V/bin/python
# Each package after those that it uses.
readonly PACKAGES=(
  "tf2_msgs msg/TF2Error.msg msg/TFMessage.msg"
  "diagnostic_msgs msg/KeyValue.msg msg/DiagnosticStatus.msg msg/DiagnosticArray.msg"
  "visualization_msgs msg/UVCoordinate.msg msg/MeshFile.msg msg/Marker.msg msg/MarkerArray.msg msg/MenuEntry.msg msg/InteractiveMarkerControl.msg
    msg/InteractiveMarker.msg msg/InteractiveMarkerPose.msg msg/InteractiveMarkerUpdate.msg msg/InteractiveMarkerFeedback.msg srv/GetInteractiveMarkers.srv"
  "nav2_msgs action/NavigateToPose.action"
  "trajectory_msgs msg/JointTrajectoryPoint.msg msg/JointTrajectory.msg msg/MultiDOFJointTrajectoryPoint.msg msg/MultiDOFJointTrajectory.msg"
  "control_msgs msg/JointTolerance.msg msg/JointComponentTolerance.msg action/FollowJointTrajectory.action"
)

main() {
  local package work
  "$PYTHON" -c 'import catkin_pkg' 2>/dev/null || "$PYTHON" -m pip install -q --disable-pip-version-check catkin_pkg
  rm -rf "$V"/lib/python3*/site-packages/rosidl_*.egg-info          # its tool finds each of its parts twice with them
  for package in "${PACKAGES[@]}"; do
    # shellcheck disable=SC2086
    set -- $package
    [[ -e $(site)/$1/made ]] && continue
    work=$(mktemp -d "${TMPDIR:-/tmp}/robotui-interfaces.XXXXXX")
    make_package "$work" "$@" || { rm -rf "$work"; return 1; }
    rm -rf "$work"
    touch "$(site)/$1/made"
  done
}

site() { echo "$V"/lib/python3*/site-packages; }

make_package() {
  local work=$1 name=$2 part
  shift 2
  mkdir -p "$work/source" "$work/inc/$name" "$V/share/$name"
  cp_definitions "$work/source" "$name" "$@" && generate "$work" "$name" "$@" && build "$work/inc/$name" "$work/inc" "$name" || return
  for part in action msg srv; do
    [[ -d $work/source/$part ]] || continue
    mkdir -p "$V/share/$name/$part"
    # The others are needed by packages that use this one.
    cp "$work/source/$part"/* "$work/inc/$name/tmp/$part"/*.idl "$work/inc/$name/$part"/*.json "$V/share/$name/$part/"
  done
  mkdir -p "$V/include/$name"
  cp -r "$work/inc/$name" "$V/include/$name/"
}

# What ROS 2 has changed lies beside what is as in ROS 1; its times and headers have other names.
cp_definitions() {
  local source=$1 name=$2 file from
  shift 2
  printf '<package format="3"><name>%s</name><version>0.0.0</version><description>-</description><maintainer email="a@b.c">-</maintainer><license>-</license></package>' \
    "$name" >"$source/package.xml"
  for file in "$@"; do
    from=$DEFINITIONS/ros2/$name/${file##*/}
    [[ -f $from ]] || from=$DEFINITIONS/$name/${file##*/}
    mkdir -p "$source/${file%/*}"
    sed -E 's/^time /builtin_interfaces\/Time /; s/^duration /builtin_interfaces\/Duration /; s/^Header /std_msgs\/Header /' "$from" >"$source/$file"
  done
}

generate() {
  local work=$1 name=$2 kind
  shift 2
  for kind in "-ts fastrtps_c" "-t c" "-t py" "-ts c"; do
    # shellcheck disable=SC2086
    (cd "$work/source" && AMENT_PREFIX_PATH=$V LD_LIBRARY_PATH=$V/lib "$PYTHON" "$V/bin/rosidl" generate -o "$work/inc/$name" $kind -I "$V/share" "$name" "$@" >"$work/log" 2>&1) \
      || { cat "$work/log" >&2; return 1; }
  done
}

# Each step says by itself where it failed: nothing else ends a function whose caller asks whether it did.
build() {
  local o=$1 inc=$2 name=$3 include link kind package flags=(-shared -fPIC -O1 -w)
  mapfile -t include < <(includes "$inc")
  mapfile -t link < <(libraries "$name")
  gcc "${flags[@]}" "${include[@]}" -o "$V/lib/lib${name}__rosidl_generator_c.so" "$o"/*/detail/*functions.c "$o"/*/detail/*description.c "$o"/*/detail/*type_support.c "${link[@]}" || return
  g++ "${flags[@]}" -std=c++17 "${include[@]}" -o "$V/lib/lib${name}__rosidl_typesupport_fastrtps_c.so" "$o"/*/detail/*_c.cpp "${link[@]}" "-l${name}__rosidl_generator_c" || return
  g++ "${flags[@]}" -std=c++17 "${include[@]}" -o "$V/lib/lib${name}__rosidl_typesupport_c.so" "$o"/*/*type_support.cpp "${link[@]}" "-l${name}__rosidl_generator_c" || return
  gcc "${flags[@]}" "${include[@]}" -o "$V/lib/lib${name}__rosidl_generator_py.so" "$o"/*/_*_s.c "${link[@]}" "-l${name}__rosidl_generator_c" || return
  package=$(site)/$name
  rm -rf "$package"
  mkdir -p "$package"
  touch "$package/__init__.py"
  for kind in "$o"/*/; do
    [[ ! -f $kind/__init__.py ]] || { mkdir -p "$package/$(basename "$kind")"; cp "$kind"/*.py "$package/$(basename "$kind")/"; }
  done
  for kind in typesupport_c typesupport_fastrtps_c; do
    gcc "${flags[@]}" "${include[@]}" -o "$package/${name}_s__rosidl_$kind$("$PYTHON" -c 'import sysconfig; print(sysconfig.get_config_var("EXT_SUFFIX"))')" \
      "$o/_${name}_s.ep.rosidl_$kind.c" "${link[@]}" "-l${name}__rosidl_generator_py" "-l${name}__rosidl_generator_c" "-l${name}__rosidl_$kind" || return
  done
}

includes() {
  local folder
  printf '%s\n' "-I$1" "-I$("$PYTHON" -c 'import sysconfig; print(sysconfig.get_path("include"))')" "-I$("$PYTHON" -c 'import numpy; print(numpy.get_include())')"
  for folder in "$V"/include "$V"/include/*/; do printf -- '-I%s\n' "$folder"; done
}

libraries() {
  local name=$1 package kind
  printf '%s\n' "-L$V/lib" "-Wl,-rpath,$V/lib" -Wl,--unresolved-symbols=ignore-all -Wl,--no-as-needed -lrosidl_runtime_c -lrosidl_typesupport_c \
    -lrosidl_typesupport_fastrtps_c -lrosidl_typesupport_fastrtps_cpp -lfastcdr
  for package in builtin_interfaces unique_identifier_msgs service_msgs action_msgs std_msgs geometry_msgs sensor_msgs trajectory_msgs; do
    for kind in rosidl_generator_c rosidl_typesupport_c rosidl_typesupport_fastrtps_c rosidl_generator_py; do
      [[ $package == "$name" || ! -e $V/lib/lib${package}__$kind.so ]] || printf -- '-l%s__%s\n' "$package" "$kind"
    done
  done
}

main
