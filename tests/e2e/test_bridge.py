"""./robotui bridge between nodes of rospy and rclpy: topics and services both ways, kept messages, commands with limits, and the return
of who was killed, also the bridge itself."""
import json
import os
import pathlib
import signal
import subprocess
import urllib.request

import pytest

from conftest import ROOT, end, kill_all_of, ros_domain, start_robotui, tell, wait_for

PEERS = pathlib.Path(__file__).parent / "peers"
RCLPY = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "none")) / "rclpy/bin/python"
DOMAIN = ros_domain(1)

pytestmark = pytest.mark.skipif(not RCLPY.exists(), reason="rclpy is not installed (ROBOTUI_ROS2_PEERS)")

CONFIG = """
bridges:
  scan: {from: Old.scan, to: New.natalie/scan, frame_prefix: natalie/}
  greeting: {from: New.greeting, to: Old.greeting, lease: false}
  drive: {from: New.drive, to: Old.cmd_vel, max_linear: 0.2}
  lights: {kind: service, from: New.lights, to: Old.set_lights, lease: false}
  reset: {kind: service, from: Old.reset, to: New.reset}
ruics:
  Old: {type: single, view: text, rfics: {base: {type: ros}}}
  New: {type: single, view: text, rfics: {base: {type: ros2}}}
"""


def test_nodes_of_ros_1_and_ros_2_hear_and_command_each_other(roscore, tmp_path):
    roscore.environment |= {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    config = tmp_path / "bridge.yaml"
    config.write_text(CONFIG, encoding="utf-8")
    bridge = start_robotui(roscore, "bridge", config, "--json", "--metrics", "0", name="bridge")
    roscore.start_tool("/usr/bin/python3", PEERS / "accountable_robot.py", "--lights", name="robot")
    visitor = start_visitor(roscore, "visitor", "--drive")

    heard = wait_for(lambda: scans(visitor, 20), seconds=120, what="a scan of ROS 1 at a node of ROS 2")
    assert (heard["frame"], heard["rays"], heard["first"]) == ("natalie/base_link", 301, -1.5)
    assert heard["youngest"] < 0.5, "stamps stay what they are"
    assert "hello from ROS 2" in roscore.tool("rostopic", "echo", "-n", "1", "/greeting"), "a message that was said once, before anybody listened"
    wait_for(lambda: 0.19 < roscore.odometry()[2] < 0.21, what="the robot to be driven, and not faster than the bridge allows")
    wait_for(lambda: line(bridge, "drive")["control"] == "Bridge drive", what="a line that says who has control")

    wait_for(lambda: lines(visitor)[-1].get("lights") == [True, "lights are True"], what="a node of ROS 2 to be answered by one of ROS 1")
    wait_for(lambda: "/reset" in roscore.tool("rosservice", "list").split(), what="the service of ROS 2 to be offered in ROS 1")
    assert roscore.tool("rosservice", "type", "/reset").strip() == "std_srvs/Trigger", "the type is that of the service that answers"
    assert roscore.tool("rosservice", "call", "/reset").split() == ["success:", "True", "message:", '"reset', "by", "ROS", '2"']
    wait_for(lambda: line(bridge, "reset")["passed"] == 1 and line(bridge, "lights")["passed"] >= 1, what="the calls to be counted")

    numbers = metrics(bridge)
    assert 'robotui_bridge_state{bridge="scan",from="Old.base.scan",to="New.base.natalie/scan",state="carrying"} 1' in numbers
    passed = next(float(row.split()[-1]) for row in numbers.splitlines() if row.startswith('robotui_bridge_passed_total{bridge="scan"'))
    assert passed >= 20

    end(visitor, how=signal.SIGKILL)                                   # who commanded is gone: the robot stands, and the lease is given back
    wait_for(lambda: roscore.odometry()[2] == 0, what="the robot to stand")
    kill_all_of(next(p for p in roscore.processes.running if p.out.name == "robot.out"))
    again = start_visitor(roscore, "again")
    roscore.start_tool("/usr/bin/python3", PEERS / "accountable_robot.py", "--no-queues", name="robot2")      # nothing is lost at the robot
    heard = wait_for(lambda: scans(again, 20), what="scans of a robot that came back")
    assert heard["gaps"] <= 1, "nothing is lost on the way"
    wait_for(lambda: line(bridge, "drive")["control"] == "", what="the lease to be given back")

    left = ours(roscore)
    kill_all_of(bridge)                         # the nodes of both sides go on, and the next bridge too
    robot = roscore.odometry()[0]
    said = len(lines(again))
    wait_for(lambda: len(lines(again)) > said, what="the node of ROS 2 to go on")
    passed = lines(again)[-1]["scans"]
    bridge = start_robotui(roscore, "bridge", config, "--json", name="bridge2")
    wait_for(lambda: scans(again, passed + 20), seconds=120, what="scans through the bridge that was started again")
    wait_for(lambda: not set(left) & set(ours(roscore)), what="the end of what the killed one left")
    assert roscore.odometry()[0] == robot, "nothing moved because of that"

    tell(bridge, signal.SIGTERM)
    bridge.wait(60)                             # a loaded machine takes its time to end a Java
    assert bridge.returncode == 143, bridge.err.read_text()
    wait_for(lambda: not ours(roscore), what="no node of ours in ROS 1")
    wait_for(lambda: lines(again)[-1]["nodes"] == ["visitor"], what=f"no node of ours in ROS 2; {lines(again)[-1]}")


def ours(roscore):
    return [node for node in roscore.nodes() if "robotui" in node]


ACTIONS = """
bridges:
  there:
    kind: action
    from: Old.new/navigate
    to: New.navigate_to_pose
    type: move_base_msgs/MoveBaseAction
    fields: {pose: target_pose}
    feedback: {base_position: current_pose}
    frame_prefix: natalie/
  back:
    kind: action
    from: New.old/move_base
    to: Old.move_base
    type: nav2_msgs/NavigateToPose
    fields: {target_pose: pose}
    feedback: {current_pose: base_position}
  watch: {from: Old.new/navigate/goal, to: New.goals, type: std_msgs/String, fields: {data: goal_id.id}, lease: false}   # beside the server of the action
ruics:
  Old: {type: single, view: status, rfics: {base: {type: ros}}}
  New: {type: single, view: status, rfics: {base: {type: ros2}}}
"""


def test_clients_of_actionlib_and_rclpy_have_goals_carried_out_by_each_others_servers(roscore, tmp_path):
    if subprocess.run(["/usr/bin/python3", "-c", "import actionlib, genpy.dynamic"], capture_output=True, check=False).returncode:
        pytest.skip("needs the Debian packages python3-actionlib python3-genpy")
    roscore.environment |= {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    config = tmp_path / "actions.yaml"
    config.write_text(ACTIONS, encoding="utf-8")
    bridge = start_robotui(roscore, "bridge", config, "--json", name="bridge")
    old = roscore.start_tool("/usr/bin/python3", PEERS / "rospy_actions.py", "/new/navigate", name="old")
    new = start_rclpy(roscore, "new", "rclpy_actions.py", "/old/move_base")

    said = wait_for(lambda: lines(old) and lines(old)[-1], 240, "the goals of actionlib's client; " + old.err.read_text())
    assert said == {"reached": ["SUCCEEDED", "", [["map", 2.0]]], "cancelled": ["PREEMPTED", "", [["map", 1000.0]]],
                    "rejected": ["REJECTED", said["rejected"][1], []]}
    assert "did not want the goal" in said["rejected"][1]
    said = wait_for(lambda: lines(new) and lines(new)[-1], 240, "the goals of rclpy's client; " + new.err.read_text())
    assert said == {"reached": ["SUCCEEDED", [["map", 2.0]]], "cancelled": ["CANCELED", [["map", 1000.0]]], "rejected": ["REJECTED", []]}
    wait_for(lambda: line(bridge, "there").get("passed") == 2 and line(bridge, "back").get("passed", 0) >= 2, what="the goals to be counted")
    wait_for(lambda: line(bridge, "there")["control"] == line(bridge, "back")["control"] == "", what="the leases to be given back")
    wait_for(lambda: line(bridge, "watch").get("passed", 0) >= 1, what="a goal to be seen by who watches its topic")


def start_visitor(roscore, name, *options):
    return start_rclpy(roscore, name, "bridge_visitor.py", *options)


def start_rclpy(roscore, name, program, *options):
    root = str(RCLPY.parent.parent)
    surroundings = roscore.environment | {"FASTDDS_BUILTIN_TRANSPORTS": "UDPv4", "LD_LIBRARY_PATH": f"{root}/lib", "AMENT_PREFIX_PATH": root}
    return roscore.processes.start([RCLPY, PEERS / program, *options], name, surroundings)


def lines(process):
    return [json.loads(row) for row in process.out.read_text().splitlines(keepends=True) if row.endswith("\n")]


def scans(visitor, least):
    said = lines(visitor)
    return said[-1] if said and said[-1]["scans"] >= least else None


def line(bridge, name):
    return next((row for row in reversed(lines(bridge)) if row["bridge"] == name), {"control": None})


def metrics(bridge):
    address = next(word for word in bridge.err.read_text().split() if word.startswith("http://127.0.0.1"))
    with urllib.request.urlopen(address, timeout=10) as answer:
        return answer.read().decode()


def test_what_cannot_be_bridged_is_said_with_its_place(environment, tmp_path):
    config = tmp_path / "loop.yaml"
    config.write_text(CONFIG.replace("drive: {from: New.drive", "back: {from: New.natalie/scan, to: Old.scan}\n  drive: {from: New.drive"), encoding="utf-8")
    answer = subprocess.run([ROOT / "robotui", "check", config], capture_output=True, text=True, timeout=60, env=environment, check=False)

    assert answer.returncode == 1, answer.stdout + answer.stderr
    assert f"{config}:5:3: error: the bridge 'back' closes a loop: New.base.natalie/scan -> Old.base.scan -> New.base.natalie/scan" in answer.stdout
