# Recordings: what is in them, whether they are whole, copies of them, and their messages for other programs. No OSGi is needed: the bundles are plain jars.

readonly LOG_JVM=(-XX:+UseSerialGC -XX:TieredStopAtLevel=1 --enable-native-access=ALL-UNNAMED -Dslf4j.internal.verbosity=ERROR)

help_log() {
  cat <<'TEXT'
  ./robotui log info FILE       print what is in a recording (MCAP, bag of ROS 1 or 2, log of LCM): times, channels, counts, files, notes
  ./robotui log check FILE      read all of it, and print what is damaged and where. 0: nothing, 1: something, 2: it cannot be read
      --json                    with info and check: one line for programs
  ./robotui log repair FILE NEW    write what can be read of it as a whole MCAP file
  ./robotui log convert FILE NEW   write any recording as MCAP
  ./robotui log cut FILE NEW       write a part of it as MCAP
  ./robotui log merge FILE... NEW  write several as one, by their times
  ./robotui log export FILE --out FOLDER  write its messages for other programs, a file for each topic
      --format F                with export: csv (default) or jsonl
      --from T, --to T          with cut, merge and export: seconds from the beginning, such as 12.5, or 2026-11-27T10:00:00Z
      --topics NAME,...         with cut, merge and export: * stands for any part of a name
      --types PLACE,...         for logs of LCM: files and folders of .lcm files
      --compression C           with all that write recordings: none, lz4 or zstd (default)
TEXT
}

cmd_log() {
  local bundle jar jars=()
  need_product
  for bundle in org.robotui.rfic.recording org.robotui.recording org.robotui.lcm org.robotui.message org.robotui.message.data org.robotui.message.lcm \
    org.robotui.message.payload org.robotui.data org.robotui.geometry org.robotui.net org.robotui.web com.fasterxml.jackson.core.jackson-core com.google.protobuf \
    com.github.luben.zstd-jni lz4-java org.apache.commons.commons-compress org.apache.commons.commons-io slf4j.api org.yaml.snakeyaml; do
    jar=$(jar_of "$bundle")
    [[ -n $jar ]] || fail "recordings need the feature 'RobotUI recordings', which is not installed"
    jars+=("$jar")
  done
  exec "$JAVA_HOME/bin/java" "${LOG_JVM[@]}" -cp "$(IFS=:; printf '%s' "${jars[*]}")" org.robotui.rfic.recording.internal.tool.LogTool "$@"
}
