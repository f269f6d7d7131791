# Bridges without a window: what robots say, carried to other robots, whatever their frameworks.

help_bridge() {
  cat <<'TEXT'
  ./robotui bridge CONFIG...    carry what robots say to other robots, as the configurations have it under 'bridges' (docs/bridges.md), until Ctrl+C;
                                prints how each bridge is doing
      --metrics PORT            give the numbers at http://127.0.0.1:PORT/metrics, as Prometheus reads them (0: any free port)
      --duration TIME           end by itself: 30s, 10m, 1h;  --json  a line for programs for each bridge and second
                                0: ended in time, 1 and 2: no configuration was right, 7: no bridge, or the port is taken, 130: Ctrl+C
TEXT
}

cmd_bridge() {
  local configs=() options=()
  while [[ $# -gt 0 ]]; do
    case $1 in
      --json) options+=(-json) ;;
      --metrics) [[ ${2:-} =~ ^[0-9]{1,5}$ ]] || usage_error "--metrics needs a port, 0 for any free one"; options+=(-metrics "$2"); shift ;;
      --duration) options+=(-for "$(seconds_of "$1" "${2:-}")") || exit 2; shift ;;
      -*) usage_error "bridge does not know '$1'" ;;
      *) configs+=("$(config_path "$1")") || exit 2 ;;
    esac
    shift
  done
  [[ ${#configs[@]} -gt 0 ]] || usage_error "bridge needs a configuration"
  need_product
  trap end_everything EXIT
  start_simulators '' "${configs[@]}"
  start_controls "${configs[@]}"
  run_application text -config "${configs[@]}" "${options[@]}" -bridge
}
