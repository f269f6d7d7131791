"""./robotui new robot, and what ./robotui rt fetches for a configuration, however it is written."""
import os
import subprocess

import pytest
import yaml

from conftest import ROOT, needs_rt

ARM = ROOT / "configs/arm"


def robotui(*words, folder):
    return subprocess.run([ROOT / "robotui", *map(str, words)], cwd=folder, env=os.environ | {"ROBOTUI_NATIVE_BUILT": "1"},
                          stdin=subprocess.DEVNULL, text=True, capture_output=True, timeout=60, check=False)


@needs_rt
def test_a_configuration_is_written_said_and_not_overwritten(tmp_path):
    made = robotui("new", "robot", ARM / "arm.urdf", "--in", tmp_path / "mine", folder=tmp_path)
    assert made.returncode == 0, made.stderr
    assert "7 joints are commanded" in made.stderr and f"./robotui run {tmp_path}/mine/robot.yaml" in made.stderr
    control = yaml.safe_load((tmp_path / "mine/rt-dummy.yaml").read_text())
    assert control["JointLimits"]["elbow_pitch"]["jerk"] > 0
    assert yaml.safe_load((tmp_path / "mine/robot.yaml").read_text())["control"] == "rt-dummy.yaml"

    again = robotui("new", "robot", ARM / "arm.urdf", "--in", tmp_path / "mine", folder=tmp_path)
    assert again.returncode == 1 and "is there already; choose another folder" in again.stderr
    assert robotui("new", "robot", folder=tmp_path).returncode == 2
    assert "does not exist; write the path" in robotui("new", "robot", "none.urdf", folder=tmp_path).stderr


@pytest.mark.parametrize(("text", "wanted"), [
    ("HALInterface:\n  type: mujoco\n", True),
    ("HALInterface: {type: mujoco}\n", True),
    ('{"HALInterface": {"period_us": 1000, "type": "mujoco"}}', True),
    ("HALInterface:\n  type:\n    'mujoco'\n", True),
    ("ModelInterface: {model_type: MUJOCO}\n", True),
    ("HALInterface: {type: dummy}   # or type: mujoco\n", False),
    ("# HALInterface: {type: mujoco}\nHALInterface: {type: mujocoish}\n", False),
])
def test_mujoco_is_wanted_however_a_configuration_says_so(tmp_path, text, wanted):
    (tmp_path / "rt.yaml").write_text(text)
    code = f"set -euo pipefail; ROOT={ROOT} KEEP={tmp_path}; source {ROOT}/tools/native.sh; names_hal {tmp_path}/rt.yaml mujoco"
    assert (subprocess.run(["/bin/bash", "-c", code], check=False).returncode == 0) == wanted
