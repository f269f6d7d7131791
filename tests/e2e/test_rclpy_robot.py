"""A robot of rclpy, and a program of Cyclone DDS: found without configuration, seen, driven, gone and back, left as they were."""
import os
import pathlib
import signal

import pytest

from conftest import end, last_of, ros_domain, start_robotui, wait_for
from desktop import Keys, Window, missing

PEERS = pathlib.Path(__file__).parent / "peers"
DOMAIN = ros_domain(0)
CYCLONE = ("<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast><Interfaces><NetworkInterface name=\"lo\" multicast=\"false\"/>"
           "</Interfaces></General><Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>30</MaxAutoParticipantIndex>"
           "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>")


def python_of(peer):
    root = os.environ.get("ROBOTUI_ROS2_PEERS")
    python = pathlib.Path(root, peer, "bin", "python") if root else None
    if python is None or not python.exists():
        pytest.skip(f"{peer} is not installed (ROBOTUI_ROS2_PEERS)")
    return python


class Domain:
    """Where robots of ROS 2 are: what start_robotui and Window need of a robot."""

    uri = "ROS 2"

    def __init__(self, processes, environment):
        self.processes = processes
        self.environment = environment | {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}

    def rclpy(self, name):
        python = python_of("rclpy")
        root = str(python.parent.parent)
        surroundings = self.environment | {"FASTDDS_BUILTIN_TRANSPORTS": "UDPv4", "LD_LIBRARY_PATH": f"{root}/lib", "AMENT_PREFIX_PATH": root}
        robot = self.processes.start([python, PEERS / "rclpy_robot.py"], name, surroundings)
        wait_for(lambda: "ready" in lines(robot), seconds=60, what="the robot")
        return robot

    def cyclone(self):
        python = python_of("cyclone")
        return self.processes.start([python, PEERS / "cyclone_robot.py", DOMAIN], "cyclone", self.environment | {"CYCLONEDDS_URI": CYCLONE})


@pytest.fixture
def domain(processes, environment):
    return Domain(processes, environment)


def lines(robot):
    return robot.out.read_text().splitlines()


def said(robot, word):
    return [line.split()[1:] for line in lines(robot) if line.startswith(f"{word} ")]


def nodes(robot):
    return (said(robot, "nodes") or [[]])[-1]


def line_of(robotui, port, is_live, least=5):
    line = last_of(robotui, port)
    return line if line and (line["link"] == "connected" and line["rate_hz"] > least and line["age_s"] < 1) == is_live else None


def test_it_is_found_and_all_that_it_offers_is_live(domain):
    robotui = start_robotui(domain, "run", "--json", "ros2")
    domain.rclpy("robot")

    for port in ("scan", "odom", "battery_state"):
        line = wait_for(lambda: line_of(robotui, port, True), seconds=60, what=f"a live {port}")
        assert line["dropped"] == 0
    wait_for(lambda: line_of(robotui, "rosout", True, least=0.5), what="the log")
    for port in ("map", "robot_description"):
        wait_for(lambda: (line := last_of(robotui, port)) and line["age_s"] is not None and line["age_s"] >= 0, what=f"the {port}")


def test_it_is_taken_up_again_when_it_was_killed_and_started_anew(domain):
    robot = domain.rclpy("robot1")
    robotui = start_robotui(domain, "run", "--json", "ros2")
    wait_for(lambda: line_of(robotui, "scan", True), seconds=60, what="a live scan")

    end(robot, how=signal.SIGKILL)
    wait_for(lambda: line_of(robotui, "scan", False), what="the loss")
    domain.rclpy("robot2")
    wait_for(lambda: line_of(robotui, "scan", True), seconds=60, what="its return")


def test_closing_leaves_no_trace(domain):
    robot = domain.rclpy("robot")
    wait_for(lambda: nodes(robot) == ["base"], what=lambda: f"the robot alone; it sees {nodes(robot)}")
    robotui = start_robotui(domain, "run", "--json", "ros2")
    wait_for(lambda: line_of(robotui, "odom", True), seconds=60, what="the odometry")
    wait_for(lambda: len(nodes(robot)) == 2, what="our node")

    os.kill(robotui.pid, signal.SIGTERM)
    robotui.wait(60)
    wait_for(lambda: nodes(robot) == ["base"], what=lambda: f"the robot to be alone again; it sees {nodes(robot)}")
    assert not said(robot, "drive"), "nobody drove it"


def test_a_program_that_knows_only_dds_is_seen(domain):
    domain.cyclone()
    robotui = start_robotui(domain, "run", "--json", "ros2")

    for port in ("chatter", "level", "wind"):
        wait_for(lambda: line_of(robotui, port, True), seconds=60, what=f"a live {port}")


@pytest.mark.skipif(bool(missing()), reason=f"tests in a window need {missing()}")
def test_it_is_driven_from_the_window_and_stops_when_the_key_is_let_go(domain):
    robot = domain.rclpy("robot")
    window = Window.open(domain, "ros2")
    wait_for(window.is_live, seconds=60, what="a live robot")
    keys = Keys()
    try:
        window.click(wait_for(window.stick, what="the stick"))
        keys.hold("w")
        wait_for(lambda: any(float(linear) > 0.1 for linear, _ in said(robot, "drive")), what="motion")
    finally:
        keys.let_go()
    wait_for(lambda: said(robot, "drive")[-1] == ["0.0", "0.0"], what="a stop")
