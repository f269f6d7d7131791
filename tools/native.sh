# The real-time side: built when its sources changed, started, tested, and new plugins for it.

readonly NATIVE=$ROOT/rt-native
readonly NATIVE_BUILD=$NATIVE/target/release
readonly NATIVE_STAMP=$NATIVE/target/release.stamp
readonly RELEASE_READY=$NATIVE/target/release.ready     # beside a test that needs it while the rest is compiled
readonly NATIVE_PACKAGES=(
  cmake make g++ pkg-config libeigen3-dev libyaml-cpp-dev liburdfdom-dev liborocos-kdl-dev libtinyxml2-dev libgtest-dev
)
readonly NATIVE_ROS_PACKAGES=(
  libroscpp-dev libstd-srvs-dev libsensor-msgs-dev libgeometry-msgs-dev libtf2-msgs-dev python3-gencpp python3-genpy
)

# ---- building -----------------------------------------------------------------------------------------------------------

# Builds robotui-rt, unless it is that of the present sources, or a test of a build says that it has made it.
need_native() {
  [[ -z ${ROBOTUI_NATIVE_BUILT:-} ]] || return 0
  is_native_fresh && return 0
  need_packages "Control in real time" "${NATIVE_PACKAGES[@]}" || exit 1
  mkdir -p "$KEEP" "$NATIVE/target"
  exec {native_lock}>"$KEEP/native.lock"
  flock "$native_lock"
  is_native_fresh || build_native {native_lock}>&-
  exec {native_lock}>&-
}

is_native_fresh() { [[ -r $NATIVE_STAMP && -x $NATIVE_BUILD/bin/robotui-rt ]] && [[ $(<"$NATIVE_STAMP") == "$(native_stamp)" ]]; }

# The folder, too: programs know their libraries by absolute paths.
native_stamp() {
  (cd "$NATIVE" && pwd && mujoco_option && gazebo_mark && find . -type f ! -path './target/*' ! -path './tests/*' ! -name '*.md' -printf '%p %s %T@\n' | LC_ALL=C sort | sha256sum)
}

build_native() {
  local stamp targets=() started=$SECONDS
  stamp=$(native_stamp)
  say "Building robotui-rt (the first time some minutes)"
  native_cmake release -DBUILD_TESTING=OFF
  printf '%s' "$stamp" >"$NATIVE_STAMP"
  say "Built in $((SECONDS - started)) s"
}

# Also what its benchmark runs, which needs its peers and google-benchmark.
need_native_benches() {
  local targets=(--target rt_benches)
  need_packages "The benchmark of control in real time" "${RT_BENCH_PACKAGES[@]}" || return 1
  need_native
  say "Building the programs of the benchmark"
  native_cmake release
}

# Configures a preset and builds the caller's `targets` (arguments of the build, none is all); its messages go to a log whose end is shown where it fails.
native_cmake() {
  local preset=$1 log=$LOGS/native-$1.log
  shift
  mkdir -p "$LOGS"
  clear_moved_cmake "$NATIVE/target/$preset"
  if ! (cd "$NATIVE" && cmake --preset "$preset" $(mujoco_option) "$@" && cmake --build --preset "$preset" -j"$(nproc)" "${targets[@]}") >"$log" 2>&1 </dev/null; then
    say "robotui: the real-time side could not be built. The errors in $log:"
    grep -E 'error|Error' "$log" | head -n 20 >&2 || tail -n 20 "$log" >&2
    exit 1
  fi
}

# ---- kinds of HAL that are optional -------------------------------------------------------------------------------------

# FILE TYPE: whether a configuration of a control names this type of HAL, or of model, in any of the ways of YAML: in a block or in braces, in
# quotes or not, in the next line. Who says so of something else fetches what is not needed, and nothing worse.
names_hal() {
  [[ -r $1 ]] && sed -E 's/(^|[[:space:]])#.*//' "$1" | tr '\n' ' ' \
    | grep -qiE "(^|[[:space:]{,])[\"']?(model_)?type[\"']?[[:space:]]*:[[:space:]]*[\"']?$2([\"',}[:space:]]|\$)"
}

need_hal_for() {
  need_mujoco_for "$1"
  need_gazebo_for "$1"
}

# What ./robotui check says of it. MuJoCo is fetched when it is wanted.
check_hal_for() {
  if names_hal "$1" gazebo && ! have_gazebo; then
    say "robotui: $1 has the HAL 'gazebo', which is built where ${NATIVE_GAZEBO_PACKAGES[*]} are installed; here they are not."
  fi
}

# ---- ./robotui rt -------------------------------------------------------------------------------------------------------

cmd_rt() {
  local config=''
  [[ $# -gt 0 ]] || usage_error "rt needs a configuration of a robot's control"
  if [[ $1 != -* ]]; then
    config=$(config_path "$1") || exit 2
    shift
  fi
  need_hal_for "$config"
  need_native
  exec "$NATIVE_BUILD/bin/robotui-rt" ${config:+-C "$config"} "$@"
}

cmd_rt_ctl() {
  need_native
  exec "$NATIVE_BUILD/bin/robotui-rt-ctl" "$@"
}

# ---- ./robotui test native ----------------------------------------------------------------------------------------------

# All tests with address and undefined-behaviour sanitizers, those of link and host also with that for threads, and those of whole
# processes as they are shipped: counters of allocations mean nothing under sanitizers.
test_native() {
  mkdir -p "$NATIVE/target"
  [[ $part == all ]] || clear_reports         # else Maven's runner has done so
  [[ -z ${native_builder:-} ]] || wait "$native_builder" || true       # what failed is tried, and told, again below
  native_format
  native_suite asan ''
  native_suite tsan '^(link|plugin|host|ros)$' rt_thread_tests
  native_suite release ''
}

# Compiles with what the other tests leave of the processors: most of their time they wait. What they need of it comes first. A process group of its own, so that
# it can be ended whole.
begin_native() {
  mkdir -p "$NATIVE/target"
  rm -f "$RELEASE_READY"
  set -m
  (
    renice -n 19 "$BASHPID" >/dev/null
    targets=()
    native_cmake release -DBUILD_TESTING=ON
    touch "$RELEASE_READY"
    native_cmake asan -DBUILD_TESTING=ON
    targets=(--target rt_thread_tests)
    native_cmake tsan -DBUILD_TESTING=ON
  ) </dev/null 2>/dev/null &
  native_builder=$!
  set +m
}

# Until what is shipped is built, or cannot be: then its tests say so.
await_release() {
  while [[ ! -e $RELEASE_READY ]] && kill -0 "$native_builder" 2>/dev/null; do
    sleep 0.5
  done
}

end_native() { [[ -z ${native_builder:-} ]] || kill -- "-$native_builder" 2>/dev/null || true; }

# Seconds. Without clang-format it is a skipped test, and that is said.
native_format() {
  need_packages "Looking at the layout of the C++ sources" clang-format || true
  python3 "$NATIVE/tests/format.py" "$NATIVE/target/TEST-native-format.xml" >&2 || broken="${broken:+$broken and }clang-format"
}

# PRESET FILTER [TARGET...]: a test that fails is counted from its report, one that cannot run at all is said.
native_suite() {
  local preset=$1 filter=$2 report=$NATIVE/target/TEST-native-$1.xml
  local targets=()
  [[ $# -le 2 ]] || targets=(--target "${@:3}")
  say "Building the real-time side ($preset)"
  (native_cmake "$preset" -DBUILD_TESTING=ON) || { broken="${broken:+$broken and }the real-time side ($preset)"; return 0; }
  say "Testing it"
  (cd "$NATIVE" && ctest --preset "$preset" --no-tests=error --repeat until-pass:2 ${filter:+-L "$filter"} --output-junit "$report") >"$LOGS/native-$preset-test.log" 2>&1 </dev/null || true
  if [[ ! -s $report ]]; then
    broken="${broken:+$broken and }the tests of the real-time side ($preset)"
    return 0
  fi
  native_failures "$LOGS/native-$preset-test.log" >&2
  native_second_tries "$LOGS/native-$preset-test.log" "native-$preset" >"$NATIVE/target/second-tries-$preset.txt"
  as_surefire "$report" "native-$preset"
}

# Which tests failed, and the first words of each about why.
native_failures() {
  awk '
    /\*\*\*(Failed|Timeout|Exception)/ { name = $0; sub(/^.*Test +#[0-9]+: /, "", name); sub(/ \.*\*\*\*.*/, "", name); print "  FAILED " name; left = 12 }
    /: Failure$|ERROR: |WARNING: ThreadSanitizer/ && left { show = 4 }
    show && left { print "    " substr($0, 1, 400); show--; left-- }' "$1"
}

# LOG SUITE: the tests that failed and then passed.
native_second_tries() {
  awk -v suite="$2" '
    /Test +#[0-9]+: / {
      name = $0; sub(/^.*Test +#[0-9]+: /, "", name); sub(/ \.\.*.*/, "", name)
      if (/\*\*\*/) failed[name] = 1
      else if (/ Passed / && name in failed) print suite "." name
    }' "$1"
}

# One element a line, as the closing sum reads it, and the name of the suite.
as_surefire() {
  sed -i -E -e ':join' -e '/<testsuite[^>]*$/{N;s/\n[[:space:]]*/ /;b join' -e '}' "$1"
  sed -i -e "s/classname=\"[^\"]*\"/classname=\"$2\"/" "$1"
}

# ---- ./robotui test lint --------------------------------------------------------------------------------------------------

# From nothing it takes some ten minutes of two processors, later what has changed: so it is not among all tests.
test_lint() {
  need_packages "Looking at the real-time side" clang-tidy "${NATIVE_ROS_PACKAGES[@]}" "${NATIVE_GAZEBO_PACKAGES[@]}" || exit 1
  need_native
  clear_reports
  native_format
  say "Looking at the real-time side with clang-tidy"
  python3 "$NATIVE/tests/lint.py" "$NATIVE_BUILD" "$NATIVE/target/TEST-native-lint.xml" >&2 || broken="${broken:+$broken and }clang-tidy"
}

# ---- ./robotui new robot ------------------------------------------------------------------------------------------------

cmd_new_robot() {
  local folder made
  [[ $# -gt 0 && $1 != -* ]] || usage_error "new robot needs the URDF of a robot: ./robotui new robot URDF [SRDF] [--in FOLDER]"
  need_native
  made=$("$NATIVE_BUILD/bin/robotui-rt-new" "$@") || exit $?
  say "$made"
  folder=$(sed -n '1s/^The robot .* is in \(.*\):$/\1/p' <<<"$made")
  say "Run it:  ./robotui run $folder/robot.yaml    or without the workbench:  ./robotui rt $folder/rt-dummy.yaml"
}

# ---- ./robotui new ------------------------------------------------------------------------------------------------------

cmd_new_plugin() {
  local kind=${1:-} name=${2:-} folder=${3:-}
  [[ $name =~ ^[A-Z][A-Za-z0-9]*$ ]] || usage_error "the name of a plugin is that of a class, such as MyControl, not '$name'"
  folder=$(realpath -m "${folder:-$PWD/$name}")
  if [[ -e $folder ]]; then
    say "robotui: $folder is there already; choose another folder."
    exit 1
  fi
  need_native
  write_plugin "$kind" "$name" "$folder"
  say "The plugin $name is in $folder. Build and test it:"
  say "  cmake -S $folder -B $folder/build && cmake --build $folder/build && ctest --test-dir $folder/build"
  say "Run it: name it under $([[ $kind == plugin ]] && echo plugins || echo io_plugins) of a configuration, and"
  say "  ROBOTUI_RT_PLUGINS=$folder/build ./robotui rt CONFIG"
}

write_plugin() {
  local kind=$1 name=$2 folder=$3 file lower
  lower=$(sed -E 's/([a-z0-9])([A-Z])/\1_\2/g' <<<"$name" | tr '[:upper:]' '[:lower:]')
  mkdir -p "$folder"
  for file in "$ROOT/tools/native-templates/$kind"/*; do
    sed -e "s/@Name@/$name/g" -e "s/@name@/$lower/g" -e "s|@native@|$NATIVE|g" "$file" \
      >"$folder/$(basename "$file" .in | sed "s/^plugin/$lower/")"
  done
}
