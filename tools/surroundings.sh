# What RobotUI needs of its surroundings: a home, names of files in any language, a folder for what it keeps.

# A service or a container may have no HOME: then it is that of the user.
need_home() {
  [[ -z ${HOME:-} ]] || return 0
  unset HOME
  HOME=~
  export HOME
}

# Java reads names of files by the locale: in one that is not UTF-8, such as C, it cannot open a file with a letter that is not in ASCII.
need_utf8() {
  [[ $(locale charmap 2>/dev/null) != UTF-8 ]] || return 0
  if [[ -n ${LC_ALL:-} ]]; then
    export LANG=$LC_ALL
    unset LC_ALL
  fi
  export LC_CTYPE=C.UTF-8
}

# The folder of this user by the XDG base directories, where only absolute paths count.
state_folder() {
  local base=${XDG_STATE_HOME:-}
  [[ $base == /* ]] || base=$HOME/.local/state
  printf '%s' "$base/robotui"
}

# The folder whose jars are bundles of every RobotUI of this user, likewise.
bundle_folder() {
  local base=${XDG_DATA_HOME:-}
  [[ $base == /* ]] || base=$HOME/.local/share
  printf '%s' "$base/robotui/bundles"
}

# Sets STATE to a folder that can be written, which nobody else may read; and temporary_state where it is only for this run.
need_state() {
  STATE=$(state_folder)
  if make_private "$STATE"; then
    return 0
  fi
  say "robotui: $STATE cannot be written, so that what you change is kept for this run only."
  say "  To keep it, name another folder:  XDG_STATE_HOME=/path/to/folder"
  temporary_state=$(mktemp -d "${TMPDIR:-/tmp}/robotui-state.XXXXXX" 2>/dev/null) || fail "${TMPDIR:-/tmp} cannot be written either: name another folder by TMPDIR"
  STATE=$temporary_state
}

# Also sees a full disk, on which a folder can be made, but no file be written.
make_private() {
  { mkdir -p "$1" && chmod 700 "$1" && echo >"$1/.probe.$$" && rm -f "$1/.probe.$$"; } 2>/dev/null || { rm -f "$1/.probe.$$" 2>/dev/null; return 1; }
}
