# What somebody needs to know who helps, in one file: no framework is started for it, as that may be what fails.

cmd_support() {
  local file='' configs=() jars='' bundle home
  while [[ $# -gt 0 ]]; do
    case $1 in
      --config) [[ -n ${2:-} ]] || usage_error "--config needs a configuration"; configs+=("$(config_path "$2")") || exit 2; shift ;;
      -*) usage_error "support does not know '$1'" ;;
      *) [[ -z $file ]] || usage_error "support writes one file"
         file=$1 ;;
    esac
    shift
  done
  file=$(realpath -m "${file:-robotui-support-$(date +%Y%m%d-%H%M%S).zip}")
  for bundle in org.robotui.core org.robotui.api org.robotui.net; do
    jars+=$(jar_of "$bundle" 2>/dev/null): || true
  done
  [[ $jars != :* ]] || fail "nothing of this folder was built yet, so that there is nothing to tell: ./robotui run builds it"
  home=$(find_java java) || need_java
  "${home:-$JAVA_HOME}/bin/java" -XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xshare:auto -Xmx256m -cp "$jars" \
    org.robotui.core.internal.facts.SupportMain "$(state_folder)" "$HEADLESS_PRODUCT" "$file" "${configs[@]}"
}
