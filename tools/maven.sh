# The Maven that can run this build, and how its noise becomes progress.

readonly MAVEN_VERSION=3.9.16
readonly MAVEN=$KEEP/apache-maven-$MAVEN_VERSION

need_maven() {
  [[ -x $MAVEN/bin/mvn ]] || boot_maven
}

# The system's Maven is too old for Tycho, but it can fetch the right one from where it fetches everything else.
boot_maven() {
  command -v mvn >/dev/null || need_packages "The build" "${BUILD_PACKAGES[@]}" || exit 1
  say "Fetching Maven $MAVEN_VERSION (once)"
  mkdir -p "$KEEP"
  local away
  away=$(mktemp -d)         # outside the repository: its .mvn extensions would not load in an old Maven
  if ! (cd "$away" && mvn -B -q org.apache.maven.plugins:maven-dependency-plugin:3.8.1:copy \
      -Dartifact="org.apache.maven:apache-maven:$MAVEN_VERSION:zip:bin" -DoutputDirectory="$away") >"$KEEP/maven-boot.log" 2>&1; then
    say "  the end of $KEEP/maven-boot.log:"
    tail -n 5 "$KEEP/maven-boot.log" >&2
    fail "Maven $MAVEN_VERSION could not be fetched"
  fi
  (cd "$KEEP" && "$JAVA_HOME/bin/jar" xf "$away/apache-maven-$MAVEN_VERSION-bin.zip")
  chmod +x "$MAVEN/bin/mvn"
  rm -rf "$away"
}

# maven LOG ARGUMENT...: one line a module and a class of tests on stderr, two a failed test, everything in LOG, the relevant
# errors at the end.
maven() {
  local log=$1 rc=0
  shift
  mkdir -p "$(dirname "$log")"
  (cd "$ROOT" && "$MAVEN/bin/mvn" -B -ntp -T"${maven_threads:-1}" "$@") </dev/null 2>&1 | tee "$log" | maven_progress >&2 || rc=$?
  [[ $rc -eq 0 ]] || maven_errors "$log"
  return "$rc"
}

maven_progress() {
  awk '
    /^\[INFO\] Building (\[aggregator\]|RobotUI ).*\[[0-9]+\/[0-9]+\]$/ { next }
    /^\[INFO\] Building .*\[[0-9]+\/[0-9]+\]$/ {
      count = $NF; gsub(/[][]/, "", count)
      line = $0; sub(/^\[INFO\] Building (\[[a-z-]+\] )?/, "", line); sub(/ [0-9][^ ]* +\[[0-9\/]+\]$/, "", line)
      printf "  %7s  %s\n", count, line; fflush(); next
    }
    /Tests run:.* -- in / {
      mark = /FAILURE|ERROR/ ? "FAILED " : ""
      name = $0; sub(/.* -- in /, "", name); run = $0; sub(/.*Tests run: /, "", run); sub(/,.*/, "", run)
      printf "           %s%s: %s\n", mark, name, run; fflush(); next
    }
    /-- Time elapsed: .* <<< (FAILURE|ERROR)!$/ {
      name = $0; sub(/^\[ERROR\] /, "", name); sub(/ -- Time elapsed.*/, "", name)
      printf "             %s\n", name; fflush(); why = 1; next
    }
    # A reason of many lines begins on the line after the name of the exception.
    why && /^(\tat |$|\[)/ { why = 0 }
    why { printf "               %s\n", substr($0, 1, 1500); fflush(); if (++why > 12 || why == 2 && !/: $/) why = 0 }'
}

maven_errors() {
  say ""
  grep -aE '^\[ERROR\]' "$1" | sed -e 's/^\[ERROR\] *//' -e "s,$ROOT/,," -e '/\[Help 1\]$/q' | grep -v '^$' | head -n 40 >&2 || true
  say "The whole log: $1"
}
