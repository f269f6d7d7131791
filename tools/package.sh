# What is given away: archives, packages of Debian, single files that start, and the update site (docs/adr/0170).

readonly PLATFORM=linux.gtk.x86_64
readonly DEB_DEPENDS=', libgtk-3-0t64 | libgtk-3-0, fonts-dejavu-core, adwaita-icon-theme'

cmd_package() {
  [[ $# -eq 0 ]] || usage_error "package takes no arguments"
  need_jdk
  need_maven
  need_link
  list_features
  say "Packaging RobotUI"
  maven "$LOGS/package.log" verify -Dproduct.only -Dmaven.test.skip=true -Dtest.compile.phase=none || exit 1
  source_stamp >"$STAMP"
  package_all "$PRODUCTS"
  ls "$PRODUCTS"/robotui* "$PRODUCTS/SHA256SUMS"
  echo "$ROOT/product/target/repository"
}

# package_all FOLDER: of the archives that lie in it.
package_all() {
  local kind
  rm -f "$1"/robotui*.deb "$1"/robotui*.run
  for kind in workbench headless; do
    single_file "$1" "robotui-$kind-$PLATFORM"
  done
  if command -v dpkg-deb >/dev/null; then
    deb "$1" workbench robotui robotui-headless amd64
    deb "$1" headless robotui-headless robotui amd64 arm64
  else
    say "No packages of Debian are made: dpkg-deb is not installed."
  fi
  (cd "$1" && sha256sum -- robotui* >SHA256SUMS)
}

# single_file FOLDER NAME: the script, and behind it the archive as it is.
single_file() {
  local archive=$1/$2.tar.gz file=$1/$2.run sum
  sum=$(sha256sum <"$archive")
  sed -e "s,@NAME@,$2," -e "s,@SUM@,${sum%% *}," -e "s,@SIZE@,$(stat -c %s "$archive")," "$ROOT/releng/single-file.sh" >"$file"
  cat "$archive" >>"$file"
  chmod 755 "$file"
}

# deb FOLDER KIND PACKAGE OTHER ARCHITECTURE...: of the archive of that kind. The two packages have files of the same names. One without a window has the same
# files for all architectures: native code that is for another one is never loaded.
deb() {
  local folder=$1 kind=$2 package=$3 other=$4 work version architecture
  shift 4
  work=$(mktemp -d)
  deb_files "$folder/robotui-$kind-$PLATFORM.tar.gz" "$work/root" "$package"
  version=$(deb_version "$work/root/usr/lib/robotui")
  for architecture in "$@"; do
    deb_control "$work/root" "$kind" "$package" "$other" "$version" "$architecture"
    dpkg-deb --root-owner-group -Zgzip -z4 --build "$work/root" "$folder/${package}_${version}_$architecture.deb" >/dev/null || fail "$package could not be packed"
  done
  rm -rf "$work"
}

# deb_files ARCHIVE ROOT PACKAGE
deb_files() {
  local lib=$2/usr/lib/robotui share=$2/usr/share doc=$2/usr/share/doc/$3
  mkdir -p "$lib" "$2/usr/bin" "$share/applications" "$share/icons/hicolor/scalable/apps" "$share/man/man1" "$doc"
  tar -xzf "$1" -C "$lib" --strip-components=1
  # The launcher then keeps what the framework writes with the user, also for root.
  touch "$lib/system-package"
  ln -s ../lib/robotui/robotui "$2/usr/bin/robotui"
  cp "$lib/robotui.desktop" "$share/applications/"
  cp "$lib/robotui.svg" "$share/icons/hicolor/scalable/apps/"
  man_page "$lib/robotui" | gzip -9n >"$share/man/man1/robotui.1.gz"
  cp "$ROOT/releng/deb/copyright" "$lib/THIRD-PARTY.md" "$doc/"
  printf '%s (%s) unstable; urgency=medium\n\n  * Built from the sources of %s.\n\n -- %s  %s\n' \
    "$3" "$(deb_version "$lib")" "$(checkout_version)" "$(maintainer)" "$(date -R)" | gzip -9n >"$doc/changelog.gz"
  rm -f "$lib/LICENSE"
  ln -s ../../share/common-licenses/Apache-2.0 "$lib/LICENSE"
  chmod -R u=rwX,go=rX "$2"
}

# deb_control ROOT KIND PACKAGE OTHER VERSION ARCHITECTURE
deb_control() {
  local depends='' summary='workbench for robots of any framework, without a window'
  local long='This is the product without a window: views in a terminal, and lines of JSON.'
  if [[ $2 == workbench ]]; then
    depends=$DEB_DEPENDS
    summary='workbench for robots of any framework'
    long='Maps, 3D scenes, cameras, plots, joints and alerts in windows; a terminal will do.'
  fi
  mkdir -p "$1/DEBIAN"
  sed -e "s,@PACKAGE@,$3," -e "s,@OTHER@,$4," -e "s,@VERSION@,$5," -e "s,@ARCHITECTURE@,$6," -e "s,@MAINTAINER@,$(maintainer)," \
    -e "s,@SIZE@,$(du -sk --exclude=DEBIAN "$1" | cut -f 1)," -e "s/@DEPENDS@/$depends/" -e "s/@SUMMARY@/$summary/" -e "s/@LONG@/$long/" \
    "$ROOT/releng/deb/control.in" >"$1/DEBIAN/control"
  install -m 755 "$ROOT/releng/deb/postrm" "$1/DEBIAN/postrm"
  (cd "$1" && find usr -type f -print0 | sort -z | xargs -0 md5sum) >"$1/DEBIAN/md5sums"
}

# That of the core which starts, whose qualifier is the time of the build.
deb_version() {
  awk -F, '$1 == "org.robotui.core" { sub(/\.[^.]*$/, "+&", $2); sub(/\+\./, "+", $2); print $2 }' \
    "$1/configuration/org.eclipse.equinox.simpleconfigurator/bundles.info"
}

maintainer() { printf '%s' "${ROBOTUI_MAINTAINER:-RobotUI <robotui@robotui.invalid>}"; }

# What the help says, as a page of the manual.
man_page() {
  printf '.TH ROBOTUI 1 "" "RobotUI" "User Commands"\n.SH NAME\nrobotui \\- workbench for robots of any framework\n.SH COMMANDS\n.nf\n'
  "$1" help | sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^[.']/\\\\\&&/" -e 's,\./robotui,robotui,g'
  printf '.fi\n.SH FILES\n.TP\n.I ~/.local/state/robotui\nLogs, and what users change. Only the user can read it.\n.TP\n'
  printf '.I /usr/lib/robotui/documentation/index.html\nThe documentation, which the menu Help opens.\n'
}
