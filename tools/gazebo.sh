# The Gazebo transport, for the HAL of robots that Gazebo simulates: optional, from packages of the system.
readonly NATIVE_GAZEBO_PACKAGES=(libignition-transport-dev libignition-msgs-dev)

have_gazebo() { pkg-config --exists ignition-transport11 2>/dev/null; }

# For a control whose robot is in Gazebo. Without it robotui-rt says that this HAL is not built in.
need_gazebo_for() {
  [[ -z ${ROBOTUI_NATIVE_BUILT:-} ]] || return 0
  names_hal "$1" gazebo || return 0
  have_gazebo || need_packages "A robot in Gazebo" "${NATIVE_GAZEBO_PACKAGES[@]}" || true
}

# Part of what a build is made of: another one is due when the transport was installed since.
gazebo_mark() { if have_gazebo; then printf '%s' gazebo; fi; }
