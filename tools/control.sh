# The real-time control that a configuration asks for (`control: FILE`): started before the workbench, ended with it.

readonly CONTROL_SECONDS=15

# The control's configuration that a configuration names; nothing where it names none.
control_of() {
  local named
  named=$(sed -nE "s/^control:[[:space:]]*[\"']?([^\"'#]*[^\"'#[:space:]]).*/\1/p" "$1" | head -n 1)
  [[ -z $named ]] || (cd "$(dirname "$1")" && realpath -m "$named")
}

# Says what the control that a configuration names would lack here.
check_control() {
  local control
  control=$(control_of "$1")
  [[ -z $control ]] || check_hal_for "$control"
}

# One process for each configuration that names one. It runs as well as this user may: what that is, the plugins' view says.
start_controls() {
  local config control
  for config in "$@"; do
    control=$(control_of "$config")
    [[ -n $control ]] || continue
    [[ -r $control ]] || fail "$config names the control $control, which is not there"
    need_hal_for "$control"
    need_native
    start_control "$control"
  done
}

start_control() {
  local log=$LOGS/control.log tries=0
  mkdir -p "$LOGS"
  "$NATIVE_BUILD/bin/robotui-rt" -C "$1" --allow-non-rt >"$log" 2>&1 </dev/null &
  controls+=("$!")
  until grep -q ' cycles\.$' "$log"; do
    if ! kill -0 "${controls[-1]}" 2>/dev/null || ((++tries > CONTROL_SECONDS * 20)); then
      say "robotui: the real-time control of $1 did not start:"
      tail -n 20 "$log" >&2
      exit 1
    fi
    sleep 0.05
  done
  say "The real-time control runs. In another terminal:  ./robotui rt-ctl list"
}

end_controls() {
  local control
  for control in "${controls[@]-}"; do
    [[ -z $control ]] || end_process "$control"
  done
}
