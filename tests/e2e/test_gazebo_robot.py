"""A robot in a world that speaks the real transport of Gazebo: seen, lost, found again, and left as it was."""
import pathlib
import shutil
import signal
import subprocess
import time
import uuid

import pytest

from conftest import Robot, end, json_lines, last_of, start_robotui, wait_for

SOURCE = pathlib.Path(__file__).parent / "peers/gazebo_world.cpp"
PACKAGES = ("ignition-transport11", "ignition-msgs8")
CONTACT = "world/yard/model/crate/link/wood/sensor/bumper/contact"
CONFIG = """ruics:
  Robot:
    type: mobilebase
    rfics:
      base: {{type: gazebo, partition: {partition}}}
"""


def lacking():
    known = shutil.which("pkg-config") and subprocess.run(["pkg-config", "--exists", *PACKAGES], check=False).returncode == 0
    return not (known and shutil.which("g++"))


pytestmark = pytest.mark.skipif(lacking(), reason="needs libignition-transport-dev, libignition-msgs-dev and g++: ./robotui test installs them")


@pytest.fixture(scope="module")
def world(tmp_path_factory):
    program = tmp_path_factory.mktemp("gazebo") / "gazebo_world"
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", *PACKAGES], capture_output=True, text=True, check=True).stdout.split()
    subprocess.run(["g++", "-std=c++17", "-o", str(program), str(SOURCE), *flags], check=True)
    return program


def alive(robotui, port, least):
    line = last_of(robotui, port)
    return line and line["link"] == "connected" and line["rate_hz"] > least and line["age_s"] < 1.5


def test_a_world_is_seen_lost_and_found_again(processes, environment, tmp_path, world):
    partition = str(uuid.uuid4())
    robot = Robot(processes, "", environment | {"IGN_PARTITION": partition})
    config = tmp_path / "robot.yaml"
    config.write_text(CONFIG.format(partition=partition))
    first = robot.start_tool(str(world), name="world")
    robotui = start_robotui(robot, "run", "--json", str(config))
    for port, least in (("model/rover/odometry", 5), ("scan", 5), ("camera", 5), ("world/yard/model/rover/joint_state", 5),
                        (CONTACT, 5)):
        wait_for(lambda: alive(robotui, port, least), seconds=90, what=f"a live {port}")
    wait_for(lambda: "scene" in first.out.read_text().splitlines(), what="the question for the scene")

    end(first, how=signal.SIGKILL)
    before = last_of(robotui, "scan")
    time.sleep(5)
    lost = last_of(robotui, "scan")
    again = robot.start_tool(str(world), name="again")
    wait_for(lambda: last_of(robotui, "scan") != lost and alive(robotui, "scan", 5), seconds=60, what="the scan again")
    assert before and not any(line["dropped"] for line in json_lines(robotui))

    end(robotui)
    assert not any(line.startswith(("drive", "control")) for line in again.out.read_text().splitlines()), "nobody commanded anything"
