# The entry among the applications of a desktop, by the specification of desktop entries.

cmd_desktop() {
  local base=${XDG_DATA_HOME:-} entry
  [[ $base == /* ]] || base=$HOME/.local/share
  entry=$base/applications/robotui.desktop
  case ${1:-} in
    --remove)
      rm -f "$entry"
      say "RobotUI is no longer among the applications of your desktop."
      ;;
    '')
      mkdir -p "$(dirname "$entry")" && write_entry >"$entry" || fail "$entry cannot be written"
      say "RobotUI is among the applications of your desktop: $entry"
      ;;
    *) usage_error "desktop does not know '$1'" ;;
  esac
}

# The template with the places of this folder: a desktop looks for neither beside the entry. What was unpacked by a single file is started by it.
write_entry() {
  local line
  while IFS= read -r line; do
    case $line in
      Exec=*) printf 'Exec="%s" run\n' "$(in_exec "${ROBOTUI_SINGLE_FILE:-$ROOT/robotui}")" ;;
      Icon=*) printf 'Icon=%s\n' "$ROOT/robotui.svg" ;;
      *) printf '%s\n' "$line" ;;
    esac
  done <"$ROOT/robotui.desktop"
}

# Within the quotes of an Exec line four characters are escaped, after which each backslash is doubled, and a percent sign as well.
in_exec() { sed -e 's/[\\"`$]/\\&/g' -e 's/\\/\\\\/g' -e 's/%/%%/g' <<<"$1"; }
