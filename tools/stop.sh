# Stopping the robots of all workbenches of this user from outside of them: nothing is built, nothing but a Java is started.

cmd_stop() {
  [[ $# -eq 0 ]] || usage_error "stop takes no arguments"
  local jar net home java=java
  jar=$(jar_of org.robotui.headless 2>/dev/null) || true
  net=$(jar_of org.robotui.net 2>/dev/null) || true
  [[ -n $jar && -n $net ]] || { say "robotui: nothing of this folder runs: it was never built"; exit 4; }
  ! home=$(find_java java) || java=$home/bin/java
  exec "$java" -XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xshare:auto -Xmx32m -cp "$jar:$net" org.robotui.headless.internal.StopMain "$(state_folder)"
}
