#!/bin/sh
# RobotUI in one file: what follows this script is an archive, which is unpacked once into the cache of the user. Everything
# that it is asked for it hands on to what was unpacked; three things are its own:
#   --unpack FOLDER   unpack it there, and start nothing
#   --where           say where it is unpacked when it starts
#   --forget          remove what this and other versions have unpacked
set -eu

name=@NAME@
sum=@SUM@
size=@SIZE@
self=$(readlink -f "$0")

fail() {
  printf 'robotui: %s\n' "$*" >&2
  exit 1
}

[ -n "${HOME:-}" ] || HOME=~
case ${XDG_CACHE_HOME:-} in
  /*) cache=$XDG_CACHE_HOME/robotui ;;
  *) cache=$HOME/.cache/robotui ;;
esac
home=$cache/$name-$sum

payload() { tail -c "$size" "$self"; }

# Beside its place first: what is half unpacked is never started, and two starts at once do no harm.
unpack() {
  [ "$(payload | sha256sum | cut -c 1-64)" = "$sum" ] || fail "$self is damaged: the checksum of what is in it differs; fetch it again"
  mkdir -p "$(dirname "$1")" || fail "$(dirname "$1") cannot be made; name another folder by XDG_CACHE_HOME"
  part=$(mktemp -d "$1.XXXXXX") || fail "$(dirname "$1") cannot be written; name another folder by XDG_CACHE_HOME"
  trap 'rm -rf "$part"' EXIT
  trap 'exit 1' HUP INT TERM
  payload | tar -xzf - -C "$part" --strip-components=1 --no-same-owner || fail "$1 cannot be unpacked"
  chmod 755 "$part"
  mv -T "$part" "$1" 2>/dev/null || [ -x "$1/robotui" ] || fail "$1 cannot be made"
  rm -rf "$part"
  trap - EXIT HUP INT TERM
}

case ${1:-} in
  --unpack)
    [ $# -eq 2 ] || fail "--unpack needs a folder that is not there yet"
    [ ! -e "$2" ] || fail "$2 is there already: --unpack needs a folder that is not there yet"
    unpack "$(readlink -m "$2")"
    exit 0
    ;;
  --where)
    printf '%s\n' "$home"
    exit 0
    ;;
  --forget)
    rm -rf "$cache"
    exit 0
    ;;
esac

if [ ! -x "$home/robotui" ]; then
  printf 'RobotUI unpacks itself into %s (once; --forget removes it).\n' "$home" >&2
  unpack "$home"
fi
ROBOTUI_SINGLE_FILE=$self
export ROBOTUI_SINGLE_FILE
exec "$home/robotui" "$@"
exit
