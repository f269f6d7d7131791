"""A checkout that was moved after something had been built in it."""
import shutil
import subprocess

from conftest import ROOT

LINK = "bundles/org.robotui.xbot.linux.x86_64/lib/librobotui_rt_jni.so"


def make_link(checkout):
    """Makes the link as ./robotui does, of the sources in another checkout."""
    parts = "".join(f"source {ROOT}/tools/{part}.sh; " for part in ("say", "packages", "java", "link"))
    code = f"set -euo pipefail; ROOT={checkout} KEEP={checkout}/.tools LOGS={checkout}/logs; {parts} need_jdk; make_link"
    return subprocess.run(["/bin/bash", "-c", code], stdin=subprocess.DEVNULL, text=True, capture_output=True, timeout=300, check=False)


def test_what_cmake_made_elsewhere_is_made_anew(tmp_path):
    there, here = tmp_path / "there", tmp_path / "here"
    for folder in ("link", "jni", "cmake"):
        shutil.copytree(ROOT / "rt-native" / folder, there / "rt-native" / folder)
    shutil.copy(ROOT / "rt-native/CMakeLists.txt", there / "rt-native")
    first = make_link(there)
    assert first.returncode == 0, first.stderr
    (there / LINK).unlink()

    there.rename(here)
    moved = make_link(here)

    assert moved.returncode == 0, moved.stderr
    assert (here / LINK).exists()
