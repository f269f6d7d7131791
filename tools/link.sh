# The library by which Java reads the memory of the real-time control: a compiler and CMake make it, nothing else is needed.

readonly LINK_PACKAGES=(cmake make g++)
readonly LINK_LIBRARY=$ROOT/bundles/org.robotui.xbot.linux.x86_64/lib/librobotui_rt_jni.so

# Makes it where a source changed. Without it everything works but attaching to a real-time control.
need_link() {
  if ! need_packages "The link to real-time control" "${LINK_PACKAGES[@]}"; then
    say "  Without them the workbench cannot attach to a real-time control; all else works."
    return 0
  fi
  mkdir -p "$LOGS"
  make_link >"$LOGS/link.log" 2>&1 || fail "the link to real-time control could not be built: see $LOGS/link.log"
}

make_link() {
  local build=$ROOT/rt-native/target/link
  clear_moved_cmake "$build"
  cmake -S "$ROOT/rt-native" -B "$build" -DCMAKE_BUILD_TYPE=MinSizeRel -DRT_LINK_ONLY=ON -DBUILD_TESTING=OFF \
    && cmake --build "$build" --parallel \
    && install_link "$build/lib/librobotui_rt_jni.so"
}

# CMake keeps absolute paths: a folder that it made in another place, before the checkout was moved or copied, is made anew.
clear_moved_cmake() {
  local made_in
  [[ -r $1/CMakeCache.txt ]] || return 0
  made_in=$(sed -n 's/^CMAKE_CACHEFILE_DIR:INTERNAL=//p' "$1/CMakeCache.txt")
  [[ $made_in -ef $1 ]] || rm -rf "$1"
}

# Only a library that differs is written, so that nothing is packed anew for its time.
install_link() {
  strip --strip-unneeded -o "$1.stripped" "$1"
  cmp -s "$1.stripped" "$LINK_LIBRARY" || install -D "$1.stripped" "$LINK_LIBRARY"
}
