"""Robots behind real servers of Foxglove's protocol, the present one and its predecessor: seen, lost, found again, driven, and left as they were."""
import os
import pathlib
import signal
import time

import pytest

import desktop
from conftest import Robot, end, free_port, json_lines, last_of, listening, start_robotui, wait_for
from desktop import Keys, Window

PEERS = pathlib.Path(__file__).parent / "peers"
PYTHON = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "")) / "foxglove/bin/python"
CONFIG = """ruics:
  Robot:
    type: mobilebase
    rfics:
      base: {{type: foxglove, url: "ws://127.0.0.1:{port}", velocity: cmd_vel}}
"""

pytestmark = pytest.mark.skipif(not PYTHON.exists(), reason="needs foxglove-sdk and foxglove-websocket from PyPI: ./robotui test fetches them")


@pytest.fixture
def robot(processes, environment, tmp_path):
    port = free_port()
    robot = Robot(processes, f"ws://127.0.0.1:{port}", environment)
    robot.port = port
    robot.config = tmp_path / "robot.yaml"
    robot.config.write_text(CONFIG.format(port=port))
    return robot


def start(robot, script, name="server"):
    server = robot.start_tool(PYTHON, str(PEERS / script), str(robot.port), name=name)
    wait_for(lambda: listening(robot.port), what="the server")
    return server


# All ports are wanted here, also the one that nobody can read, of which the link says so.
UP = ("connected", "degraded")


def alive(robotui, port, least):
    line = last_of(robotui, port)
    return line and line["link"] in UP and line["rate_hz"] > least and line["age_s"] < 1.5


def is_gone(robotui, port):
    """With the connection all ports go: of one that is gone, nothing is printed any more."""
    before = last_of(robotui, port)
    time.sleep(2.5)
    return last_of(robotui, port) == before


def said(server, *words):
    return " ".join(words) in server.out.read_text().splitlines()


def test_what_the_present_server_sends_is_seen_lost_and_found_again(robot):
    server = start(robot, "foxglove_robot.py")
    robotui = start_robotui(robot, "run", "--json", str(robot.config))
    for port, least in (("odom", 5), ("scan", 5), ("pose", 5)):
        wait_for(lambda: alive(robotui, port, least), seconds=90, what=f"a live {port}")

    end(server, how=signal.SIGKILL)
    wait_for(lambda: is_gone(robotui, "odom"), what="the loss")
    again = start(robot, "foxglove_robot.py", name="again")
    lost = last_of(robotui, "odom")
    wait_for(lambda: last_of(robotui, "odom") != lost and alive(robotui, "odom", 5), what="odometry again")
    assert not any(line["dropped"] for line in json_lines(robotui))

    end(robotui)
    wait_for(lambda: said(again, "unsubscribe", "/odom") and said(again, "unadvertise", "/cmd_vel"), what="leave taken of the robot")
    assert not said(again, "subscribe", "/odd"), "what nobody can read is not asked for"


def test_the_predecessor_is_understood(robot):
    start(robot, "foxglove_old_robot.py")
    robotui = start_robotui(robot, "run", "--json", str(robot.config))
    wait_for(lambda: (last_of(robotui, "odom") or {}).get("rate_hz", 0) > 5, seconds=90, what="odometry")


@pytest.mark.skipif(bool(desktop.missing()), reason=f"needs {desktop.missing()}")
def test_it_is_driven_from_a_window_and_stands_when_the_key_is_let_go(robot):
    server = start(robot, "foxglove_robot.py")
    window = Window.open(robot, str(robot.config))
    wait_for(window.is_live, seconds=60, what="a robot in sight")
    place = wait_for(window.stick, seconds=60, what="the stick")
    keys = Keys()
    try:
        window.click(place)
        keys.hold("w")
        wait_for(lambda: "drive 0." in server.out.read_text(), what="a motion")
    finally:
        keys.let_go()
    wait_for(lambda: server.out.read_text().splitlines()[-1] == "drive 0.0", what="the stop")
