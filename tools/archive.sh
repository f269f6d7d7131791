# The archive of loaded classes (docs/adr/0022, 0092): starts of the product that it lies in are quicker, with the Java that made it.

readonly LOADING_SECONDS=6

# archive_classes FOLDER LOADER: keeps the classes of one quiet run as the virtual machine has them in memory. The run only writes their
# names down: an archive written by the run itself, while threads of robots still live, has crashed the virtual machine.
archive_classes() {
  local work rc=0
  work=$(mktemp -d)
  (
    export XDG_STATE_HOME=$work ROBOTUI_VMARGS="-XX:SharedArchiveFile= -XX:DumpLoadedClassList=$work/classes"
    "$2" "$1"
    ROBOTUI_VMARGS="-Xshare:dump -XX:SharedClassListFile=$work/classes -XX:SharedArchiveFile=$work/classes.jsa" "$1/robotui" -nosplash
    mv "$work/classes.jsa" "$1/classes.jsa"
  ) </dev/null || rc=$?
  rm -rf "$work"
  return "$rc"
}

load_by_check() { "$1/robotui" -application org.robotui.headless.application -check "$ROOT/configs/ros.yaml"; }

# The demo in a window that nobody sees; where there is no such display, what can be loaded without one.
load_by_window() {
  if ! command -v xvfb-run >/dev/null; then
    load_by_check "$1"
    return
  fi
  (
    unset WAYLAND_DISPLAY
    export GDK_BACKEND=x11 NO_AT_BRIDGE=1
    trap end_everything EXIT
    start_simulators '' "$ROOT/configs/demo.yaml"
    xvfb-run -a "$1/robotui" -config "$ROOT/configs/demo.yaml" -for "$LOADING_SECONDS"
  )
}

# For a product that was unpacked; a checkout does it at the end of a build.
cmd_archive() {
  local load=load_by_check log
  [[ $# -eq 0 ]] || usage_error "archive takes no arguments"
  [[ -w $ROOT ]] || fail "$ROOT cannot be written: let its owner do this"
  need_java
  ! has_window || load=load_by_window
  say "Keeping the classes of a quiet run (half a minute)"
  log=$(mktemp)
  if ! archive_classes "$ROOT" "$load" >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    rm -f "$log"
    fail "the archive of classes could not be made; RobotUI starts without it"
  fi
  rm -f "$log"
  say "Starts with this Java are quicker from now on."
}
