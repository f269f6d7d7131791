# Recordings: what is in them, whether they are whole, copies of them, and their messages for other programs. No OSGi is needed: the bundles are plain jars.

readonly LOG_JVM=(-XX:+UseSerialGC -XX:TieredStopAtLevel=1 --enable-native-access=ALL-UNNAMED -Dslf4j.internal.verbosity=ERROR)

help_log() {
  cat <<'TEXT'
  ./robotui log info FILE       print what is in a recording (MCAP, bag of ROS 1 or 2, log of LCM, CARMEN or Player): times, channels, counts, files, notes
  ./robotui log check FILE      read all of it, and print what is damaged and where. 0: nothing, 1: something, 2: it cannot be read
      --json                    with info and check: one line for programs
  ./robotui log repair FILE NEW    write what can be read of it as a whole MCAP file
  ./robotui log convert FILE NEW   write any recording as MCAP
  ./robotui log cut FILE NEW       write a part of it as MCAP
  ./robotui log merge FILE... NEW  write several as one, by their times
  ./robotui log export FILE --out FOLDER  write its messages for other programs, a file for each topic
  ./robotui log report FILE --out PAGE.html   write what happened, when messages came or were missing, ways, speeds and pictures as one page for browsers
  ./robotui log find FILE... --where CONDITION  when something was so, such as --where "battery charge < 0.2 for 5 s"; conditions as for alerts
      --json                    with find: a line for programs for each time
  ./robotui log offset A B         how far the clocks of two recordings are apart, by messages that both have or by how the robot turned; --json for programs
  ./robotui log compare A B --topic TOPIC  how far the ways of two recordings are apart (absolute and relative errors of poses), or numbers: --topic "odom linear.x"
      --by time|start|event|way with compare: which times belong together; --event CONDITION, --way TOPIC
      --align none|origin|yaw|se3, --rpe N|Nm, --max-diff S, --offset S, --csv FILE, --json   with compare: see docs/recordings.md
  ./robotui log play FILE          send its messages into ROS 1, ROS 2 or LCM, of which they are, for programs there
      --clock, --rate R, --loop, --delay S, --wait-for-subscribers    with play: say the time on /clock; faster or slower; again and again; wait before the first message
      --format F                with export: csv (default) or jsonl
      --from T, --to T          with cut, merge, export, report, find, compare and play: seconds from the beginning, such as 12.5, or 2026-11-27T10:00:00Z
      --topics NAME,...         with cut, merge, export and play: * stands for any part of a name
      --types PLACE,...         for logs of LCM: files and folders of .lcm files
      --compression C           with all that write recordings: none, lz4 or zstd (default)
TEXT
}

cmd_log() {
  local bundle jar jars=()
  need_product
  for bundle in org.robotui.rfic.recording org.robotui.recording org.robotui.lcm org.robotui.player org.robotui.ros org.robotui.ros2 org.robotui.rtps org.robotui.message org.robotui.message.data org.robotui.message.lcm org.robotui.message.roblets org.robotui.roblets \
    org.robotui.message.payload org.robotui.message.topic org.robotui.condition org.robotui.api org.robotui.data org.robotui.geometry org.robotui.net org.robotui.web com.fasterxml.jackson.core.jackson-core com.google.protobuf \
    com.github.luben.zstd-jni lz4-java org.apache.commons.commons-compress org.apache.commons.commons-io slf4j.api org.yaml.snakeyaml; do
    jar=$(jar_of "$bundle")
    [[ -n $jar ]] || fail "recordings need the feature 'RobotUI recordings', which is not installed"
    jars+=("$jar")
  done
  exec "$JAVA_HOME/bin/java" "${LOG_JVM[@]}" -cp "$(IFS=:; printf '%s' "${jars[*]}")" org.robotui.rfic.recording.internal.tool.LogTool "$@"
}
