# MuJoCo for models and simulation: optional, fetched when it is wanted.
readonly MUJOCO_VERSION=3.3.0
readonly MUJOCO_HOME=$KEEP/mujoco-$MUJOCO_VERSION

have_mujoco() { [[ -f $MUJOCO_HOME/libmujoco.so.$MUJOCO_VERSION && -f $MUJOCO_HOME/include/mujoco/mujoco.h ]]; }

# Takes the headers and the library out of the Python package, whatever Python there is; nothing is installed.
fetch_mujoco() {
  have_mujoco && return
  local part
  python3 -m pip --version >/dev/null 2>&1 || need_packages "Fetching MuJoCo" python3-pip || return 1
  mkdir -p "$KEEP"
  part=$(mktemp -d "$KEEP/mujoco.XXXXXX")
  say "Fetching MuJoCo $MUJOCO_VERSION (7 MB)"
  unpack_mujoco "$part" && rm -rf "$MUJOCO_HOME" && mv "$part/$MUJOCO_VERSION" "$MUJOCO_HOME"
  rm -rf "$part"
  have_mujoco
}

# A network that does not answer may not hold anybody up: the time is bounded.
unpack_mujoco() {
  local part=$1 into=$1/$MUJOCO_VERSION
  timeout 120 python3 -m pip download -q --disable-pip-version-check --timeout 15 --retries 2 --no-deps --only-binary=:all: \
      --python-version 3.11 --platform "manylinux2014_$(uname -m)" -d "$part" "mujoco==$MUJOCO_VERSION" >&2 \
    && python3 -m zipfile -e "$part"/*.whl "$part" \
    && mkdir -p "$into" \
    && cp -r "$part/mujoco/include" "$part/mujoco/libmujoco.so.$MUJOCO_VERSION" "$into/" \
    && find "$part" -path '*dist-info*' -name 'LICENSE*' -exec cp {} "$into/" \;
}

# For a control whose configuration simulates with MuJoCo. Without it robotui-rt says that this HAL is not built in.
need_mujoco_for() {
  [[ -z ${ROBOTUI_NATIVE_BUILT:-} ]] || return 0
  names_hal "$1" mujoco || return 0
  fetch_mujoco || say "robotui: MuJoCo could not be fetched: it needs python3-pip and the network."
}

# What CMake is told: -DMUJOCO_ROOT where it was fetched.
mujoco_option() { if have_mujoco; then printf '%s' "-DMUJOCO_ROOT=$MUJOCO_HOME"; fi; }
