"""./robotui record writes every cycle of a control in real time; what is missing is said in the file, and the control goes on undisturbed."""
import json
import os
import pathlib
import signal
import subprocess

import pytest

from conftest import ROOT, await_end, json_lines, needs_rt, tell, wait_for
from realtime import Control, patient_arm

PYTHON = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "none")) / "recordings/bin/python"
CONFIG = "ruics: {arm: {type: manipulator, rfics: {rt: {type: xbot}}}}\n"

pytestmark = [needs_rt, pytest.mark.skipif(not PYTHON.exists(), reason="there are no readers of recordings from PyPI (ROBOTUI_ROS2_PEERS)")]


def test_every_cycle_of_all_joints_is_in_the_file(processes, environment, tmp_path):
    control = Control(processes, environment, tmp_path, patient_arm(tmp_path))
    control.start()
    wait_for(control.is_up, 60, "the control")
    control.ctl("switch", "Homing", "1")
    config, file = tmp_path / "arm.yaml", tmp_path / "run.mcap"
    config.write_text(CONFIG)
    recording = processes.start([ROOT / "robotui", "record", config, "--out", file, "--ports", "cycles", "--json"], "record", control.robot.environment)
    wait_for(lambda: last(recording).get("messages", 0) > 3000, 90, "three seconds of cycles")
    tell(recording, signal.SIGINT)
    await_end(recording)

    cycles = decoded(file)
    dropped = last(recording)["dropped"]
    missing = sum(after[0] - before[0] - 1 for before, after in zip(cycles, cycles[1:]))
    assert missing == cycles[-1][1] - cycles[0][1] + dropped, "what is missing is said: what could not be read in time, and what could not be taken"
    assert len(cycles) > 2000, "which a machine that has nothing else to do sends in two seconds"
    assert all(before[2] < after[2] for before, after in zip(cycles, cycles[1:])), "stamps follow each other"
    assert set(cycles[0][3]) == set(control.joints())
    found = subprocess.run([ROOT / "robotui", "log", "find", file, "--where", "cycles cycle > 0", "--json"], capture_output=True, text=True, timeout=90)
    assert found.returncode == 0 and len(found.stdout.splitlines()) == 1, found.stdout + found.stderr


def last(recording):
    lines = json_lines(recording)
    return lines[-1] if lines else {}


def decoded(file):
    answer = subprocess.run([PYTHON, ROOT / "tests/e2e/peers/cycle_decoder.py", file], capture_output=True, text=True, timeout=90, check=False)
    assert answer.returncode == 0, answer.stderr
    return [json.loads(line) for line in answer.stdout.splitlines()]
