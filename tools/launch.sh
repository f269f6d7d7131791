# Starting the product of a folder: with its Java, in a workspace of its own, and again where it asks for that.
# ROBOTUI_VMARGS are further arguments of the virtual machine.

readonly RESTART=23              # the exit code with which the workbench asks for it

# launch FOLDER ARGUMENT...: does not come back; what the application answers is the exit code.
launch() {
  local rc home=$1
  shift
  need_state
  trap stop_launched TERM HUP INT
  trap end_launch EXIT
  take_workspace
  vm_arguments "$home" "$@"
  while :; do
    rc=0
    launch_once "$home" "$@" || rc=$?
    [[ $rc -eq $RESTART ]] || exit "$rc"
  done
}

# Each running instance has a workspace of its own: the first one that nobody holds.
take_workspace() {
  local n=1
  while :; do
    workspace=$STATE/workspace-$n
    mkdir -p "$workspace"
    exec {held}>"$workspace/.held"
    flock -n "$held" && break
    exec {held}>&-
    n=$((n + 1))
  done
  touch "$workspace/robotui.log"
  chmod 600 "$workspace"/robotui.log*
}

vm_arguments() {
  local home=$1 line in_vm=
  shift
  vm=(
    -Declipse.startTime="$(date +%s%3N)"
    -Drobotui.home="$home"
    -Drobotui.state="$STATE"
    -Drobotui.log="$workspace/robotui.log"
    -Dlogback.configurationFile="$home/logback.xml"
    -Djava.util.logging.config.file="$home/logging.properties"
    -Dp2.httpRule=allow
    -XX:ErrorFile="$workspace/crash-%p.log"
    -Xlog:disable                # stdout belongs to the application
    -XX:SharedArchiveFile="$home/classes.jsa"   # loaded classes of an earlier run (archive.sh); without the file merely slower
  )
  # The window's own application starts what lies above level 4 beside the window (docs/adr/0022); others, as the installer's, find all started.
  [[ " $* " == *" -application "* ]] || vm+=(-Dosgi.startLevel=4)
  while IFS= read -r line; do
    [[ $line == -vmargs ]] && { in_vm=yes; continue; }
    [[ -n $in_vm && -n $line ]] && vm+=("$line")
  done <"$home/eclipse.ini"
  # shellcheck disable=SC2206
  vm+=(${ROBOTUI_VMARGS:-})
}

launch_once() {
  local rc=0 home=$1
  shift
  "$JAVA_HOME/bin/java" "${vm[@]}" -jar "$home"/plugins/org.eclipse.equinox.launcher_*.jar \
    -install "$home" -os linux -ws gtk -arch x86_64 -data "$workspace" "$@" <&0 &
  launched=$!
  wait "$launched" || rc=$?
  while kill -0 "$launched" 2>/dev/null; do      # a signal ended the wait, not the application
    rc=0
    wait "$launched" || rc=$?
  done
  return "$rc"
}

stop_launched() { [[ -z ${launched:-} ]] || kill -TERM "$launched" 2>/dev/null || true; }

end_launch() { [[ -z ${temporary_state:-} ]] || rm -rf "$temporary_state"; }
