# Recordings: what is in them, whether they are whole, whole copies of them. No OSGi is needed: the bundles are plain jars.

readonly LOG_JVM=(-XX:+UseSerialGC -XX:TieredStopAtLevel=1 --enable-native-access=ALL-UNNAMED -Dslf4j.internal.verbosity=ERROR)

help_log() {
  cat <<'TEXT'
  ./robotui log info FILE       print what is in a recording (MCAP, bag of ROS 1): times, channels, counts, files, notes
  ./robotui log check FILE      read all of it, and print what is damaged and where. 0: nothing, 1: something, 2: it cannot be read
      --json                    with info and check: one line for programs
  ./robotui log repair FILE NEW    write what can be read of it as a whole MCAP file
  ./robotui log convert FILE NEW   write a bag as MCAP
  ./robotui log cut FILE NEW       write a part of it as MCAP
  ./robotui log merge FILE... NEW  write several as one, by their times
      --from T, --to T          with cut and merge: seconds from the beginning, such as 12.5, or 2026-11-27T10:00:00Z
      --topics NAME,...         with cut and merge: * stands for any part of a name
      --compression C           with all that write: none, lz4 or zstd (default)
TEXT
}

cmd_log() {
  local bundle jar jars=()
  need_product
  for bundle in org.robotui.recording com.github.luben.zstd-jni lz4-java org.apache.commons.commons-compress org.apache.commons.commons-io slf4j.api org.yaml.snakeyaml; do
    jar=$(jar_of "$bundle")
    [[ -n $jar ]] || fail "recordings need the feature 'RobotUI recordings', which is not installed"
    jars+=("$jar")
  done
  exec "$JAVA_HOME/bin/java" "${LOG_JVM[@]}" -cp "$(IFS=:; printf '%s' "${jars[*]}")" org.robotui.recording.internal.tool.LogTool "$@"
}
