# Peers from PyPI, each in a virtual environment of its own: those that speak DDS, which are ROS 2 (rclpy on Fast DDS) and Cyclone DDS for Python, the servers of
# Foxglove's protocol, the present one and its predecessor, readers of recordings, and nodes of a CAN bus (CANopen). Optional, made when wanted.
# rclpy is that of the newest distribution, or of Jazzy where ROBOTUI_ROS2_DISTRO=jazzy says so.
readonly ROS2_DISTRO=${ROBOTUI_ROS2_DISTRO:-}
readonly ROS2_PEERS=$KEEP/ros2-peers${ROS2_DISTRO:+-$ROS2_DISTRO}
if [[ $ROS2_DISTRO == jazzy ]]; then
  readonly RCLPY_PACKAGES=(ros-rclpy==7.1.6 ros-rmw-fastrtps-cpp==8.4.3 ros-{std-msgs,sensor-msgs,nav-msgs,geometry-msgs,std-srvs}==5.3.6)
else
  readonly RCLPY_PACKAGES=(ros-rclpy ros-std-msgs ros-rmw-fastrtps-cpp ros-sensor-msgs ros-nav-msgs ros-geometry-msgs ros-std-srvs)
fi
readonly CYCLONE_PACKAGES=(cyclonedds==11.0.1)
readonly FOXGLOVE_PACKAGES=(foxglove-sdk==0.30.3 foxglove-websocket==0.1.4)
readonly CANOPEN_PACKAGES=(canopen==2.4.1 python-can==4.6.1)
readonly RECORDING_PACKAGES=(mcap==1.6.0 mcap-ros1-support==0.9.0 mcap-ros2-support==0.6.0 rosbags==0.11.9)

# Prints the Python of a peer, rclpy, cyclone, foxglove, recordings or canopen; nothing where it was not made.
ros2_peer() { [[ -e $ROS2_PEERS/$1/ready ]] && printf '%s' "$ROS2_PEERS/$1/bin/python"; }

# About 12 s and 270 MB the first time.
make_ros2_peers() {
  [[ -z $ROS2_DISTRO || $ROS2_DISTRO == jazzy ]] || fail "ROBOTUI_ROS2_DISTRO is '$ROS2_DISTRO', but there are packages of jazzy alone beside those of the newest distribution"
  make_ros2_peer rclpy --no-binary empy "${RCLPY_PACKAGES[@]}" & make_ros2_peer cyclone "${CYCLONE_PACKAGES[@]}"
  wait $!
  make_ros2_peer foxglove "${FOXGLOVE_PACKAGES[@]}" & make_ros2_peer recordings "${RECORDING_PACKAGES[@]}"
  wait $!
  make_ros2_peer canopen "${CANOPEN_PACKAGES[@]}"
  ros2_peer rclpy >/dev/null && make_ros2_interfaces
  ros2_peer rclpy >/dev/null && ros2_peer cyclone >/dev/null && ros2_peer foxglove >/dev/null && ros2_peer recordings >/dev/null && ros2_peer canopen >/dev/null
}

# A network that does not answer may not hold anybody up: the time is bounded.
make_ros2_peer() {
  local name=$1 home=$ROS2_PEERS/$1 python
  shift
  ros2_peer "$name" >/dev/null && [[ $(<"$home/ready") == "$*" ]] && return
  python=$(ros2_python) || return 1
  say "Making the peer $name (once)"
  rm -rf "$home"
  mkdir -p "$ROS2_PEERS"
  "$python" -m venv "$home" >&2 \
    && timeout 300 "$home/bin/python" -m pip install -q --disable-pip-version-check --timeout 15 --retries 2 --only-binary=:all: "$@" >&2 \
    && printf '%s' "$*" >"$home/ready"
}

# There are packages for these versions alone.
ros2_python() {
  local python
  for python in python3.11 python3.12; do
    "$python" -c 'import venv, ensurepip' 2>/dev/null && { command -v "$python"; return; }
  done
  return 1
}

# Actions and markers, which are not on PyPI: about 35 s and a compiler. Tests that need them say that they were skipped without.
make_ros2_interfaces() {
  mkdir -p "$LOGS"
  "$ROOT/tools/ros2-interfaces.sh" "$ROS2_PEERS/rclpy" "$ROOT/bundles/org.robotui.message/src/org/robotui/message/definitions" >"$LOGS/ros2-interfaces.log" 2>&1 \
    || say "  Interfaces of actions and markers could not be made for rclpy (see $LOGS/ros2-interfaces.log)."
}
