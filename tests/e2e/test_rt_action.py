"""Trajectories of the control in real time for Debian's own client of ROS actions: docs/rt-trajectories.md."""
import json
import pathlib
import subprocess

import pytest
import yaml

from conftest import RT_BIN, needs_rt, wait_for
from realtime import patient_arm

PEER = pathlib.Path(__file__).parent / "peers" / "follow_trajectory.py"
PYTHON = "/usr/bin/python3"
ACTION = "/xbotcore/JointTrajectory/follow_joint_trajectory"
CTL = str(RT_BIN / "robotui-rt-ctl")
SUCCESSFUL, INVALID_GOAL, INVALID_JOINTS, OLD_HEADER_TIMESTAMP, PATH_TOLERANCE_VIOLATED = 0, -1, -2, -3, -4

needs_ros = pytest.mark.skipif(not (RT_BIN / "robotui-rt-ros").exists(), reason="rt-native is built without ROS: libroscpp-dev and more are missing")
pytestmark = [needs_rt, needs_ros]


@pytest.fixture
def arm(roscore, tmp_path):
    if subprocess.run([PYTHON, "-c", "import actionlib, genpy.dynamic"], capture_output=True, check=False).returncode:
        pytest.skip("needs the Debian packages python3-actionlib python3-genpy")
    file = patient_arm(tmp_path)
    config = yaml.safe_load(file.read_text())
    config["MasterCommunicationInterface"]["framework_name"] = "ROS"
    file.write_text(yaml.safe_dump(config))
    run = tmp_path / "run"
    run.mkdir(mode=0o700)
    roscore.environment |= {"XDG_RUNTIME_DIR": str(run)}
    roscore.control = roscore.start_tool(RT_BIN / "robotui-rt", "-C", file, "--allow-non-rt", name="robotui-rt")

    def offered():
        try:
            return ACTION in roscore.tool("rostopic", "list") and "JointTrajectory" in roscore.tool(CTL, "list")
        except AssertionError:
            return False
    wait_for(offered, 60, "the action; " + roscore.control.err.read_text())
    return roscore


def follow(arm, scenario):
    return json.loads(arm.tool(PYTHON, str(PEER), ACTION, scenario, seconds=120).splitlines()[-1])


def test_the_client_of_actionlib_has_trajectories_followed_refused_replaced_and_cancelled(arm):
    stopped = follow(arm, "once")
    assert (stopped["state"], stopped["code"]) == ("REJECTED", INVALID_GOAL) and "start it first" in stopped["text"]
    arm.tool(CTL, "switch", "JointTrajectory", "1")

    said = follow(arm, "all")

    assert said["done"] == {"state": "SUCCEEDED", "code": SUCCESSFUL, "text": ""}
    feedback = said["feedback"]
    assert feedback["joints"] == ["shoulder_yaw", "elbow_pitch"] and feedback["count"] > 3 and feedback["time"] > 0.3
    assert feedback["desired"] == pytest.approx([0.4, 0.3], abs=0.2) and feedback["actual"] == pytest.approx(feedback["desired"], abs=0.1)
    assert feedback["error"] == pytest.approx([d - a for d, a in zip(feedback["desired"], feedback["actual"])], abs=1e-9)

    for goal, code, words in (("unknown", INVALID_JOINTS, "'tail' is no joint of this robot"), ("beyond", INVALID_GOAL, "beyond its limits"),
                              ("fast", INVALID_GOAL, "times its velocity limit"), ("old", OLD_HEADER_TIMESTAMP, "s ago"),
                              ("left out", INVALID_JOINTS, "it leaves out shoulder_yaw, which is moving")):
        assert (said[goal]["state"], said[goal]["code"]) == ("REJECTED", code), (goal, said[goal])
        assert words in said[goal]["text"]

    assert said["preempted"]["state"] == "PREEMPTED" and said["preempted"]["text"] == "another goal took over"
    assert said["taken over"]["state"] == "SUCCEEDED"
    assert said["cancelled"]["state"] == "PREEMPTED" and said["recalled"]["state"] == "RECALLED"
    assert (said["path"]["state"], said["path"]["code"]) == ("ABORTED", PATH_TOLERANCE_VIOLATED)
    assert " from its path" in said["path"]["text"]
    assert "running" in arm.tool(CTL, "status", "JointTrajectory"), "what ends a goal does not end the plugin"
