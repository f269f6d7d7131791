# Finding a Java that is new enough, also where the default java is older: a JDK to build, a runtime is enough to run.

readonly JAVA_WANTED=21
readonly JDK_PACKAGES=(openjdk-25-jdk-headless openjdk-21-jdk-headless temurin-25-jdk temurin-21-jdk)
readonly JRE_PACKAGES=(openjdk-25-jre-headless openjdk-21-jre-headless temurin-25-jre temurin-21-jre)

# Sets and exports JAVA_HOME, or ends with what to install.
need_jdk() {
  local home
  home=$(find_java javac) || home=$(install_jdk) || ask_for_java "a JDK" "${JDK_PACKAGES[@]}"
  export JAVA_HOME=$home
}

need_java() {
  local home
  home=$(find_java java) || ask_for_java "Java" "${JRE_PACKAGES[@]}"
  export JAVA_HOME=$home
}

# The home of the first Java that is new enough and has a program, java or javac.
find_java() {
  local home
  while IFS= read -r home; do
    if is_new_java "$home" "$1"; then
      printf '%s' "$home"
      return 0
    fi
  done < <(java_candidates "$1")
  return 1
}

java_candidates() {
  local program
  [[ -z ${JAVA_HOME:-} ]] || printf '%s\n' "$JAVA_HOME"
  program=$(readlink -f "$(command -v "$1" || true)") && [[ -n $program ]] && dirname "$(dirname "$program")"
  ls -d /usr/lib/jvm/*/ /usr/java/*/ /opt/*jdk*/ /opt/*jre*/ /opt/java/*/ ~/.jdks/*/ ~/.sdkman/candidates/java/*/ 2>/dev/null \
    | sed 's,/$,,' | sort -rV
}

# Reads the release file that every Java has: asking java itself would cost a start.
is_new_java() {
  [[ -x $1/bin/$2 && -r $1/release ]] && [[ $(java_major "$1") -ge $JAVA_WANTED ]]
}

java_major() { sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$1/release"; }

install_jdk() {
  [[ $(id -u) -eq 0 ]] || return 1
  local package
  package=$(offered_package "${JDK_PACKAGES[@]}") || return 1
  install_packages "a JDK >= $JAVA_WANTED" "$package" && find_java javac
}

# The first of these packages that this system's archive has.
offered_package() {
  local package
  command -v apt-cache >/dev/null || return 1
  for package in "$@"; do
    if is_offered "$package"; then
      printf '%s' "$package"
      return 0
    fi
  done
  return 1
}

# ask_for_java WHAT PACKAGE...
ask_for_java() {
  local package what=$1
  shift
  say "robotui: RobotUI needs $what >= $JAVA_WANTED, and none was found (JAVA_HOME, PATH, /usr/lib/jvm, /opt, ~/.jdks)."
  if package=$(offered_package "$@"); then
    say "  Please run:  sudo apt-get install $package"
  else
    say "  This system's archive offers none (Debian 12 ends at 17). On Debian 13 or Ubuntu 24.04 it is:"
    say "    sudo apt-get install ${2}"
    say "  Elsewhere unpack any JDK >= $JAVA_WANTED, such as Eclipse Temurin (adoptium.net), and say where it lies:"
    say "    JAVA_HOME=/path/to/jdk ./robotui"
  fi
  exit 1
}
