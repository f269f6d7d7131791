"""A robot of rospy at a real roscore: what comes first, what goes and comes back."""
import pathlib
import signal

import pytest

from conftest import Robot, end, free_port, kill_all_of, last_of, listening, start_robotui, wait_for

SCRIPT = pathlib.Path(__file__).parent / "peers" / "rospy_robot.py"


@pytest.fixture
def graph(processes, environment, ros_tools):
    port = free_port()
    robot = Robot(processes, f"http://127.0.0.1:{port}", environment)
    robot.port = port
    return robot


def start_master(graph, name):
    core = graph.start_tool("roscore", "-p", str(graph.port), name=name)
    wait_for(lambda: listening(graph.port), what="the master")
    return core


def start_publisher(graph, name):
    return graph.start_tool("/usr/bin/python3", str(SCRIPT), name=name)


def line_of(robotui, port, is_live):
    line = last_of(robotui, port)
    return line if line and (line["link"] == "connected" and line["rate_hz"] > 5 and line["age_s"] < 1) == is_live else None


def comes_alive(robotui):
    for port in ("scan", "odom"):
        wait_for(lambda: line_of(robotui, port, True), what=f"a live {port}")


def goes(robotui):
    for port in ("scan", "odom"):
        wait_for(lambda: line_of(robotui, port, False), what=f"the loss of {port}")


@pytest.mark.parametrize("order", [(start_master, start_publisher), (start_publisher, start_master)], ids=["master-first", "publisher-first"])
def test_master_and_robot_that_were_killed_are_taken_up_again_in_any_order(graph, order):
    robotui = start_robotui(graph, "run", "--json", "ros")
    parts = [start(graph, f"{start.__name__}1") for start in order]
    comes_alive(robotui)

    for part in parts:
        kill_all_of(part)
    wait_for(lambda: not listening(graph.port), what="the master's end")
    goes(robotui)
    for start in order:
        start(graph, f"{start.__name__}2")
    comes_alive(robotui)


def test_a_publisher_alone_may_go_and_come_back(graph):
    start_master(graph, "master")
    publisher = start_publisher(graph, "publisher1")
    robotui = start_robotui(graph, "run", "--json", "ros")
    comes_alive(robotui)

    end(publisher, how=signal.SIGKILL)
    goes(robotui)
    start_publisher(graph, "publisher2")
    comes_alive(robotui)
