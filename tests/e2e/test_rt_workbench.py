"""The workbench's client of the control in real time: attach, lose, attach again; the terminal stands for the window."""
import os
import signal
import time

import pytest

from conftest import end, json_lines, needs_rt, start_robotui, wait_for
from realtime import Control

CONFIG = """ruics:
  arm:
    type: manipulator
    rfics:
      rt: {type: xbot, rate: 20}
"""

pytestmark = needs_rt


@pytest.fixture
def control(processes, environment, tmp_path):
    return Control(processes, environment, tmp_path)


@pytest.fixture
def workbench(control, tmp_path):
    """Starts one."""
    config = tmp_path / "workbench.yaml"
    config.write_text(CONFIG)
    return lambda: start_robotui(control.robot, "run", "--json", config)


def said_now(workbench):
    """What it says of the joints just now: a port that is withdrawn is not spoken of any more."""
    before = len(json_lines(workbench))
    time.sleep(1.6)
    return [line for line in json_lines(workbench)[before:] if line["port"] == "rt.joints"]


def is_live(workbench):
    return any(line["link"] == "connected" and line["rate_hz"] > 5 and line["age_s"] < 0.5 for line in said_now(workbench))


def test_the_joints_of_a_control_are_seen_and_come_back_with_it(control, workbench):
    first = control.start("first")
    running = workbench()
    wait_for(lambda: is_live(running), 60, "live joints")

    end(first, how=signal.SIGKILL)
    wait_for(lambda: not is_live(running), what="the loss to be seen")

    control.start("second")
    wait_for(lambda: is_live(running), what="live joints again")


def test_a_workbench_that_was_there_first_finds_the_control_and_leaves_no_mark_on_it(control, workbench):
    running = workbench()
    supervisor = control.start("control")
    wait_for(lambda: is_live(running), 60, "live joints")
    before = control.ctl("list")
    end(running, how=signal.SIGKILL)

    assert control.ctl("list") == before
    assert supervisor.poll() is None


def test_a_host_that_dies_is_seen_with_its_plugins_stopped_and_the_joints_go_on(control, workbench):
    control.start("control")
    running = workbench()
    wait_for(lambda: is_live(running), 60, "live joints")
    control.ctl("switch", "Homing", "1")

    for pid in control.hosts():
        os.kill(pid, signal.SIGSEGV)

    wait_for(lambda: "running" not in control.ctl("list") and "Homing" in control.ctl("list"), what="the plugin's end")
    wait_for(lambda: is_live(running), what="live joints")
