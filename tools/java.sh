# Finding a JDK that is new enough, also where the default java is older.

readonly JAVA_WANTED=21
readonly JDK_PACKAGES=(openjdk-25-jdk-headless openjdk-21-jdk-headless temurin-25-jdk temurin-21-jdk)

# Sets and exports JAVA_HOME, or ends with what to install.
need_jdk() {
  local home
  home=$(find_jdk) || home=$(install_jdk) || ask_for_jdk
  export JAVA_HOME=$home
}

find_jdk() {
  local home
  while IFS= read -r home; do
    if is_new_jdk "$home"; then
      printf '%s' "$home"
      return 0
    fi
  done < <(jdk_candidates)
  return 1
}

jdk_candidates() {
  local javac
  [[ -z ${JAVA_HOME:-} ]] || printf '%s\n' "$JAVA_HOME"
  javac=$(readlink -f "$(command -v javac || true)") && [[ -n $javac ]] && dirname "$(dirname "$javac")"
  ls -d /usr/lib/jvm/*/ /usr/java/*/ /opt/*jdk*/ /opt/java/*/ ~/.jdks/*/ ~/.sdkman/candidates/java/*/ 2>/dev/null \
    | sed 's,/$,,' | sort -rV
}

# Reads the release file that every JDK has: asking java itself would cost a start.
is_new_jdk() {
  [[ -x $1/bin/javac && -r $1/release ]] && [[ $(java_major "$1") -ge $JAVA_WANTED ]]
}

java_major() { sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$1/release"; }

install_jdk() {
  [[ $(id -u) -eq 0 ]] || return 1
  local package
  package=$(offered_jdk_package) || return 1
  install_packages "a JDK >= $JAVA_WANTED" "$package" && find_jdk
}

offered_jdk_package() {
  local package
  command -v apt-cache >/dev/null || return 1
  for package in "${JDK_PACKAGES[@]}"; do
    if is_offered "$package"; then
      printf '%s' "$package"
      return 0
    fi
  done
  return 1
}

ask_for_jdk() {
  local package
  say "robotui: RobotUI needs a JDK >= $JAVA_WANTED, and none was found (JAVA_HOME, PATH, /usr/lib/jvm, /opt, ~/.jdks)."
  if package=$(offered_jdk_package); then
    say "  Please run:  sudo apt-get install $package"
  else
    say "  This system's archive offers none (Debian 12 ends at 17). On Debian 13 or Ubuntu 24.04 it is:"
    say "    sudo apt-get install openjdk-21-jdk-headless"
    say "  Elsewhere unpack any JDK >= $JAVA_WANTED, e.g. Eclipse Temurin, and say where it lies:"
    say "    JAVA_HOME=/path/to/jdk ./robotui"
  fi
  exit 1
}
