# Starting the product of a folder: with its Java, in a workspace of its own, and again where it asks for that.
# ROBOTUI_MEMORY is how much memory robots and views may take, ROBOTUI_VMARGS are further arguments of the virtual machine.

readonly RESTART=23              # the exit code with which the workbench asks for it
readonly LEAST_MEMORY=512 USUAL_MEMORY=2048   # MB

# launch FOLDER ARGUMENT...: does not come back; what the application answers is the exit code.
launch() {
  local rc home=$1
  shift
  need_state
  trap stop_launched TERM HUP INT
  trap end_launch EXIT
  take_workspace
  vm_arguments "$home" "$@"
  take_configuration "$home"
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

# Where the framework keeps what it has found out about its bundles: beside them, or with the user where many users start what none of them
# may write. Each version has a place of its own; those go that were not started for a season.
take_configuration() {
  local sum place
  framework=()
  [[ ! -w $1/configuration || -e $1/system-package ]] || return 0
  sum=$(cksum <"$1/configuration/org.eclipse.equinox.simpleconfigurator/bundles.info")
  place=$STATE/installed/${sum%% *}
  mkdir -p "$place/configuration"
  touch "$place"
  find "$STATE/installed" -mindepth 1 -maxdepth 1 -mtime +100 -exec rm -rf {} +
  framework=(-configuration "$place/configuration")
}

# How much memory, in MB, Java may take for what robots send and views keep: what the user says, else a quarter of what the machine has,
# between the bounds above (docs/adr/0101).
memory_bound() {
  local there bound
  there=$(machine_memory)
  if [[ -z ${ROBOTUI_MEMORY:-} ]]; then
    bound=$((there / 4))
    bound=$((bound > USUAL_MEMORY ? USUAL_MEMORY : bound))
    printf '%s' $((bound < LEAST_MEMORY ? LEAST_MEMORY : bound))
    return
  fi
  require_memory ROBOTUI_MEMORY "$ROBOTUI_MEMORY"
  bound=${ROBOTUI_MEMORY%?}
  [[ $ROBOTUI_MEMORY == *[mM] ]] || bound=$((bound * 1024))
  [[ $bound -ge 128 ]] || fail "ROBOTUI_MEMORY is $ROBOTUI_MEMORY, and RobotUI does not start with less than 128m"
  [[ $bound -lt $there ]] || fail "ROBOTUI_MEMORY is $ROBOTUI_MEMORY, and this machine has only $there MB"
  printf '%s' "$bound"
}

# In MB: the machine's, or what a container or service may take of it.
machine_memory() {
  local all limit
  all=$(awk '/^MemTotal:/ { print int($2 / 1024) }' /proc/meminfo)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null) || limit=max
  if [[ $limit =~ ^[0-9]+$ && $((limit >> 20)) -lt $all ]]; then
    all=$((limit >> 20))
  fi
  printf '%s' "$all"
}

vm_arguments() {
  local home=$1 line in_vm= memory
  shift
  memory=$(memory_bound) || exit $?
  vm=(
    -Xmx"${memory}m"
    -Declipse.startTime="$(date +%s%3N)"
    -Drobotui.home="$home"
    -Drobotui.state="$STATE"
    -Drobotui.log="$workspace/robotui.log"
    -Drobotui.bundles="$(bundle_folder)"
    -Drobotui.bundles.copies="$workspace/bundles"
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
    -install "$home" -os linux -ws gtk -arch "$(uname -m)" -data "$workspace" "${framework[@]}" "$@" <&0 &
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
