# System packages. Root of a checkout gets what is missing installed; everybody else is told what to install.
# A package written a|b is there when one of the two is: newer Debian releases renamed some.

readonly WINDOW_PACKAGES=("libgtk-3-0t64|libgtk-3-0" fonts-dejavu-core adwaita-icon-theme)
readonly BUILD_PACKAGES=(maven)
readonly DISPLAY_PACKAGES=(xvfb xauth libgl1 libgl1-mesa-dri openbox dbus-x11 xdotool imagemagick x11-utils)
readonly PEER_PACKAGES=(
  python3-pytest python3-pytest-rerunfailures python3-pytest-xdist python3-yaml python3-numpy python3-venv python3-dev bzip2
  python3-roslaunch python3-rostopic python3-rosbag python3-rosservice python3-rosnode python3-rosparam
  python3-sensor-msgs python3-nav-msgs python3-tf2-msgs python3-std-srvs python3-diagnostic-msgs
  python3-actionlib python3-dynamic-reconfigure python3-move-base-msgs
  libroscpp-dev libsensor-msgs-dev libstd-msgs-dev libstd-srvs-dev libnav-msgs-dev libtf2-msgs-dev g++ pkg-config
  liblcm-bin liblcm-dev liblcm-java
  libignition-transport-dev libignition-msgs-dev ignition-transport-cli
  iproute2 procps
)
readonly SCENE_BENCH_PACKAGES=(rviz ros-robot-state-publisher libvisualization-msgs-dev python3-xlib)
# The C library of Cyclone DDS, as a peer on the wire.
readonly CYCLONE_PEER_PACKAGES=(cyclonedds-dev cyclonedds-tools gcc iproute2 python3-venv)
readonly RT_BENCH_PACKAGES=(rt-tests stress-ng libbenchmark-dev)

# need_packages PURPOSE PACKAGE...: fails when something is missing and cannot be installed.
need_packages() {
  local purpose=$1 missing
  shift
  missing=$(missing_packages "$@")
  [[ -n $missing ]] || return 0
  if [[ $(id -u) -ne 0 || -n ${PACKAGED:-} ]]; then
    say "$purpose needs system packages that are not installed. Please run:"
    say "  sudo apt-get install --no-install-recommends $missing"
    return 1
  fi
  install_packages "$purpose" "$missing"
}

missing_packages() {
  command -v dpkg-query >/dev/null || return 0      # not a Debian: nothing can be said about packages
  local installed wanted alternative found missing=()
  installed=" $(dpkg-query -W -f '${Package}:${db:Status-Status} ' 2>/dev/null)"
  for wanted in "$@"; do
    found=
    for alternative in ${wanted//|/ }; do
      [[ $installed == *" $alternative:installed "* ]] && found=yes
    done
    [[ -n $found ]] || missing+=("$(known_alternative "$wanted")")
  done
  printf '%s' "${missing[*]-}"
}

# Of a|b, the one this system's archive offers.
known_alternative() {
  local alternative
  for alternative in ${1//|/ }; do
    is_offered "$alternative" && break
  done
  printf '%s' "$alternative"
}

is_offered() { apt-cache show --no-all-versions "$1" >/dev/null 2>&1; }

install_packages() {
  local purpose=$1 try
  local -a names
  read -ra names <<<"$2"
  mkdir -p "$KEEP"
  say "$purpose: installing ${names[*]}"
  for try in 1 2 3; do
    apt_get update && apt_get install -y --no-install-recommends "${names[@]}" && return 0
    say "  attempt $try did not succeed"
    sleep $((try * 3))
  done
  say "  the end of $KEEP/apt.log:"
  tail -n 5 "$KEEP/apt.log" >&2
  return 1
}

# Another package manager run may hold the lock: wait for it.
apt_get() {
  DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" \
    >>"$KEEP/apt.log" 2>&1 </dev/null
}
