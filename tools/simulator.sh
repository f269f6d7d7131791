# The simulated robots that a configuration asks for, each a process beside RobotUI.

# Small and quick to start; the same speed as with all compilers.
readonly SIMULATOR_JVM=(-XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xmx128m)

declare -rA SIMULATOR_FEATURES=(
  [org.robotui.sim]='RobotUI demo' [org.robotui.ros]='RobotUI for ROS 1' [org.robotui.ros2]='RobotUI for ROS 2' [org.robotui.player]='RobotUI for Player' [org.robotui.lcm]='RobotUI for LCM'
  [org.robotui.carmen]='RobotUI for CARMEN'
  [org.robotui.yarp]='RobotUI for YARP'
  [org.robotui.smartsoft]='RobotUI for SmartSoft'
  [org.robotui.roblets]='RobotUI for roblets'
  [org.robotui.roboframe]='RobotUI for RoboFrame'
)

simulators=() simulator_dirs=() simulator_stays=
declare -A simulator_variables=()

# What one configuration asks for, a line with options for each robot. `simulator:` is `mobile-base`, `{robot: keira, speaks: player}`,
# `{swarm: 50}`, `boat`, `humanoid`, or a list of these.
simulators_wanted() {
  awk -v config="$1" '
    function fail() {
      print "robotui: " config ": \047simulator\047 has " word "; write mobile-base, {robot: natalie or keira, speaks: ros, ros2, player, lcm, carmen, yarp, smartsoft, roblets or roboframe}," > "/dev/stderr"
      print "  {robot: natalie, speaks: ros2, domain: 42}, {swarm: 50}, boat, humanoid, or a list of these" > "/dev/stderr"
      failed = 1
      exit 2
    }
    function options(map,   robot, speaks, domain, part) {
      robot = "natalie"; speaks = "ros"; domain = ""
      gsub(/[ \t]+/, "", map)
      if (map ~ /^swarm:[0-9]+$/) return "--swarm " substr(map, 7)
      while (map != "") {
        if (!match(map, /^(robot:[a-z]+|speaks:[a-z0-9]+|speaks:\[[a-z0-9,]+\]|domain:[0-9]+)(,|$)/)) fail()
        part = substr(map, 1, RLENGTH); map = substr(map, RLENGTH + 1)
        sub(/,$/, "", part); gsub(/[][]/, "", part)
        if (part ~ /^robot:/) robot = substr(part, 7)
        else if (part ~ /^domain:/) domain = " --domain " substr(part, 8)
        else speaks = substr(part, 8)
      }
      if (robot !~ /^(natalie|keira)$/ || speaks !~ /^((ros2?|player|lcm|carmen|yarp|smartsoft|roblets|roboframe)(,|$))+$/ || (domain != "" && speaks !~ /ros2/)) fail()
      return "--robot " robot " --speak " speaks domain
    }
    /^simulator:/ { on = 1; sub(/^simulator:/, "") }
    on && /^[^ \t#-]/ { on = 0 }
    on { sub(/(^|[ \t])#.*/, ""); text = text " " $0 }
    END {
      if (failed) exit 2
      gsub(/^[ \t[]+|[] \t]+$/, "", text)
      while (text != "") {
        if (match(text, /^[-, \t]+/)) { text = substr(text, RLENGTH + 1); continue }
        word = text
        if (match(text, /^mobile-base/)) print "--robot natalie --speak ros"
        else if (match(text, /^boat/)) print "--boat"
        else if (match(text, /^humanoid/)) print "--humanoid"
        else if (match(text, /^\{[^{}]*\}/)) { word = substr(text, 1, RLENGTH); print options(substr(text, 2, RLENGTH - 2)); match(text, /^\{[^{}]*\}/) }
        else fail()
        text = substr(text, RLENGTH + 1)
      }
    }' "$1"
}

# Starts what the configurations ask for together. The first robot that speaks a framework is where the framework's own variables say
# (ROS_MASTER_URI; ROS_DOMAIN_ID; PLAYER_HOST and PLAYER_PORT; LCM_DEFAULT_URL; CENTRALHOST; YARP_NAMESERVER; SMART_NS_ADDR; ROBLETS_BRAIN; ROBOFRAME_ADDR), the second where ROS_MASTER_URI_2 and so on say.
start_simulators() {
  local stay=$1 config wanted line number options=()
  shift
  for config in "$@"; do
    wanted=$(simulators_wanted "$config") || exit 2
    number=0
    while read -r line; do
      [[ -n $line ]] || continue
      if [[ ${options[number]:-$line} != "$line" ]]; then
        say "robotui: these configurations do not go together: $config wants a simulated robot '$line' where another wants '${options[number]}'"
        exit 2
      fi
      options[number++]=$line
    done <<<"$wanted"
  done
  for ((number = 1; number <= ${#options[@]}; number++)); do
    start_simulator "$stay" "$number" "${options[number - 1]}"
  done
  for ((number = 1; number <= ${#options[@]}; number++)); do
    await_simulator "$number"
  done
}

start_simulator() {
  local stay=$1 number=$2 out prefix=() options=(--seed "$2" --lcm-types "$ROOT/configs/lcm/types" --urdf "$ROOT/configs/humanoid/humanoid.urdf")
  # shellcheck disable=SC2206
  options+=($3)
  need_simulator "$3"
  out=$(mktemp -d "${TMPDIR:-/tmp}/robotui-sim.XXXXXX")
  simulator_dirs+=("$out")
  : >"$out/out"
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

# What a robot with these options consists of may have been taken out of a product.
need_simulator() {
  local bundle word wanted=(org.robotui.sim) words=()
  [[ $1 != *--swarm* ]] || wanted+=(org.robotui.ros)
  [[ $1 != *--boat* ]] || wanted+=(org.robotui.roblets)
  [[ $1 != *--humanoid* ]] || wanted+=(org.robotui.yarp)
  read -ra words <<<"${1//,/ }"
  for word in "${words[@]}"; do
    case $word in
      ros | ros2 | player | lcm | carmen | yarp | smartsoft | roblets | roboframe) wanted+=("org.robotui.$word") ;;
    esac
  done
  for bundle in "${wanted[@]}"; do
    [[ -n $(jar_of "$bundle") ]] || fail "the simulated robot needs the feature '${SIMULATOR_FEATURES[$bundle]}', which is not installed"
  done
}

# The simulator needs no OSGi: the same bundles are plain jars.
simulator_classpath() {
  local bundle jars=()
  for bundle in org.robotui.sim org.robotui.ros org.robotui.ros2 org.robotui.rtps org.robotui.message org.robotui.player org.robotui.lcm org.robotui.carmen org.robotui.net org.robotui.geometry org.robotui.urdf \
    org.robotui.yarp org.robotui.smartsoft org.robotui.roblets org.robotui.roboframe \
    slf4j.api; do
    jars+=("$(jar_of "$bundle")")
  done
  (IFS=:; printf '%s' "${jars[*]}")
}

# The jar of a bundle that the product starts with: others may lie beside it, of what was updated or taken out.
jar_of() {
  awk -F, -v bundle="$1" -v home="$HEADLESS_PRODUCT" '$1 == bundle { print home "/" $3 }' \
    "$HEADLESS_PRODUCT/configuration/org.eclipse.equinox.simpleconfigurator/bundles.info"
}

# It says in one piece by which variables it is found.
await_simulator() {
  local number=$1 line tries=0 process=${simulators[$1 - 1]} out=${simulator_dirs[$1 - 1]}
  while [[ ! -s $out/out ]]; do
    if ! kill -0 "$process" 2>/dev/null || ((++tries > 600)); then
      say "robotui: the simulated robot did not start:"
      tail -n 20 "$out/err" >&2
      exit 1
    fi
    sleep 0.05
  done
  while read -r line; do
    tell_simulator "$number" "${line%%=*}" "${line#*=}"
  done <"$out/out"
  [[ -z $simulator_stays ]] || say "  It stays when RobotUI ends. To end it:  kill $process"
}

# Gives a variable to RobotUI, and tells the user about it.
tell_simulator() {
  local number=$1 name=$2 value=$3 variable=$2 count
  count=$((${simulator_variables[$name]:-0} + 1))
  simulator_variables[$name]=$count
  [[ $count -eq 1 ]] || variable+=_$count
  export "$variable=$value"
  case $name in
    ROS_MASTER_URI)
      unset ROS_HOSTNAME
      export ROS_IP=127.0.0.1
      say_simulator "$number" "$count" ROS rostopic "$variable"
      say "  export ROS_MASTER_URI=$value ROS_IP=127.0.0.1"
      ;;
    ROS_DOMAIN_ID)
      export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
      say_simulator "$number" "$count" "ROS 2" "ros2 topic" "$variable"
      say "  export ROS_DOMAIN_ID=$value ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST"
      ;;
    PLAYER_PORT)
      say_simulator "$number" "$count" Player playerv "$variable"
      say "  export PLAYER_HOST=127.0.0.1 PLAYER_PORT=$value"
      ;;
    LCM_DEFAULT_URL)
      say_simulator "$number" "$count" LCM lcm-spy "$variable"
      [[ $value != tcpq:* ]] || say "  (Multicast does not work on this machine, so messages go through a server of the robot.)"
      say "  export LCM_DEFAULT_URL='$value'"
      ;;
    CENTRALHOST)
      say_simulator "$number" "$count" CARMEN robotgui "$variable"
      say "  export CENTRALHOST=$value"
      ;;
    YARP_NAMESERVER)
      say_simulator "$number" "$count" YARP yarp "$variable"
      say "  yarp conf ${value/:/ }"
      ;;
    SMART_NS_ADDR)
      say_simulator "$number" "$count" SmartSoft components "$variable"
      say "  export SMART_NS_ADDR=$value"
      ;;
    ROBLETS_BRAIN)
      say_simulator "$number" "$count" roblets roblets "$variable"
      say "  export ROBLETS_BRAIN=$value"
      ;;
    ROBOFRAME_ADDR)
      say_simulator "$number" "$count" RoboFrame applications "$variable"
      say "  export ROBOFRAME_ADDR=$value"
      ;;
  esac
}

say_simulator() {
  if [[ $2 -eq 1 ]]; then
    say "The simulated robot speaks $3 here. For $4 and others:"
  else
    say "Simulated robot $1 speaks $3 here (the configuration knows it as $5):"
  fi
}

end_simulators() {
  local process
  for process in "${simulators[@]}"; do
    end_process "$process"
  done
  rm -rf "${simulator_dirs[@]}"
}
