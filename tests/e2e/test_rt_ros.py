"""The tutorial of the paper with the control in real time and Debian's tools: docs/rt-ros.md."""
import contextlib
import os
import signal

import pytest
import yaml

from conftest import ROOT, RT_BIN, end, listening, needs_rt, processes_of, wait_for

ARM = ROOT / "configs/arm"
COMMAND = """header: {seq: 0, stamp: {secs: 0, nsecs: 0}, frame_id: ''}
name: ['shoulder_yaw']
position: [%s]
velocity: [0]
effort: [0]
stiffness: [0]
damping: [0]
ctrl_mode: [%d]
aux_name: ''
aux: [0]"""

needs_ros = pytest.mark.skipif(not (RT_BIN / "robotui-rt-ros").exists(), reason="rt-native is built without ROS: libroscpp-dev and more are missing")
pytestmark = [needs_rt, needs_ros]


class Control:
    """robotui-rt with the demo's arm and what of it is seen in ROS."""

    def __init__(self, robot, folder, master="ROS"):
        self.robot = robot
        self.config = folder / "arm.yaml"
        self.config.write_text(yaml.safe_dump({
            "XBotInterface": {"urdf_path": str(ARM / "arm.urdf"), "srdf_path": str(ARM / "arm.srdf"),
                              "joint_map_path": str(ARM / "joint_map.yaml")},
            # Machines that run tests are late now and then: that is not what is looked at here.
            "HALInterface": {"type": "dummy", "misses_before_safe": 1000},
            "MasterCommunicationInterface": {"framework_name": master},
            "XBotRTPlugins": {"plugins": [{"name": "HomingExample", "type": "Homing", "params": {"time": 1}}, "XBotCommunicationPlugin",
                                          {"name": "RosExample", "params": {"joint": "wrist_roll"}}]}}))
        run = folder / "run"
        run.mkdir(mode=0o700)
        robot.environment |= {"XDG_RUNTIME_DIR": str(run), "PYTHONPATH": str(ROOT / "rt-native/target/release/python"),
                              "ROS_PACKAGE_PATH": str(ROOT / "rt-native/ros")}
        self.process = robot.start_tool(RT_BIN / "robotui-rt", "-C", self.config, "-D", "--allow-non-rt", name="robotui-rt")
        # The supervisor starts the face where ROS is the master; beside another master it is started by hand.
        self.face = self.process if master == "ROS" else robot.start_tool(RT_BIN / "robotui-rt-ros", "-C", self.config, "-D", name="robotui-rt-ros")
        self.wait_for_services()

    def wait_for_services(self):
        def there():
            try:
                return "/xbotcore/HomingExample_switch" in self.robot.tool("rosservice", "list")
            except AssertionError:
                return False
        wait_for(there, 60, "the services; " + self.log())
        self.joints()

    def log(self):
        return "".join(each.err.read_text() for each in dict.fromkeys((self.process, self.face)))

    def switch(self, plugin, wanted):
        return self.robot.tool("rosservice", "call", f"/xbotcore/{plugin}_switch", wanted)

    def joints(self):
        message = next(yaml.safe_load_all(self.robot.tool("rostopic", "echo", "-n", "1", "/xbotcore/joint_states")))
        return dict(zip(message["name"], message["link_position"]))

    def command(self, position, mode=1):
        self.robot.tool("rostopic", "pub", "-1", "/xbotcore/command", "xbot_msgs/JointCommand", COMMAND % (position, mode))

    def reference(self, position):
        """What the workbench does when it commands a joint: a client of the framework robotui."""
        return self.robot.tool(str(RT_BIN / "robotui-rt-ctl"), "reference", f"shoulder_yaw={position}", "--for", "1")

    def is_at(self, position):
        return abs(self.joints()["shoulder_yaw"] - position) < 0.01

    def pid_of(self, program):
        return next(iter(processes_of(program, self.config)), None)


@pytest.fixture
def control(roscore, tmp_path):
    return Control(roscore, tmp_path)


def test_the_tutorial_can_be_followed(control):
    robot = control.robot
    assert "xbot_msgs/JointState" in robot.tool("rostopic", "type", "/xbotcore/joint_states")
    assert "xbot_msgs/JointCommand" in robot.tool("rostopic", "type", "/xbotcore/command")
    assert "std_srvs/SetBool" in robot.tool("rosservice", "type", "/xbotcore/HomingExample_switch")
    assert "<robot" in robot.tool("rosparam", "get", "/xbotcore/robot_description")
    assert "wrench" in robot.tool("rostopic", "echo", "-n", "1", "/xbotcore/ft/wrist_ft")

    assert "success: True" in control.switch("HomingExample", "1")
    wait_for(lambda: abs(control.joints()["elbow_pitch"]) > 0.3, what="the posture home; " + control.log())
    assert "running" in robot.tool("rosservice", "call", "/xbotcore/HomingExample_status")
    assert "success: False" in robot.tool("rosservice", "call", "/xbotcore/HomingExample_cmd", "nonsense")
    refused = control.switch("XBotCommunicationPlugin", "1")
    assert "success: False" in refused and "HomingExample" in refused

    assert "success: True" in control.switch("HomingExample", "0")
    assert "success: True" in control.switch("XBotCommunicationPlugin", "1")
    control.command(0.5)
    wait_for(lambda: abs(control.joints()["shoulder_yaw"] - 0.5) < 0.01, what=f"the joint at its reference, not at {control.joints()}; " + control.log())


def test_where_ros_is_the_master_it_commands_and_the_workbench_does_not(control):
    assert "success: True" in control.switch("XBotCommunicationPlugin", "1")
    control.command(0.5)
    wait_for(lambda: control.is_at(0.5), what="the joint at the reference of ROS; " + control.log())
    with pytest.raises(AssertionError, match="The master framework of this robot is ROS: references of robotui do not count"):
        control.reference(-0.3)
    assert control.is_at(0.5)


def test_where_the_workbench_is_the_master_it_commands_and_ros_does_not(roscore, tmp_path):
    control = Control(roscore, tmp_path, master="robotui")
    assert "success: True" in control.switch("XBotCommunicationPlugin", "1")
    before = control.joints()["shoulder_yaw"]
    control.command(before + 0.5)
    wait_for(lambda: "The master framework of this robot is robotui: references of ROS do not count" in control.log(), what="a word about it")
    assert control.is_at(before)

    def follows():
        with contextlib.suppress(AssertionError):       # of a client that was late, and so lost the robot again
            control.reference(before + 0.3)
        return control.is_at(before + 0.3)
    wait_for(follows, what="the joint at the reference of its master; " + control.log())


def test_frames_follow_the_joints(control):
    frames = next(yaml.safe_load_all(control.robot.tool("rostopic", "echo", "-n", "1", "/tf")))["transforms"]
    assert len(frames) == 7
    assert all(abs(sum(f["transform"]["rotation"][axis] ** 2 for axis in "xyzw") - 1) < 1e-6 for f in frames)


def test_a_command_that_is_none_changes_nothing_and_is_told(control):
    control.switch("XBotCommunicationPlugin", "1")
    before = control.joints()["shoulder_yaw"]
    control.command(".nan")
    wait_for(lambda: "no number" in control.log(), what="a word about it")
    control.command(0.4, mode=64)
    wait_for(lambda: "ctrl_mode of shoulder_yaw" in control.log(), what="a word about it")
    assert control.joints()["shoulder_yaw"] == pytest.approx(before, abs=1e-3)


def test_a_ros_process_that_is_killed_comes_again_and_the_robot_goes_on(control):
    control.switch("HomingExample", "1")
    hal = control.pid_of("robotui-rt-hal")
    ros = control.pid_of("robotui-rt-ros")
    os.kill(ros, signal.SIGKILL)
    wait_for(lambda: control.pid_of("robotui-rt-ros") not in (None, ros), what="another ROS process")
    control.wait_for_services()
    assert control.pid_of("robotui-rt-hal") == hal
    assert "running" in control.robot.tool("rosservice", "call", "/xbotcore/HomingExample_status")


def test_it_registers_with_a_master_that_was_started_anew(control):
    robot = control.robot
    ros = control.pid_of("robotui-rt-ros")
    end(robot.core)
    wait_for(lambda: not listening(robot.port), what="the master's end")
    robot.core = robot.start_tool("roscore", "-p", str(robot.port), name="roscore2")
    wait_for(lambda: listening(robot.port), what="roscore")
    control.wait_for_services()
    assert "<robot" in robot.tool("rosparam", "get", "/xbotcore/robot_description")
    assert "success: True" in control.switch("HomingExample", "1")
    assert control.pid_of("robotui-rt-ros") == ros


def test_a_plugin_has_topics_a_service_and_parameters(control):
    robot = control.robot
    wait_for(lambda: "/xbotcore/RosExample/hold" in robot.tool("rosservice", "list"), what="the service of the plugin")
    wait_for(lambda: "/xbotcore/RosExample/set_parameters" in robot.tool("rosservice", "list"), what="its parameters")
    assert "success: True" in control.switch("RosExample", "1")

    robot.tool("rostopic", "echo", "-n", "3", "/xbotcore/RosExample/position")
    robot.tool("rosservice", "call", "/xbotcore/RosExample/set_parameters",
               "{config: {doubles: [{name: amplitude, value: 0.0}, {name: frequency, value: 99}]}}")
    parameters = robot.tool("rostopic", "echo", "-n", "1", "/xbotcore/RosExample/parameter_updates")
    values = {each["name"]: each["value"] for each in next(yaml.safe_load_all(parameters))["doubles"]}
    assert values == {"amplitude": 0.0, "frequency": 1.0}

    before = control.joints()["wrist_roll"]
    robot.tool("rostopic", "pub", "-1", "/xbotcore/RosExample/offset", "std_msgs/Float64", "0.3")
    wait_for(lambda: control.joints()["wrist_roll"] > before + 0.15, what="the joint to follow the topic; " + control.log())
    assert "holds" in robot.tool("rosservice", "call", "/xbotcore/RosExample/hold", "1")


def test_a_plugin_that_is_loaded_anew_has_its_service_again(control):
    robot = control.robot
    hold = "/xbotcore/RosExample/hold"
    wait_for(lambda: hold in robot.tool("rosservice", "list"), what="the service of the plugin")
    for _ in range(2):
        robot.tool(str(RT_BIN / "robotui-rt-ctl"), "reload", "RosExample")
        assert "success: True" in control.switch("RosExample", "1")
        wait_for(lambda: hold in robot.tool("rosservice", "list"), what="the service again")
        assert "holds" in robot.tool("rosservice", "call", hold, "1")
        assert "success: True" in control.switch("RosExample", "0")


def test_a_ros_process_that_hangs_is_replaced_and_the_robot_goes_on(control):
    hal, ros = control.pid_of("robotui-rt-hal"), control.pid_of("robotui-rt-ros")
    os.kill(ros, signal.SIGSTOP)
    assert "HomingExample" in control.robot.tool(str(RT_BIN / "robotui-rt-ctl"), "list")
    wait_for(lambda: control.pid_of("robotui-rt-ros") not in (None, ros), 60, what="another ROS process; " + control.log())
    control.wait_for_services()
    assert control.pid_of("robotui-rt-hal") == hal


def test_messages_without_sense_end_nothing(control):
    robot = control.robot
    ros = control.pid_of("robotui-rt-ros")
    robot.tool("rostopic", "pub", "-1", "/xbotcore/RosExample/offset", "std_msgs/Float64", ".inf")
    robot.tool("rostopic", "pub", "-1", "/xbotcore/command", "xbot_msgs/JointCommand", "{name: ['" + "x" * 50000 + "'], ctrl_mode: [1]}")
    control.joints()
    assert control.pid_of("robotui-rt-ros") == ros
