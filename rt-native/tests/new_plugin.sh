#!/usr/bin/env bash
# What ./robotui new writes must build, pass its own test, and run in a host: new_plugin.sh ROBOTUI BUILD. One is built beside this build, one
# beside what is installed of it and moved elsewhere; both run in the installed control.
set -euo pipefail
robotui=$(realpath "$1")
build=$2
work=$(mktemp -d)
prefix=$work/prefix
control=
trap '[[ -z $control ]] || kill "$control" || true; wait; rm -rf "$work"' EXIT
export ROBOTUI_NATIVE_BUILT=yes XDG_RUNTIME_DIR=$work/run XDG_STATE_HOME=$work
mkdir -m 700 "$XDG_RUNTIME_DIR"

# KIND NAME OPTION: made, built and tested in $work/NAME.
new() {
  "$robotui/robotui" new "$1" "$2" "$work/$2"
  cmake -S "$work/$2" -B "$work/$2/build" "$3"
  cmake --build "$work/$2/build"
  ctest --test-dir "$work/$2/build" --output-on-failure --no-tests=error
}

ask() { "$prefix/bin/robotui-rt-ctl" --name new-plugin "$@" 2>&1 || true; }

# PLUGIN STATE, within a minute.
await() {
  local tries
  for ((tries = 0; tries < 600; ++tries)); do
    [[ $(ask status "$1") != "$2"* ]] || return 0
    sleep 0.1
  done
  echo "$1 is not $2 in the installed robotui-rt: $(ask status "$1")"
  cat "$work/log"
  return 1
}

cmake --install "$build" --prefix "$work/first" >"$work/installed"
mv "$work/first" "$prefix"
unit=lib/systemd/user/robotui-rt@.service
grep -q "^ExecStart=$work/first/bin/robotui-rt -C %E/robotui/rt/%i.yaml$" "$prefix/$unit"
if command -v systemd-analyze >/dev/null; then
  sed "s,$work/first,$prefix," "$prefix/$unit" >"$work/robotui-rt@arm.service"
  said=$(systemd-analyze --user --man=no verify "$work/robotui-rt@arm.service" 2>&1) || true
  [[ $said != *robotui-rt@arm* ]] || { echo "The unit of systemd is not what it should be: $said"; exit 1; }
fi
new plugin MyOwn "-Drobotui-rt_DIR=$build"
new ioplugin MyFace "-DCMAKE_PREFIX_PATH=$prefix"
grep "^robotui-rt_DIR:PATH=$prefix/" "$work/MyFace/build/CMakeCache.txt"
cmake --install "$work/MyFace/build" --prefix "$prefix"

arm=$robotui/configs/arm
cat >"$work/robot.yaml" <<YAML
XBotInterface: {urdf_path: $arm/arm.urdf, srdf_path: $arm/arm.srdf, joint_map_path: $arm/joint_map.yaml}
HALInterface: {type: dummy, misses_before_safe: 1000}
XBotRTPlugins: {plugins: [Homing, MyOwn], io_plugins: [MyFace]}
YAML
ROBOTUI_RT_PLUGINS=$work/MyOwn/build "$prefix/bin/robotui-rt" -C "$work/robot.yaml" --name new-plugin --allow-non-rt 2>"$work/log" &
control=$!
await Homing stopped
await MyOwn stopped
await MyFace running
ask switch MyOwn 1
await MyOwn running
