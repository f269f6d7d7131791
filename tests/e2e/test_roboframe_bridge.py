"""An application of RoboFrame and nodes of rospy share channels by ./robotui bridge: both directions at once, a type that only the application knows, and each party killed and back."""
import re
import signal
import subprocess

from conftest import end, free_port, kill_all_of, start_robotui, start_sim_program, tell, wait_for
from test_bridge import PEERS

CONFIG = """
bridges:
  scan: {from: Striker.laser/scan, to: Keeper.striker/scan, frame_prefix: striker/}
  odometry: {from: Striker.odometry, to: Keeper.striker/odom}
  ball:
    from: Striker.soccer/ball
    to: Keeper.striker/ball
    type: geometry_msgs/PointStamped
    fields: {header.frame_id: "'map'", point.x: x_mm * 0.001, point.y: y_mm * 0.001}
    lease: false
  mate: {from: Keeper.odom, to: Striker.team/mate}
  believed: {from: Striker.team/model, to: Keeper.striker/believed, type: geometry_msgs/Point, fields: {x: mate_x_mm * 0.001, y: mate_y_mm * 0.001}, lease: false}
  steering: {from: Keeper.striker/cmd_vel, to: Striker.drive/velocity, max_linear: 0.2}
ruics:
  Striker: {type: single, view: text, rfics: {base: {type: roboframe, port: PORT}}}
  Keeper: {type: single, view: text, rfics: {base: {type: ros}}}
"""


class Listening:
    """What rostopic hears of a topic, from now on."""

    def __init__(self, roscore, name, topic):
        self.process = roscore.start_tool("rostopic", "echo", topic, name=name)

    def text(self):
        return self.process.out.read_text()

    def hears_more(self):
        before = len(self.text())
        return wait_for(lambda: len(self.text()) > before and self.text()[before:], seconds=120, what=" ".join(map(str, self.process.args)))


def test_an_application_and_nodes_share_channels_and_come_back(roscore, processes, environment, tmp_path):
    roscore.environment["PYTHONUNBUFFERED"] = "1"                                 # what rostopic hears is to be seen at once
    port = free_port()
    config = tmp_path / "bridge.yaml"
    config.write_text(CONFIG.replace("PORT", str(port)), encoding="utf-8")
    bridge = start_robotui(roscore, "bridge", config, name="bridge")              # before either side is there
    scans = Listening(roscore, "scans", "/striker/scan/header")
    ball = Listening(roscore, "ball", "/striker/ball/point")
    speed = Listening(roscore, "speed", "/striker/odom/twist")
    believed = Listening(roscore, "believed", "/striker/believed")
    keeper = start_keeper(roscore, "keeper")
    striker = start_striker(processes, environment, port, "striker")

    assert "striker/laser" in scans.hears_more(), "roboframe/Scan became sensor_msgs/LaserScan"
    assert "x: " in ball.hears_more(), "soccer/BallModel became geometry_msgs/PointStamped"
    assert "x: 0.0" in believed.hears_more(), "nav_msgs/Odometry reached a module, and what that made of it came back"
    stick = roscore.start_tool("rostopic", "pub", "-r", "10", "/striker/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 0.5}}", name="stick")
    wait_for(lambda: 0.15 < fastest(speed) < 0.22, what="the robot of RoboFrame to be driven by a node of ROS, and not faster than the bridge allows")
    end(stick, how=signal.SIGKILL)

    end(striker, how=signal.SIGKILL)
    start_striker(processes, environment, port, "striker2")
    scans.hears_more()
    kill_all_of(keeper)
    keeper = start_keeper(roscore, "keeper2")
    believed.hears_more()
    kill_all_of(bridge)                                                           # the adapter itself
    bridge = start_robotui(roscore, "bridge", config, name="bridge2")
    scans.hears_more()
    believed.hears_more()
    tell(bridge, signal.SIGINT)
    bridge.wait(60)
    assert bridge.returncode == 130, bridge.err.read_text()


def fastest(speed):
    """Forward, as the first number of each message says it."""
    said = re.findall(r"linear:\s+x: (\S+)\n", speed.text())
    return max(map(float, said), default=0)


def start_keeper(roscore, name):
    return roscore.start_tool("/usr/bin/python3", PEERS / "accountable_robot.py", name=name)


def start_striker(processes, environment, port, name):
    striker = start_sim_program(processes, environment, name, ["org.robotui.roboframe"], "--robot", "natalie", "--speak", "roboframe", "--roboframe-port", str(port))
    wait_for(lambda: "ROBOFRAME_ADDR=" in striker.out.read_text() or fallen(striker), seconds=90, what="the application")
    return striker


def fallen(process):
    if process.poll() is not None:
        raise subprocess.CalledProcessError(process.returncode, process.args, stderr=process.err.read_text())
    return False
