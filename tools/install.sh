# Installing, updating and removing while RobotUI runs: features of update sites go into the product, jars into a folder that every RobotUI of
# this user watches (docs/installing.md). What runs takes up both at once.

cmd_install() {
  local what words=() options=() features
  parse_features install "$@"
  what=${words[0]:-}
  features=("${words[@]:1}")
  [[ -n $what ]] || usage_error "install needs an update site (an address or a folder), a folder with bundles that were built, or a jar"
  if [[ $what =~ ^[a-z]+:/ ]]; then
    change_features install -site "$what" "${features[@]}" "${options[@]}"
  elif [[ -d $what ]] && is_site "$what"; then
    change_features install -site "$(file_address "$what")" "${features[@]}" "${options[@]}"
  fi
  [[ ${#features[@]} -eq 0 ]] || usage_error "$what is no update site, so that it has no feature ${features[*]}"
  if [[ -d $what ]]; then
    link_bundles "$what"
  elif [[ -f $what ]]; then
    copy_bundle "$what"
  else
    usage_error "there is no $what; an update site is named by its address, such as http://example.org/site"
  fi
}

cmd_installed() {
  [[ $# -eq 0 ]] || usage_error "installed takes no arguments"
  local folder jar
  folder=$(bundle_folder)
  for jar in "$folder"/*.jar; do
    [[ -e $jar ]] || [[ -L $jar ]] || continue
    if [[ -L $jar ]]; then
      printf '%s -> %s\n' "$jar" "$(readlink "$jar")"
    else
      printf '%s\n' "$jar"
    fi
  done
  change_features installed
}

cmd_update() {
  local words=() options=()
  parse_features update "$@"
  change_features update "${words[@]}" "${options[@]}"
}

# parse_features COMMAND ARGUMENT...: fills words and options of the caller.
parse_features() {
  local command=$1
  shift
  while [[ $# -gt 0 ]]; do
    case $1 in
      --unsigned) options+=(-unsigned) ;;
      -*) usage_error "$command does not know '$1'" ;;
      *) words+=("$1") ;;
    esac
    shift
  done
}

# Features, or jars of the folder by the names that they have there.
cmd_remove() {
  local folder name features=()
  [[ $# -gt 0 ]] || usage_error "remove needs a feature, or the name of a jar: ./robotui installed prints both"
  folder=$(bundle_folder)
  for name in "$@"; do
    case $name in
      -*) usage_error "remove does not know '$name'" ;;
      *.jar)
        name=${name##*/}
        [[ -e $folder/$name || -L $folder/$name ]] || fail "there is no $folder/$name"
        rm -f "$folder/$name"
        printf 'Removed %s\n' "$folder/$name"
        ;;
      *) features+=("$name") ;;
    esac
  done
  [[ ${#features[@]} -eq 0 ]] || change_features remove "${features[@]}"
}

# ---- update sites ---------------------------------------------------------------------------------------------------

is_site() {
  local file
  for file in p2.index content.jar content.xml content.xml.xz compositeContent.jar compositeContent.xml; do
    [[ ! -e $1/$file ]] || return 0
  done
  return 1
}

# A path as an address: what may not stand in one is escaped, byte by byte.
file_address() {
  local LC_ALL=C path i char address=file://
  path=$(realpath "$1")
  for ((i = 0; i < ${#path}; i++)); do
    char=${path:i:1}
    case $char in
      [a-zA-Z0-9/._~-]) address+=$char ;;
      *) printf -v char '%%%02X' "'$char" && address+=%${char: -2} ;;
    esac
  done
  printf '%s' "$address"
}

# Does not come back. In a checkout it is the product with the window.
change_features() {
  need_product
  [[ $1 == installed || -w $WINDOW_PRODUCT/configuration ]] || fail "$WINDOW_PRODUCT cannot be written: let its owner do this"
  export ROBOTUI_VMARGS="-XX:TieredStopAtLevel=1 ${ROBOTUI_VMARGS:-}"     # it ends before code of the slower compiler pays
  exec "$WINDOW_PRODUCT/robotui" -application org.robotui.headless.application -features "$@"
}

# ---- the folder -----------------------------------------------------------------------------------------------------

# A whole file under its name, never a part of it.
copy_bundle() {
  local folder name=${1##*/}
  [[ $name == *.jar ]] || usage_error "$1 is neither an update site nor a jar"
  folder=$(bundle_folder)
  { mkdir -p "$folder" && cp "$1" "$folder/.$name.$$" && mv -f "$folder/.$name.$$" "$folder/$name"; } \
    || fail "$folder/$name cannot be written"
  printf 'Installed %s\n' "$folder/$name"
}

# Links to what was built in a folder, so that what is built there later replaces it. Old links to there go.
link_bundles() {
  local folder jar link source found=()
  source=$(realpath "$1")
  while IFS= read -r jar; do
    ! is_bundle "$jar" || found+=("$jar")
  done < <(find "$source" -maxdepth 4 -name '*.jar' ! -name '*-sources.jar' ! -name '*-javadoc.jar' -path "$source/*" \
             \( -path '*/target/*' -o -path "$source/*.jar" ! -path "$source/*/*" \) ! -path '*/target/*/*' | sort)
  [[ ${#found[@]} -gt 0 ]] || fail "there is no bundle in $1, nor in a folder 'target' below it: build it first"
  folder=$(bundle_folder)
  mkdir -p "$folder" || fail "$folder cannot be written"
  for link in "$folder"/*.jar; do
    [[ ! -L $link || $(readlink "$link") != "$source"/* ]] || rm -f "$link"
  done
  for jar in "${found[@]}"; do
    ln -sfn "$jar" "$folder/${jar##*/}"
    printf 'Installed %s -> %s\n' "$folder/${jar##*/}" "$jar"
  done
}

# Whether its manifest says so, as features are built into jars, too. Where it cannot be asked, whoever watches the folder says it.
is_bundle() { ! command -v unzip >/dev/null || unzip -p "$1" META-INF/MANIFEST.MF 2>/dev/null | grep -q '^Bundle-SymbolicName:'; }
