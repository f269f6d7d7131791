# Tests: all runners, one closing line.

readonly E2E=$ROOT/tests/e2e
readonly ENDED_JAVAS=$LOGS/unit-tests-ended.txt      # tools/unit-tests/bin/java writes it

cmd_test() {
  local part=all
  while [[ $# -gt 0 ]]; do
    case $1 in
      --long) export ROBOTUI_LONG=1 ;;
      all | unit | architecture | osgi | native | lint | e2e) part=$1 ;;
      *) usage_error "test knows the parts unit, architecture, osgi, native, lint and e2e, not '$1'" ;;
    esac
    shift
  done
  export ROBOTUI_SHARED=${ROBOTUI_SHARED:-$(realpath -m "$ROOT/../shared")}
  export ROBOTUI_ROOT=$ROOT
  prepare_tests "$part"
  trap 'end_display; end_native' EXIT
  broken=''
  [[ $part != all ]] || begin_native
  [[ $part == e2e || $part == native || $part == lint ]] || test_with_maven "$part"
  [[ $part != lint ]] || test_lint
  [[ $part != all ]] || await_release
  [[ $part != e2e && $part != all ]] || test_end_to_end
  [[ $part != native && $part != all ]] || test_native
  close_tests
}

prepare_tests() {
  [[ $1 != all && $1 != native ]] || fetch_mujoco || say "  MuJoCo could not be fetched: its tests will say that they were skipped."
  [[ $1 != all && $1 != native ]] || need_packages "Tests of the real-time side" "${NATIVE_PACKAGES[@]}" "${NATIVE_ROS_PACKAGES[@]}" || exit 1
  [[ $1 != all && $1 != native ]] || need_packages "Tests of robots in Gazebo" "${NATIVE_GAZEBO_PACKAGES[@]}" \
    || say "  The HAL of robots in Gazebo will not be built: its tests will say that they were skipped."
  [[ $1 != native && $1 != lint ]] || return 0
  need_jdk
  need_maven
  [[ $1 == architecture ]] && return 0
  need_link
  need_packages "Tests against real ROS tools" "${PEER_PACKAGES[@]}" \
    || say "  Tests that need them will say that they were skipped."
  [[ -n ${ROBOTUI_ROS2_PEERS:-} ]] || make_ros2_peers \
    || say "  Peers of ROS 2 and Foxglove could not be fetched: tests against them will say that they were skipped."
  export ROBOTUI_ROS2_PEERS=${ROBOTUI_ROS2_PEERS:-$ROS2_PEERS}
  [[ $1 == unit ]] && return 0
  need_packages "Tests with a window" "${WINDOW_PACKAGES[@]}" "${DISPLAY_PACKAGES[@]}" || exit 1
  start_display
}

# ---- runners --------------------------------------------------------------------------------------------------------

# Each runner gives a test that fails a second try: docs/adr/0042-a-failed-test-has-a-second-try.md.
# Reports of an earlier run must not be counted, nor those of a part that is not asked for.
test_with_maven() {
  local arguments=(-Dmaven.test.failure.ignore=true -Dsurefire.rerunFailingTestsCount=1) stamp=''
  clear_reports
  clear_classes
  clear_test_classes
  case $1 in
    all)          arguments+=(-Dskip.archive=true); rm -f "$STAMP"; stamp=$(source_stamp) ;;
    unit)         arguments+=(-pl "!:org.robotui.product" -Dproduct.only) ;;
    architecture) arguments+=(-pl :org.robotui.architecture.tests) ;;
    osgi)         arguments+=(-pl "!:org.robotui.product" -Dskip.unit=true -Dskip.architecture=true) ;;
  esac
  say "Building and testing ($1)"
  four_at_a_time arguments
  rm -f "$ENDED_JAVAS"
  maven "$LOGS/test.log" verify "${arguments[@]}" || { broken="the build"; say_ended_javas; return 0; }
  # The end-to-end tests run the products that this has made.
  [[ -z $stamp ]] || finish_products "$stamp"
}

# A Java that crashes says why in a file, which a machine that is thrown away takes with it.
say_ended_javas() {
  [[ ! -s $ENDED_JAVAS ]] || cat "$ENDED_JAVAS" >&2
  local crash
  for crash in "$ROOT"/bundles/*/hs_err_pid*.log "$ROOT"/tests/*/hs_err_pid*.log; do
    [[ ! -e $crash ]] || { say "  $crash"; sed -n '/^# *$/d; /^#/p; /^Current thread/,/^$/p; /^Native frames/,/^$/p' "$crash" | head -n 60 >&2; }
  done
}

# Four bundles at a time, as their tests wait most of their time, where each can have a display of its own: docs/adr/0138-tests-run-two-at-a-time.md.
four_at_a_time() {
  local -n more=$1
  [[ -n ${display_processes[*]-} ]] || return 0
  start_more_displays
  maven_threads=4
  export ROBOTUI_TEST_JDK=$JAVA_HOME
  more+=(-Djvm="$ROOT/tools/unit-tests/bin/java")
}

# Tycho compiles changed tests only, and does not see the classes of the unchanged ones beside them.
clear_test_classes() { rm -rf "$ROOT"/bundles/*/target/test-classes; }

# Two files of tests at a time, as most of their time tests wait: docs/adr/0138-tests-run-two-at-a-time.md.
test_end_to_end() {
  if ! ls "$E2E"/test_*.py >/dev/null 2>&1; then
    say "No end-to-end tests: tests/e2e is not there."
    return 0
  fi
  need_product
  say "Testing end to end"
  mkdir -p "$E2E/target"
  [[ $part == all ]] || clear_reports         # else Maven's runner has done so
  start_more_displays
  export ROBOTUI_VMARGS="-XX:TieredStopAtLevel=1 ${ROBOTUI_VMARGS:-}"
  local rc=0 work
  # A short one: the sockets of what is tested lie in it, whose paths have 107 bytes at most.
  work=$(mktemp -d /tmp/e2e.XXXX)
  (cd "$E2E" && /usr/bin/python3 -m pytest -q -p no:cacheprovider -n 2 --dist loadfile --reruns 1 --basetemp="$work" \
    --junitxml=target/TEST-e2e.xml . </dev/null) >&2 || rc=$?
  case $rc in
    0) rm -rf "$work" ;;
    1) say "What the failed tests saw lies in $work" ;;           # the report counts them
    *) broken="${broken:+$broken and }the end-to-end tests" ;;
  esac
}

# ---- a display of our own: tests shall not open windows on anybody's screen -------------------------------------------

# [NAME]: with a window manager and a session bus.
start_display() {
  local out=$KEEP/display${1:-}
  mkdir -p "$out"
  : >"$out/number"
  Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$out/number" >"$out/xvfb.log" 2>&1 &
  display_processes+=("$!")
  await_line "$out/number" || fail "Xvfb did not start: $(tail -n 1 "$out/xvfb.log")"
  DISPLAY=:$(<"$out/number")
  export DISPLAY
  unset WAYLAND_DISPLAY
  export GDK_BACKEND=x11 LIBGL_ALWAYS_SOFTWARE=1 NO_AT_BRIDGE=1
  openbox >"$out/openbox.log" 2>&1 &
  display_processes+=("$!")
  start_session_bus "$out"
}

# Four more, for tests that run side by side: on one display they would take the focus from the windows of each other.
start_more_displays() {
  [[ -z ${ROBOTUI_TEST_DISPLAYS:-} ]] || return 0
  local first=$DISPLAY bus=${DBUS_SESSION_BUS_ADDRESS:-} number
  export ROBOTUI_TEST_DISPLAYS='' ROBOTUI_TEST_BUSES=''
  for number in 2 3 4 5; do
    start_display "$number"
    ROBOTUI_TEST_DISPLAYS+=" $DISPLAY"
    ROBOTUI_TEST_BUSES+=" ${DBUS_SESSION_BUS_ADDRESS:-}"
  done
  export DISPLAY=$first
  [[ -z $bus ]] || export DBUS_SESSION_BUS_ADDRESS=$bus
}

start_session_bus() {
  : >"$1/bus"                   # else the address of an earlier run is taken for that of this one
  dbus-daemon --session --nofork --print-address=3 3>"$1/bus" >"$1/dbus.log" 2>&1 &
  display_processes+=("$!")
  await_line "$1/bus" && DBUS_SESSION_BUS_ADDRESS=$(head -n 1 "$1/bus") && export DBUS_SESSION_BUS_ADDRESS
}

await_line() {
  local tries=0
  until [[ -s $1 ]]; do
    ((++tries < 200)) || return 1
    sleep 0.05
  done
}

end_display() {
  local process
  for process in "${display_processes[@]-}"; do
    [[ -z $process ]] || kill "$process" 2>/dev/null || true
  done
}

# ---- the sum --------------------------------------------------------------------------------------------------------

reports() { find "$ROOT"/bundles "$ROOT"/tests "$ROOT"/rt-native -path '*/target/*' -name 'TEST-*.xml'; }

clear_reports() {
  reports | xargs -r rm -f
  rm -f "$ROOT"/tests/e2e/target/second-tries*.txt "$ROOT"/rt-native/target/second-tries*.txt
}

# Sums one attribute over the <testsuite> elements of all reports; some runners leave out what is zero.
sum_of() {
  reports | xargs -r grep -ho '<testsuite [^>]*>' | { grep -o " $1=\"[0-9]*\"" || true; } | tr -dc '0-9\n' | awk '{ n += $1 } END { print n + 0 }'
}

close_tests() {
  local failed skipped passed
  failed=$(($(sum_of failures) + $(sum_of errors)))
  skipped=$(sum_of skipped)
  passed=$(($(sum_of tests) - failed - skipped))
  list_second_tries
  [[ $failed -eq 0 ]] || list_failures
  [[ -z $broken ]] || say "Could not finish: $broken"
  echo "$passed passed, $failed failed, $skipped skipped"
  [[ -z $broken && $failed -eq 0 && $passed -gt 0 ]]
}

# Maven's runner has them in its reports, the other two leave a file of names.
second_tries() {
  reports | xargs -r awk '
    /<testcase / {
      name = $0; sub(/.* name="/, "", name); sub(/".*/, "", name)
      class = $0; sub(/.* classname="/, "", class); sub(/".*/, "", class)
    }
    /<flaky(Failure|Error)[ >]/ { print class "." name }'
  cat "$ROOT"/tests/e2e/target/second-tries*.txt "$ROOT"/rt-native/target/second-tries*.txt 2>/dev/null || true    # a part leaves some or none
}

list_second_tries() {
  local names
  names=$(second_tries | sort -u)
  [[ -n $names ]] || return 0
  say "Passed at the second try only:"
  sed 's/^/  /' <<<"$names" >&2
}

list_failures() {
  say "Failed:"
  reports | xargs -r awk '
    /<testcase / {
      name = $0; sub(/.* name="/, "", name); sub(/".*/, "", name)
      class = $0; sub(/.* classname="/, "", class); sub(/".*/, "", class)
    }
    /<(failure|error)[ >]/ { print "  " class "." name }' >&2
}
