# Running the workbench, or its headless sister, with a simulated robot beside it where the configuration asks for one.

readonly STATE=${XDG_STATE_HOME:-$HOME/.local/state}/robotui
readonly LIVE_SECONDS=8
readonly DEFAULT_CONFIG=$ROOT/configs/demo.yaml
# Small and quick to start; the same speed as with all compilers.
readonly SIMULATOR_JVM=(-XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xmx128m)

cmd_run() {
  local mode=window stay='' screenshot='' configs=() options=() window_options=()
  parse_run_options "$@"
  [[ ${#configs[@]} -gt 0 ]] || configs=("$(config_path "$DEFAULT_CONFIG")") || exit 2
  mode=$(mode_for_display "$mode" "$screenshot") || exit 2
  case $mode in
    json) options+=(-json) ;;
    window)
      options+=("${window_options[@]}")
      need_packages "The window" "${WINDOW_PACKAGES[@]}" || exit 1
      ;;
  esac
  need_product
  trap end_everything EXIT
  swarm=$(swarm_wanted "${configs[@]}")
  start_simulators "$stay" "$(simulators_wanted "${configs[@]}")"
  start_controls "${configs[@]}"
  run_application "$mode" -config "${configs[@]}" "${options[@]}"
}

# Fills the local variables of cmd_run.
parse_run_options() {
  while [[ $# -gt 0 ]]; do
    case $1 in
      --text) [[ $mode == json ]] || mode=text ;;
      --json) mode=json ;;
      --stay) stay=yes ;;
      --for) require_seconds "$1" "${2:-}"; options+=(-for "$2"); shift ;;
      --after) require_seconds "$1" "${2:-}"; window_options+=(-after "$2"); shift ;;
      --measure)
        [[ -n ${2:-} ]] || usage_error "--measure needs a file"
        window_options+=(-measure "$(realpath -m "$2")")
        shift
        ;;
      --theme) [[ ${2:-} =~ ^(light|dark)$ ]] || usage_error "--theme is light or dark"; window_options+=(-theme "$2"); shift ;;
      --screenshot)
        [[ -n ${2:-} ]] || usage_error "--screenshot needs a file"
        screenshot=$2
        window_options+=(-screenshot "$(realpath -m "$2")")
        shift
        ;;
      -*) usage_error "run does not know '$1'" ;;
      *) configs+=("$(config_path "$1")") || exit 2 ;;
    esac
    shift
  done
}

cmd_check() {
  local config='' live=()
  while [[ $# -gt 0 ]]; do
    case $1 in
      --live) live=(-live "$LIVE_SECONDS") ;;
      -*) usage_error "check does not know '$1'" ;;
      *) [[ -z $config ]] || usage_error "check takes one configuration"
         config=$(config_path "$1") || exit 2 ;;
    esac
    shift
  done
  [[ -n $config ]] || usage_error "check needs a configuration"
  need_product
  trap end_everything EXIT
  swarm=$(swarm_wanted "$config")
  [[ ${#live[@]} -eq 0 ]] || start_simulators '' "$(simulators_wanted "$config")"
  run_application check -application org.robotui.headless.application -check "$config" "${live[@]}"
}

# A file, or the name of one in configs/.
config_path() {
  local file
  for file in "$1" "$ROOT/configs/$1.yaml" "$ROOT/configs/$1/$1.yaml"; do
    if [[ -f $file ]]; then
      realpath "$file"
      return 0
    fi
  done
  say "robotui: there is no configuration '$1'. There are:"
  (cd "$ROOT" && find configs -name '*.yaml' 2>/dev/null | sort | sed 's/^/  /') >&2
  return 1
}

# What the wish for a window (and its picture) comes to on this machine.
mode_for_display() {
  local mode=$1 screenshot=$2
  if [[ $mode != window && -n $screenshot ]]; then
    say "robotui: only a window can have a screenshot: leave out --text and --json"
    return 1
  fi
  if [[ $mode == window && -z ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
    if [[ -n $screenshot ]]; then
      say "robotui: a screenshot needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set."
      say "  A virtual one will do:  xvfb-run -a ./robotui run --screenshot $screenshot"
      return 1
    fi
    say "There is no display (neither DISPLAY nor WAYLAND_DISPLAY is set), so this is the text view."
    say "  For the window: start it from a desktop session, through ssh -X, or under xvfb-run -a ./robotui run"
    mode=text
  fi
  printf '%s' "$mode"
}

# ---- the simulated robots -------------------------------------------------------------------------------------------

simulators=() simulator_dirs=() swarm=

# How many the configuration that wants most asks for: `simulator: mobile-base`, a list of such words, or `{swarm: 50}`.
simulators_wanted() {
  local config
  for config in "$@"; do
    awk '/^simulator:/ { count += gsub(/mobile-base|swarm:/, "") } END { print count + 0 }' "$config"
  done | sort -n | tail -n 1
}

# How many robots the swarm has that a configuration asks for; empty where none does.
swarm_wanted() {
  sed -n 's/^simulator: *{ *swarm: *\([0-9][0-9]*\) *}.*/\1/p' "$@" | sort -n | tail -n 1
}

# Each has a ROS master of its own: that of the first is ROS_MASTER_URI, that of the second ROS_MASTER_URI_2, and so on.
start_simulators() {
  local stay=$1 count=$2 number
  for ((number = 1; number <= count; number++)); do
    start_simulator "$stay" "$number"
  done
  for ((number = 1; number <= count; number++)); do
    await_simulator "$number"
  done
}

start_simulator() {
  local stay=$1 number=$2 out prefix=() options=(--seed "$number")
  out=$(mktemp -d "${TMPDIR:-/tmp}/robotui-sim.XXXXXX")
  simulator_dirs+=("$out")
  : >"$out/out"
  [[ -z $swarm || $number -gt 1 ]] || options+=(--swarm "$swarm")
  if [[ -n $stay ]]; then
    simulator_stays=yes
    prefix=(setsid nohup)
  else
    options+=(--parent $$)          # so that it also ends when this script is killed without a chance to tell
  fi
  "${prefix[@]}" "$JAVA_HOME/bin/java" "${SIMULATOR_JVM[@]}" -cp "$(simulator_classpath)" org.robotui.sim.Main "${options[@]}" \
    >"$out/out" 2>"$out/err" </dev/null &
  simulators+=($!)
}

# The simulator needs no OSGi: the same bundles are plain jars.
simulator_classpath() {
  local bundle jars=()
  for bundle in org.robotui.sim org.robotui.ros org.robotui.geometry slf4j.api; do
    jars+=("$HEADLESS_PRODUCT"/plugins/"$bundle"_*.jar)
  done
  (IFS=:; printf '%s' "${jars[*]}")
}

await_simulator() {
  local number=$1 uri='' tries=0 variable=ROS_MASTER_URI
  local process=${simulators[$1 - 1]} out=${simulator_dirs[$1 - 1]}
  while uri=$(sed -n 's/^ROS_MASTER_URI=//p' "$out/out"); [[ -z $uri ]]; do
    if ! kill -0 "$process" 2>/dev/null || ((++tries > 600)); then
      say "robotui: the simulated robot did not start:"
      tail -n 20 "$out/err" >&2
      exit 1
    fi
    sleep 0.05
  done
  [[ $number -eq 1 ]] || variable+=_$number
  unset ROS_HOSTNAME
  export "$variable=$uri" ROS_IP=127.0.0.1
  if [[ $number -eq 1 ]]; then
    say "The simulated robot speaks ROS here. For rostopic and others:"
  else
    say "Simulated robot $number speaks ROS here (the configuration knows it as $variable):"
  fi
  say "  export ROS_MASTER_URI=$uri ROS_IP=127.0.0.1"
  [[ -z ${simulator_stays:-} ]] || say "  It stays when RobotUI ends. To end it:  kill $process"
}

# ---- the application ------------------------------------------------------------------------------------------------

# Runs in the background and waits: a shell that waits for a foreground child would not hear a signal.
# A check needs no display, but it must know the views of windows, and so their product.
run_application() {
  local product=$HEADLESS_PRODUCT rc=0
  [[ $1 != window && $1 != check ]] || product=$WINDOW_PRODUCT
  shift
  mkdir -p "$STATE"
  "$product/robotui" "$@" <&0 &
  application=$!
  trap 'stop_application 130' INT
  trap 'stop_application 143' TERM HUP
  wait "$application" || rc=$?
  application=
  [[ -z ${stopped_with:-} ]] || rc=$stopped_with
  exit "$rc"
}

stop_application() {
  stopped_with=$1
  [[ -z ${application:-} ]] || end_process "$application"
}

end_everything() {
  trap '' INT TERM HUP
  [[ -z ${application:-} ]] || end_process "$application"
  [[ -n ${simulator_stays:-} ]] || end_simulators
  end_controls
}

end_simulators() {
  local process
  for process in "${simulators[@]}"; do
    end_process "$process"
  done
  rm -rf "${simulator_dirs[@]}"
}

# Politely, and after five seconds not.
end_process() {
  local tries=0
  kill -TERM "$1" 2>/dev/null || return 0
  while kill -0 "$1" 2>/dev/null && ((++tries < 100)); do sleep 0.05; done
  kill -KILL "$1" 2>/dev/null || true
}
