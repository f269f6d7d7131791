# Versions of exported packages, compared with an earlier state (releng/ApiVersions.java).

cmd_versions() {
  [[ $# -le 1 ]] || usage_error "versions takes one commit or tag to compare with, or none for the newest tag"
  need_jdk
  local before=${1:-} folder status=0
  [[ -n $before ]] || before=$(git -C "$ROOT" describe --tags --abbrev=0 2>/dev/null) \
    || usage_error "there is no tag to compare with; name a commit"
  git -C "$ROOT" rev-parse --quiet --verify "$before^{commit}" >/dev/null || usage_error "there is no commit '$before'"
  folder=$(mktemp -d)
  # only now, as fail ends the shell
  trap "rm -rf '$folder'" EXIT
  git -C "$ROOT" archive "$before" bundles | tar -x -C "$folder" || fail "$before could not be read"
  say "Comparing exported packages with $before"
  "$JAVA_HOME/bin/java" "$ROOT/releng/ApiVersions.java" "$folder" "$ROOT" || status=1
  return $status
}
