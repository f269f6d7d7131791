"""The demo robot's action, tunables and newer sensors, as the stock clients of ROS meet them."""
import json
import pathlib
import subprocess

import pytest

from conftest import wait_for

PEERS = pathlib.Path(__file__).parent / "peers"
PYTHON = "/usr/bin/python3"


@pytest.fixture(autouse=True)
def clients():
    needed = "actionlib, dynamic_reconfigure.client, move_base_msgs.msg, diagnostic_msgs.msg"
    if subprocess.run([PYTHON, "-c", f"import {needed}"], capture_output=True, check=False).returncode:
        pytest.skip("needs the Debian packages python3-actionlib python3-dynamic-reconfigure python3-move-base-msgs")


def drive(robot, *arguments):
    return json.loads(robot.tool(PYTHON, PEERS / "drive_to.py", *map(str, arguments), seconds=90).splitlines()[-1])


def test_the_stock_action_client_drives_it_to_a_goal(simulator):
    end = drive(simulator, 0.8, 0, "base_link")
    assert (end["state"], end["text"]) == ("SUCCEEDED", "goal reached")
    assert end["feedback"] > 3


def test_goals_are_aborted_rejected_and_cancelled_with_their_reasons(simulator):
    wall = drive(simulator, 5, 2, "map")
    assert wall["state"] == "ABORTED" and wall["text"].startswith("goal refused")
    nowhere = drive(simulator, 1, 1, "moon")
    assert nowhere["state"] == "REJECTED" and "moon" in nowhere["text"]
    far = drive(simulator, 12, 5, "map", 2)
    assert (far["state"], far["text"]) == ("PREEMPTED", "goal cancelled")
    wait_for(lambda: abs(simulator.odometry()[2]) < 0.02, what="standstill")


def test_the_stock_client_tunes_it_while_it_runs(simulator):
    answer = json.loads(simulator.tool(PYTHON, PEERS / "tune.py", "/robot", "max_linear_speed", "9").splitlines()[-1])
    assert answer["values"]["max_linear_speed"] == answer["most"] == 1.5
    assert answer["styles"] == ["Careful", "Normal", "Brisk"]
    assert float(simulator.tool("rosparam", "get", "/robot/max_linear_speed")) == 1.5


def test_stock_tools_print_the_newer_topics(simulator):
    assert "name: \"robot: battery\"" in simulator.tool("rostopic", "echo", "-n", "1", "/diagnostics")
    assert "pan_joint" in simulator.tool("rostopic", "echo", "-n", "1", "/joint_states")
    assert "latitude: 48.26" in simulator.tool("rostopic", "echo", "-n", "1", "/fix")
    depth = simulator.tool("rostopic", "echo", "-n", "1", "--noarr", "/camera/depth/image_raw")
    assert "encoding: \"16UC1\"" in depth
    cloud = simulator.tool("rostopic", "echo", "-n", "1", "--noarr", "/lidar/points")
    assert "frame_id: \"base_lidar\"" in cloud and "point_step: 16" in cloud
    assert "status_list: []" in simulator.tool("rostopic", "echo", "-n", "1", "/move_base/status")
