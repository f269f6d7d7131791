# Benchmarks: each folder of tests/bench with an executable `run` is one.
# A run tells what it does on stderr, and prints one JSON object a line and figure on stdout:
#   {"bench": ..., "figure": ..., "ours": ..., "peer": ..., "peer_name": ..., "ratio": ..., "goal": ..., "holds": ...}

readonly BENCHES=$ROOT/tests/bench

cmd_bench() {
  [[ $# -le 1 ]] || usage_error "bench takes one name at most"
  local names name results failed=()
  names=$(bench_names "${1:-}")
  [[ -n $names ]] || no_bench "${1:-}"
  need_packages "The benchmarks" "${PEER_PACKAGES[@]}" || true
  need_product
  results=$(mktemp)
  for name in $names; do
    say "Measuring $name"
    run_bench "$name" >>"$results" || failed+=("$name")
  done
  [[ ! -s $results ]] || /usr/bin/python3 "$ROOT/tools/bench_table.py" <"$results" || failed+=(table)
  rm -f "$results"
  [[ ${#failed[@]} -eq 0 ]] || fail "could not measure: ${failed[*]}"
}

bench_names() {
  local run
  for run in "$BENCHES"/${1:-*}/run; do
    [[ -x $run ]] && basename "$(dirname "$run")"
  done
  return 0
}

no_bench() {
  [[ -n $1 ]] || fail "there are no benchmarks (nothing in tests/bench)"
  say "robotui: there is no benchmark '$1'. There are:"
  bench_names | sed 's/^/  /' >&2
  exit 2
}

# One that prints no figure has not measured.
run_bench() {
  local figures
  figures=$(cd "$BENCHES/$1" && ROBOTUI_ROOT=$ROOT ROBOTUI_PLUGINS=$HEADLESS_PRODUCT/plugins ./run </dev/null) || return 1
  [[ -n $figures ]] && printf '%s\n' "$figures"
}
