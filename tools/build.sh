# Building: only when a source changed, and only as much as the command needs.

readonly LOGS=$KEEP/logs
readonly PRODUCTS=$ROOT/product/target/products
readonly WINDOW_PRODUCT=$PRODUCTS/org.robotui.workbench.product/linux/gtk/x86_64
readonly HEADLESS_PRODUCT=$PRODUCTS/org.robotui.headless.product/linux/gtk/x86_64
readonly PRODUCT_TOOLS=(tools/{archive,bridge,control,desktop,install,java,launch,log,packages,record,run,say,simulator,stop,support,surroundings,use}.sh)
readonly STAMP=$ROOT/product/target/robotui.stamp

# Makes both products, unless they are those of the present sources.
need_product() {
  need_jdk
  is_product_fresh && return 0
  mkdir -p "$KEEP"
  exec {build_lock}>"$KEEP/build.lock"
  flock "$build_lock"                     # another ./robotui may be building the same
  # Its children do not hold the lock: one that outlives a build which was killed would lock the next one out.
  is_product_fresh || build_product {build_lock}>&-
  exec {build_lock}>&-
}

is_product_fresh() {
  [[ -r $STAMP && -d $WINDOW_PRODUCT/plugins && -d $HEADLESS_PRODUCT/plugins ]] && [[ $(<"$STAMP") == "$(source_stamp)" ]]
}

# Name, size and time of every file that goes into a product, but for its configurations and texts, which one may change without a build.
# What the build itself brings into lib/ says nothing of the sources.
source_stamp() {
  (cd "$ROOT" && find .mvn pom.xml "${PRODUCT_TOOLS[@]}" releng bundles features product rt-native/link rt-native/jni -type f \
      ! -path 'bundles/*/lib/*' ! -path '*/target/*' ! -path '*/bin/*' ! -path '*/src_test/*' ! -name '.polyglot.*' ! -name '*.launch' -printf '%p %s %T@\n' \
    | LC_ALL=C sort | sha256sum)
}

build_product() {
  local stamp started=$SECONDS
  need_maven
  need_link
  list_features
  stamp=$(source_stamp)
  clear_classes
  say "Building RobotUI ($(build_outlook))"
  maven "$LOGS/build.log" verify -Dproduct.only -Dmaven.test.skip=true -Dtest.compile.phase=none -Dskip.archive=true || exit 1
  finish_products "$stamp"
  say "Built in $((SECONDS - started)) s"
}

# finish_products STAMP: what Maven has made of the sources with that stamp. Without the archive a start is merely slower.
finish_products() {
  { archive_classes "$HEADLESS_PRODUCT" load_by_check; archive_classes "$WINDOW_PRODUCT" load_by_window; } >"$LOGS/archive.log" 2>&1 || true
  printf '%s' "$1" >"$STAMP"
}

# The products and the update site have every feature that there is.
list_features() { "$JAVA_HOME/bin/java" "$ROOT/releng/ProductFeatures.java" "$ROOT" >&2; }

# Tycho compiles the sources that changed, not those that use them: classes of before and after would meet in one product.
clear_classes() { rm -rf "$ROOT"/bundles/*/target/classes; }

build_outlook() {
  if [[ -d ${HOME}/.m2/repository/org/eclipse/platform/org.eclipse.ui.workbench ]]; then
    printf 'about half a minute'
  else
    printf 'the first time about 170 MB are fetched: some minutes'
  fi
}
