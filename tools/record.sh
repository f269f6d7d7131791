# Recording without a window: what robots of any framework send, in files of MCAP.

help_record() {
  cat <<'TEXT'
  ./robotui record CONFIG...    record what the robots send, whatever their frameworks, as MCAP (docs/recordings.md); Ctrl+C ends it, and the file is whole
      --out PLACE               a file that is not there yet, or a folder (usually this one), in which it is named by the time
      --robots NAME  --ports NAME   only these (* and ? stand for any letters; each any number of times)
      --compression C           none, lz4 or zstd (default)
      --split-size SIZE         begin another file then: 500MB, 1GB;  --split-time TIME  30s, 10m, 1h
      --duration TIME           end by itself;  --json  a line for programs each second
                                0: recorded, 1 and 2: no configuration was right, 6: it could not begin, or ended by itself, 130: Ctrl+C
TEXT
}

cmd_record() {
  local configs=() options=() place=.
  while [[ $# -gt 0 ]]; do
    case $1 in
      --json) options+=(-json) ;;
      --out) [[ -n ${2:-} ]] || usage_error "--out needs a file or a folder"; place=$2; shift ;;
      --robots | --ports) [[ -n ${2:-} ]] || usage_error "$1 needs a name"; options+=("-${1#--}" "$2"); shift ;;
      --compression) [[ ${2:-} =~ ^(none|lz4|zstd)$ ]] || usage_error "--compression is none, lz4 or zstd"; options+=(-compression "$2"); shift ;;
      --split-size) options+=(-splitsize "$(bytes_of "$1" "${2:-}")") || exit 2; shift ;;
      --split-time) options+=(-splittime "$(seconds_of "$1" "${2:-}")") || exit 2; shift ;;
      --duration) options+=(-for "$(seconds_of "$1" "${2:-}")") || exit 2; shift ;;
      --show) [[ -n ${2:-} ]] || usage_error "--show needs the name of a robot UI"; options+=(-show "$2"); shift ;;
      -*) usage_error "record does not know '$1'" ;;
      *) configs+=("$(config_path "$1")") || exit 2 ;;
    esac
    shift
  done
  [[ ${#configs[@]} -gt 0 ]] || usage_error "record needs a configuration"
  [[ $place == */ && ! -d $place ]] && fail "the folder $place is not there; make it, or choose another one"
  need_product
  trap end_everything EXIT
  start_simulators '' "${configs[@]}"
  start_controls "${configs[@]}"
  run_application text -config "${configs[@]}" "${options[@]}" -record "$(realpath -m "$place")"
}

# bytes_of OPTION SIZE
bytes_of() {
  [[ $2 =~ ^([0-9]{1,6})(kB|MB|GB|TB)$ ]] || usage_error "$1 needs a size such as 500MB or 1GB, not '$2'"
  case ${BASH_REMATCH[2]} in
    kB) printf '%s' "${BASH_REMATCH[1]}000" ;;
    MB) printf '%s' "${BASH_REMATCH[1]}000000" ;;
    GB) printf '%s' "${BASH_REMATCH[1]}000000000" ;;
    TB) printf '%s' "${BASH_REMATCH[1]}000000000000" ;;
  esac
}

# seconds_of OPTION TIME
seconds_of() {
  [[ $2 =~ ^([0-9]{1,7})(s|m|h)$ ]] || usage_error "$1 needs a time such as 30s, 10m or 1h, not '$2'"
  case ${BASH_REMATCH[2]} in
    s) printf '%s' "${BASH_REMATCH[1]}" ;;
    m) printf '%s' "$((10#${BASH_REMATCH[1]} * 60))" ;;
    h) printf '%s' "$((10#${BASH_REMATCH[1]} * 3600))" ;;
  esac
}
