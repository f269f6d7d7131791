"""Trajectories of the control in real time for rclpy's own client of actions, over a bridge: docs/rt-trajectories.md."""
import json
import os
import pathlib

import pytest
import yaml

from conftest import ROOT, needs_rt, ros_domain, start_robotui, wait_for
from realtime import Control, patient_arm

PEERS = pathlib.Path(__file__).parent / "peers"
RCLPY = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "none")) / "rclpy/bin/python"
DOMAIN = ros_domain(2)
SUCCESSFUL, INVALID_GOAL, INVALID_JOINTS, PATH_TOLERANCE_VIOLATED = 0, -1, -2, -4

GENERATED = any(RCLPY.parent.parent.glob("lib/python3*/site-packages/control_msgs/made"))

pytestmark = [needs_rt, pytest.mark.skipif(not GENERATED, reason="control_msgs was not generated for rclpy (tools/ros2-interfaces.sh; ROBOTUI_ROS2_PEERS)")]


def shipped(folder):
    """The configuration as it is shipped, for a control that runs already."""
    config = yaml.safe_load((ROOT / "configs/arm-ros2.yaml").read_text())
    del config["control"]
    file = folder / "arm-ros2.yaml"
    file.write_text(yaml.safe_dump(config, sort_keys=False))
    return file


def test_the_client_of_rclpy_has_trajectories_followed_refused_and_cancelled(processes, environment, tmp_path):
    control = Control(processes, environment | {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}, tmp_path,
                      patient_arm(tmp_path))
    control.start()
    wait_for(control.is_up, 60, "the control")
    control.ctl("switch", "JointTrajectory", "1")
    start_robotui(control.robot, "bridge", shipped(tmp_path), "--json", name="bridge")
    root = str(RCLPY.parent.parent)
    surroundings = control.robot.environment | {"FASTDDS_BUILTIN_TRANSPORTS": "UDPv4", "LD_LIBRARY_PATH": f"{root}/lib", "AMENT_PREFIX_PATH": root}
    planner = processes.start([RCLPY, PEERS / "rclpy_trajectory.py", "/arm/follow_joint_trajectory"], "planner", surroundings)

    wait_for(lambda: planner.poll() is not None, 300, "the goals of rclpy's client")
    assert planner.returncode == 0, planner.err.read_text()
    said = json.loads(planner.out.read_text())

    assert said["done"] == ["SUCCEEDED", SUCCESSFUL, ""]
    feedback = said["feedback"]
    assert feedback["joints"] == ["shoulder_yaw", "elbow_pitch"] and feedback["count"] > 3
    assert feedback["desired"] == pytest.approx([0.4, 0.3], abs=0.2) and feedback["actual"] == pytest.approx(feedback["desired"], abs=0.1)
    assert feedback["error"] == pytest.approx([d - a for d, a in zip(feedback["desired"], feedback["actual"])], abs=1e-9)
    assert said["unknown"] == ["ABORTED", INVALID_JOINTS, "'tail' is no joint of this robot"]
    assert said["beyond"][:2] == ["ABORTED", INVALID_GOAL] and "beyond its limits" in said["beyond"][2]
    assert said["cancelled"] == ["CANCELED", SUCCESSFUL, "cancelled"]
    assert said["path"][:2] == ["ABORTED", PATH_TOLERANCE_VIOLATED] and " from its path" in said["path"][2]
    assert "running" in control.ctl("status", "JointTrajectory"), "what ends a goal does not end the plugin"
