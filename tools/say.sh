# What is said to the person goes to stderr: stdout is kept for what a command is asked for.

say() { printf '%s\n' "$*" >&2; }

fail() {
  say "robotui: $*"
  exit 1
}

usage_error() {
  say "robotui: $*"
  say "  ./robotui help shows what can be asked."
  exit 2
}

# A number of seconds, as given on the command line.
require_seconds() {
  [[ ${2:-} =~ ^[0-9]+(\.[0-9]+)?$ ]] || usage_error "$1 needs a number of seconds, not '${2:-}'"
}

# A size of memory as Java reads it, such as 4g or 1500m.
require_memory() {
  [[ ${2:-} =~ ^[1-9][0-9]{0,5}[gGmM]$ ]] || usage_error "$1 needs a size such as 4g or 1500m, not '${2:-}'"
}
