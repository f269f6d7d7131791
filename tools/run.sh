# Running the workbench, or its headless sister, with a simulated robot beside it where the configuration asks for one.

readonly LIVE_SECONDS=8
readonly WINDOW_MACHINE=x86_64    # the toolkit of the window is brought for no other (docs/packages.md)
readonly DEFAULT_CONFIG=$ROOT/configs/natalie-keira.yaml

cmd_run() {
  local mode=window stay='' watch='' screenshot='' configs=() files=() options=() window_options=() text_options=()
  parse_run_options "$@"
  [[ ${#configs[@]} -gt 0 || ${#files[@]} -gt 0 ]] || configs=("$(config_path "$DEFAULT_CONFIG")") || exit 2
  mode=$(mode_for_display "$mode" "$screenshot") || exit 2
  case $mode in
    json) options+=(-json) ;;&
    json | text) options+=("${text_options[@]}"); [[ -z $watch ]] || options+=(-watch) ;;
    window)
      options+=("${window_options[@]}")
      need_packages "The window" "${WINDOW_PACKAGES[@]}" || exit 1
      ;;
  esac
  need_product
  trap end_everything EXIT
  start_simulators "$stay" "${configs[@]}"
  start_controls "${configs[@]}"
  [[ ${#configs[@]} -eq 0 ]] || options+=(-config "${configs[@]}")
  [[ ${#files[@]} -eq 0 ]] || options+=(-open "${files[@]}")
  run_application "$mode" "${options[@]}"
}

# Fills the local variables of cmd_run.
parse_run_options() {
  while [[ $# -gt 0 ]]; do
    case $1 in
      --text) [[ $mode == json ]] || mode=text ;;
      --json) mode=json ;;
      --script)
        [[ -f ${2:-} ]] || usage_error "--script needs a file that is there"
        options+=(-script "$(realpath "$2")")
        shift
        ;;
      --script-socket) options+=(-scriptsocket) ;;
      --stay) stay=yes ;;
      --watch) watch=yes ;;
      --show) [[ -n ${2:-} ]] || usage_error "--show needs the name of a robot UI"; text_options+=(-show "$2"); shift ;;
      --memory) require_memory "$1" "${2:-}"; export ROBOTUI_MEMORY=$2; shift ;;
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
      *)
        if is_recording "$1"; then
          files+=("$(realpath -m "$1")")
        else
          configs+=("$(config_path "$1")") || exit 2
        fi
        ;;
    esac
    shift
  done
}

# A file with an extension that is not that of a configuration, nor the name of one in configs/; a folder of rosbag2, or the file that describes it.
is_recording() {
  [[ -d $1 || ${1##*/} == metadata.yaml ]] && { is_rosbag2 "$1"; return; }
  local name=${1##*/}
  [[ $name == ?*.?* && $name != *.yaml && $name != *.yml && ! -f $ROOT/configs/$1.yaml ]]
}

is_rosbag2() {
  local folder=$1
  [[ -d $1 ]] || folder=$(dirname "$1")
  compgen -G "$folder/metadata.yaml" >/dev/null || compgen -G "$folder/*_0.db3" >/dev/null || compgen -G "$folder/*_0.mcap" >/dev/null
}

cmd_check() {
  local config='' live=() reuse=()
  while [[ $# -gt 0 ]]; do
    case $1 in
      --live) live=(-live "$LIVE_SECONDS") ;;
      --reuse) [[ ${2:-} =~ ^(md|csv)$ ]] || usage_error "--reuse is md or csv"; reuse=(-reuse "$2"); shift ;;
      -*) usage_error "check does not know '$1'" ;;
      *) [[ -z $config ]] || usage_error "check takes one configuration"
         config=$(config_path "$1") || exit 2 ;;
    esac
    shift
  done
  [[ -n $config ]] || usage_error "check needs a configuration"
  check_control "$config"
  need_product
  trap end_everything EXIT
  [[ ${#live[@]} -eq 0 ]] || start_simulators '' "$config"
  run_application check -check "$config" "${live[@]}" "${reuse[@]}"
}

# What configurations can say, from the schemas that judge them.
cmd_words() {
  local options=()
  while [[ $# -gt 0 ]]; do
    case $1 in
      --json) options+=(-json) ;;
      -*) usage_error "words does not know '$1'" ;;
      *) options+=("$1") ;;
    esac
    shift
  done
  need_product
  trap end_everything EXIT
  run_application check -words "${options[@]}"
}

cmd_new() {
  [[ ${1:-} == --* ]] || { cmd_new_sources "$@"; return; }
  local file='' options=()
  while [[ $# -gt 0 ]]; do
    case $1 in
      --name)         # the launcher takes -name for itself
        [[ -n ${2:-} ]] || usage_error "$1 needs a value"
        options+=(-called "$2")
        shift
        ;;
      --rfic | --set | --robot | --ruic | --views | --connect | --wait)
        [[ -n ${2:-} ]] || usage_error "$1 needs a value"
        options+=("-${1#--}" "$2")
        shift
        ;;
      --dry) options+=(-dry) ;;
      -*) usage_error "new does not know '$1'" ;;
      *) [[ -z $file ]] || usage_error "new writes one file"
         file=$(realpath -m "$1") ;;
    esac
    shift
  done
  [[ -n $file ]] || usage_error "new needs a file: one that is not there yet, or a configuration to which the robot is added"
  need_product
  trap end_everything EXIT
  run_application check -new "$file" "${options[@]}"
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
  if [[ $mode == window ]] && ! has_window; then
    [[ -z $screenshot ]] || { say "robotui: this RobotUI has no window that could have a screenshot"; return 1; }
    mode=text
  fi
  if [[ $mode == window && $(uname -m) != "$WINDOW_MACHINE" ]]; then
    [[ -z $screenshot ]] || { say "robotui: the window is for $WINDOW_MACHINE, and this machine is $(uname -m): it has no screenshot"; return 1; }
    say "The window is for $WINDOW_MACHINE, and this machine is $(uname -m), so this is the text view."
    mode=text
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

# The headless product has none.
has_window() { [[ -z ${PACKAGED:-} ]] || compgen -G "$ROOT/plugins/org.robotui.workbench_*.jar" >/dev/null; }

# ---- the application ------------------------------------------------------------------------------------------------

# Runs in the background and waits: a shell that waits for a foreground child would not hear a signal.
# A check needs no display, but it must know the views of windows, and so their product.
run_application() {
  local product=$HEADLESS_PRODUCT rc=0 mode=$1
  shift
  [[ $mode != window && $mode != check ]] || product=$WINDOW_PRODUCT
  [[ $mode == window ]] || set -- -application org.robotui.headless.application "$@"
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

# Politely, and after five seconds not.
end_process() {
  local tries=0
  kill -TERM "$1" 2>/dev/null || return 0
  while kill -0 "$1" 2>/dev/null && ((++tries < 100)); do sleep 0.05; done
  kill -KILL "$1" 2>/dev/null || true
}
