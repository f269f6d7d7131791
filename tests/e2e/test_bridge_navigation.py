"""Robots of CARMEN, Player and YARP are driven to a goal by a node of rospy, then by one of rclpy, and a robot of rospy by a program of LCM: each knows only
what ./robotui bridge carries."""
import random
import shutil
import signal
import subprocess

import pytest

from conftest import end, ros_domain, start_robotui, wait_for
from test_bridge import PEERS, RCLPY, line, lines, start_rclpy

ROBOTS = {
    "carl": ("carmen", "base_odometry", "robot_frontlaser", "velocity"),
    "keira": ("player", "position2d:0", "laser:0", "position2d:0/velocity"),
    "yuki": ("{type: yarp, prefix: /natalie}", "odo/odometry", "laser", "base/velocity"),
}
SIMULATOR = "simulator: [{robot: natalie, speaks: carmen}, {robot: keira, speaks: player}, {robot: natalie, speaks: yarp}]\n"


def config():
    bridges, robots = "", ""
    for name, (framework, odometry, scan, velocity) in ROBOTS.items():
        robots += f"  {name.title()}: {{type: single, view: status, rfics: {{base: {framework}}}}}\n"
        for ros in ("Old", "New"):
            bridges += f"""  {name}_odom_{ros}: {{from: "{name.title()}.{odometry}", to: {ros}.{name}/odom, frame_prefix: {name}/}}
  {name}_scan_{ros}: {{from: "{name.title()}.{scan}", to: {ros}.{name}/scan, frame_prefix: {name}/, rate: 5}}
  {name}_drive_{ros}: {{from: {ros}.{name}/cmd_vel, to: "{name.title()}.{velocity}", max_linear: 0.25}}
"""
    return (f"{SIMULATOR}bridges:\n{bridges}ruics:\n{robots}  Old: {{type: single, view: status, rfics: {{base: {{type: ros}}}}}}\n"
            "  New: {type: single, view: status, rfics: {base: {type: ros2}}}\n")


@pytest.mark.skipif(not RCLPY.exists(), reason="rclpy is not installed (ROBOTUI_ROS2_PEERS)")
def test_robots_of_carmen_player_and_yarp_reach_goals_under_nodes_of_rospy_and_rclpy(roscore, tmp_path):
    roscore.environment |= {"ROS_DOMAIN_ID": str(ros_domain(3)), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    written = tmp_path / "navigation.yaml"
    written.write_text(config(), encoding="utf-8")
    bridge = start_robotui(roscore, "bridge", written, "--json", name="bridge")

    old = roscore.start_tool("/usr/bin/python3", PEERS / "navigator.py", "ros1", *ROBOTS, name="navigator1")
    navigates(old, bridge, "Old")
    end(old, how=signal.SIGKILL)                                # what it drove stands, and may be driven by others
    wait_for(lambda: all(line(bridge, f"{name}_drive_Old")["control"] == "" for name in ROBOTS), 120, "the leases to be given back")
    new = start_rclpy(roscore, "navigator2", "navigator.py", "ros2", *ROBOTS)
    navigates(new, bridge, "New")


def navigates(node, bridge, ros):
    wait_for(lambda: len(lines(node)) == len(ROBOTS), 300, f"the robots to reach their goals; {lines(node)} {node.err.read_text()} {bridge.err.read_text()}")
    for told in lines(node):
        assert told["moved"] > 0.1 and told["left"] < 0.1 and told["scans"] > 0, told
    wait_for(lambda: all(line(bridge, f"{name}_drive_{ros}").get("passed", 0) > 2 for name in ROBOTS), what="the commands to be counted")


TYPES = """package demo;
struct pose_t { int64_t utime; double x_mm; string frame; }
struct drive_t { int64_t utime; double forward_mm_s; double turn_deg_s; }
"""
LCM = """
bridges:
  pose: {from: Old.odom, to: Lena.POSE, type: demo.pose_t, fields: {utime: round(stamp / 1000), x_mm: pose.pose.position.x * 1000, frame: "'old/odom'"}, lease: false}
  drive: {from: Lena.DRIVE, to: Old.cmd_vel, fields: {linear.x: forward_mm_s * 0.001, angular.z: turn_deg_s * 0.0174533}, max_linear: 0.15}
ruics:
  Old: {type: single, view: status, rfics: {base: {type: ros}}}
  Lena:
    type: single
    view: status
    rfics:
      base: {type: lcm, url: "URL", types: demo.lcm}
"""


@pytest.mark.skipif(shutil.which("lcm-gen") is None, reason="lcm-gen is not installed (liblcm-bin)")
def test_a_program_of_lcm_drives_a_robot_of_rospy_and_hears_where_it_is(roscore, tmp_path):
    url = f"udpm://239.255.76.67:{random.randint(30000, 32000)}?ttl=0"
    (tmp_path / "demo.lcm").write_text(TYPES, encoding="ascii")
    subprocess.run(["lcm-gen", "-p", "--ppath", tmp_path / "types", tmp_path / "demo.lcm"], check=True, timeout=60)
    written = tmp_path / "lcm.yaml"
    written.write_text(LCM.replace("URL", url), encoding="utf-8")
    bridge = start_robotui(roscore, "bridge", written, "--json", name="bridge")
    roscore.start_tool("/usr/bin/python3", PEERS / "accountable_robot.py", name="robot")
    lena = roscore.start_tool("/usr/bin/python3", PEERS / "lcm_stock.py", url, tmp_path / "types", name="lena")

    said = wait_for(lambda: next((each for each in lines(lena) if each["x_mm"] > 100), None), 180,
                    f"the robot to have been driven for 100 mm; {lena.err.read_text()} {bridge.err.read_text()}")
    assert said["frame"] == "old/odom" and said["utime"] > 1e15
    assert 0.14 < roscore.odometry()[2] < 0.16, "not faster than the bridge allows"
    assert line(bridge, "drive")["control"] == "Bridge drive"
