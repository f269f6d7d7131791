# Benchmarks: each folder of tests/bench with an executable `run` is one.
# A run tells what it does on stderr, and prints one JSON object a line and figure on stdout:
#   {"bench": ..., "figure": ..., "ours": ..., "peer": ..., "peer_name": ..., "ratio": ..., "goal": ..., "holds": ...}

readonly BENCHES=$ROOT/tests/bench
readonly RFIC_BENCHES=(lcm player)   # what robots speak that has no publisher to wait for: together they are "rfic"
readonly LONG_BENCHES=(soak)         # an hour: only where they are named
readonly CHOOSY_BENCHES=(rt scene soak)   # with options of their own

cmd_bench() {
  local names name results failed=()
  names=$(bench_names "${1:-}")
  [[ -n $names ]] || no_bench "${1:-}"
  [[ $# -le 1 || " ${CHOOSY_BENCHES[*]} " == *" $1 "* ]] || usage_error "the benchmark $1 takes no options"
  [[ ${2:-} != --help ]] || exec "$BENCHES/$1/run" --help
  [[ $# -eq 0 ]] || shift
  need_packages "The benchmarks" "${PEER_PACKAGES[@]}" || true
  [[ " $names " != *ros2* ]] || { need_packages "The benchmark ros2" "${CYCLONE_PEER_PACKAGES[@]}" && make_ros2_peers; } || true
  [[ " $names " != *bridge* ]] || { need_packages "The benchmark bridge" topic-tools libroscpp-dev libstd-msgs-dev libsensor-msgs-dev; make_ros2_peers; } || true
  [[ " $names " != *recording* ]] || { need_packages "The benchmark recording" librosbag-dev pluginlib-dev libroscpp-dev libstd-msgs-dev libsensor-msgs-dev; make_ros2_peers; } || true
  [[ $names != *ui* && $names != *scene* && $names != *soak* ]] || need_packages "Benchmarks of the window" "${WINDOW_PACKAGES[@]}" "${DISPLAY_PACKAGES[@]}" || true
  [[ " $names " != *scene* ]] || need_packages "The benchmark scene" "${SCENE_BENCH_PACKAGES[@]}" || true
  need_product
  results=$(mktemp)
  for name in $names; do
    say "Measuring $name"
    run_bench "$name" "$@" >>"$results" || failed+=("$name")
  done
  [[ ! -s $results ]] || /usr/bin/python3 "$ROOT/tools/bench_table.py" <"$results" || failed+=(table)
  rm -f "$results"
  [[ ${#failed[@]} -eq 0 ]] || fail "could not measure: ${failed[*]}"
}

bench_names() {
  local run
  if [[ ${1:-} == rfic ]]; then
    printf '%s\n' "${RFIC_BENCHES[@]}"
    return 0
  fi
  for run in "$BENCHES"/${1:-*}/run; do
    [[ -x $run ]] && bench_name "$run" "${1:-}"
  done
  return 0
}

# bench_name RUN WANTED
bench_name() {
  local name
  name=$(basename "$(dirname "$1")")
  [[ -z $2 && " ${LONG_BENCHES[*]} " == *" $name "* ]] || printf '%s\n' "$name"
}

no_bench() {
  [[ -n $1 ]] || fail "there are no benchmarks (nothing in tests/bench)"
  say "robotui: there is no benchmark '$1'. There are:"
  bench_names '*' | sed 's/^/  /' >&2
  exit 2
}

# NAME [OPTION...], the options being the run's own. One that prints no figure has not measured.
run_bench() {
  local figures name=$1
  shift
  [[ $name != rt ]] || need_native_benches || return 1
  figures=$(cd "$BENCHES/$name" && ROBOTUI_ROOT=$ROOT ROBOTUI_PLUGINS=$HEADLESS_PRODUCT/plugins ROBOTUI_NATIVE=$NATIVE_BUILD \
    ROBOTUI_WINDOW_PRODUCT=$WINDOW_PRODUCT ROBOTUI_SIMULATOR_PATH=$(simulator_classpath) \
    ROBOTUI_RCLPY=$(ros2_peer rclpy) ROBOTUI_CYCLONE=$(ros2_peer cyclone) ROBOTUI_RECORDING_PEERS=$(ros2_peer recordings) \
    ./run "$@" </dev/null) || return 1
  [[ -n $figures ]] && printf '%s\n' "$figures"
}
