# Building: only when a source changed, and only as much as the command needs.

readonly LOGS=$KEEP/logs
readonly PRODUCTS=$ROOT/product/target/products
readonly WINDOW_PRODUCT=$PRODUCTS/org.robotui.workbench.product/linux/gtk/x86_64
readonly HEADLESS_PRODUCT=$PRODUCTS/org.robotui.headless.product/linux/gtk/x86_64
readonly STAMP=$ROOT/product/target/robotui.stamp

# Makes both products, unless they are those of the present sources.
need_product() {
  need_jdk
  is_product_fresh && return 0
  mkdir -p "$KEEP"
  exec {build_lock}>"$KEEP/build.lock"
  flock "$build_lock"                     # another ./robotui may be building the same
  is_product_fresh || build_product
  exec {build_lock}>&-
}

is_product_fresh() {
  [[ -r $STAMP && -d $WINDOW_PRODUCT/plugins && -d $HEADLESS_PRODUCT/plugins ]] && [[ $(<"$STAMP") == "$(source_stamp)" ]]
}

# Name, size and time of every file that goes into a product.
source_stamp() {
  (cd "$ROOT" && find .mvn pom.xml releng bundles features product -type f \
      ! -path '*/target/*' ! -path '*/bin/*' ! -path '*/src_test/*' ! -name '.polyglot.*' -printf '%p %s %T@\n' \
    | LC_ALL=C sort | sha256sum)
}

build_product() {
  local stamp started=$SECONDS
  need_maven
  stamp=$(source_stamp)
  say "Building RobotUI ($(build_outlook))"
  maven "$LOGS/build.log" verify -Dproduct.only -Dmaven.test.skip=true -Dtest.compile.phase=none -Dskip.archive=true || exit 1
  archive_classes "$HEADLESS_PRODUCT"
  archive_classes "$WINDOW_PRODUCT"
  printf '%s' "$stamp" >"$STAMP"
  say "Built in $((SECONDS - started)) s"
}

# Keeps the loaded classes of one quiet run for later starts. Never at the end of a user's run: the virtual machine would
# write them while threads of robots still run, which takes long and has crashed it.
archive_classes() {
  local state
  state=$(mktemp -d)
  XDG_STATE_HOME=$state ROBOTUI_VMARGS="-XX:SharedArchiveFile= -XX:ArchiveClassesAtExit=$1/classes.jsa" "$1/robotui" \
    -application org.robotui.headless.application -check "$ROOT/configs/ros.yaml" >"$LOGS/archive.log" 2>&1 </dev/null || true
  rm -rf "$state"
}

build_outlook() {
  if [[ -d ${HOME}/.m2/repository/org/eclipse/platform/org.eclipse.ui.workbench ]]; then
    printf 'about half a minute'
  else
    printf 'the first time about 170 MB are fetched: some minutes'
  fi
}

cmd_package() {
  [[ $# -eq 0 ]] || usage_error "package takes no arguments"
  need_jdk
  need_maven
  say "Packaging RobotUI"
  maven "$LOGS/package.log" verify -Dproduct.only -Dmaven.test.skip=true -Dtest.compile.phase=none || exit 1
  source_stamp >"$STAMP"
  ls "$PRODUCTS"/*.tar.gz
  echo "$ROOT/product/target/repository"
}
