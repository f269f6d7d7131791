"""The simulated robot as a program of ROS 2 meets it: rclpy on Fast DDS."""
import json
import os
import pathlib
import subprocess

import pytest

from conftest import start_sim_program, wait_for

PEERS = pathlib.Path(__file__).parent / "peers"
HOME = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "none")) / "rclpy"
BUNDLES = ("org.robotui.ros2", "org.robotui.rtps")

pytestmark = pytest.mark.skipif(not (HOME / "bin/python").exists(), reason="there is no rclpy (ROBOTUI_ROS2_PEERS)")


def surroundings(domain):
    return dict(os.environ) | {
        "ROS_DOMAIN_ID": domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "FASTDDS_BUILTIN_TRANSPORTS": "UDPv4",
        "LD_LIBRARY_PATH": str(HOME / "lib"), "AMENT_PREFIX_PATH": str(HOME)}


@pytest.fixture
def visit(processes, environment):
    return start(processes, environment)


def start(processes, environment, *options):
    """The robot in a domain that was free, and what runs one task of ros2_visitor.py there."""
    process = start_sim_program(processes, environment, "simulator", BUNDLES, "--speak", "ros2", *options)
    domain = wait_for(lambda: process.out.read_text().strip(), seconds=60, what="the simulator").removeprefix("ROS_DOMAIN_ID=")

    def visit(*words):
        command = [HOME / "bin/python", PEERS / "ros2_visitor.py", *map(str, words)]
        done = subprocess.run(command, env=surroundings(domain), capture_output=True, text=True, timeout=150, check=False)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout.splitlines()[-1])
    return visit


def generated(package):
    if subprocess.run([HOME / "bin/python", "-c", f"import {package}"], env=surroundings("0"), capture_output=True, check=False).returncode:
        pytest.skip(f"{package} was not generated for rclpy (tools/ros2-interfaces.sh)")


def test_the_graph_is_that_of_a_robot(visit):
    graph = visit("graph")
    types = {"/scan": "sensor_msgs/msg/LaserScan", "/odom": "nav_msgs/msg/Odometry", "/tf": "tf2_msgs/msg/TFMessage", "/map": "nav_msgs/msg/OccupancyGrid",
             "/cmd_vel": "geometry_msgs/msg/Twist", "/diagnostics": "diagnostic_msgs/msg/DiagnosticArray", "/objects": "visualization_msgs/msg/MarkerArray"}
    assert {topic: graph["topics"][topic] for topic in types} == {topic: [name] for topic, name in types.items()}
    assert graph["services"]["/robot/set_parameters"] == ["rcl_interfaces/srv/SetParameters"]
    assert graph["services"]["/navigate_to_pose/_action/send_goal"] == ["nav2_msgs/action/NavigateToPose_SendGoal"]
    kept, state, sensor = ["RELIABLE", "TRANSIENT_LOCAL"], ["RELIABLE", "VOLATILE"], ["BEST_EFFORT", "VOLATILE"]
    assert graph["qos"] == {"/scan": sensor, "/camera/image_raw": sensor, "/odom": state, "/tf": state, "/map": kept, "/tf_static": kept,
                            "/robot_description": kept, "/rosout": kept}


def test_what_it_senses_and_is_arrives_soon(visit):
    seen = visit("sensors")
    assert seen["rays"] == 361 and seen["step"] == 16 and seen["depth"] == "16UC1" and seen["jpeg"] == "ffd8"
    assert seen["map"][0] == seen["map"][1] > 10_000
    assert seen["image"] == ["rgb8", 3 * 320 * 240]
    assert "<robot name=" in seen["urdf"] and "pan_joint" in seen["joints"]
    late = {topic: at for topic, at in seen["at"].items() if topic in ("map", "robot_description") and at > 1.5}
    assert not late, "what is kept for late subscribers has to be asked for"


def test_it_drives_as_told_and_stops_half_a_second_after_the_last_command(visit):
    driven = visit("drive")
    assert 0.3 < driven["stopped"] < 2
    assert driven["logger"] == "robot" and "timed out" in driven["log"]


def test_services_are_answered(visit):
    answers = visit("services")
    assert answers["motors"] == [True, "motors on"] and answers["stop"] == [True, "stopped"] and answers["map"] > 10_000


def test_its_parameters_are_described_set_within_their_ranges_and_told(visit):
    found = visit("parameters")
    assert {"max_linear_speed", "driving_style", "person_walks"} <= set(found["names"])
    assert found["range"] == [0.05, 1.5] and found["taken"] == [True, ""] and found["style"] == [True, ""]
    assert not found["refused"][0] and "1.5" in found["refused"][1]
    assert abs(found["after"] - 0.2) < 1e-6


def test_it_describes_the_types_of_its_messages(visit):
    told = visit("describe")
    assert told["found"] and told["type"] == "visualization_msgs/msg/MarkerArray" and told["fields"] == ["markers"]
    assert "visualization_msgs/msg/Marker" in told["referenced"] and "std_msgs/msg/Header" in told["referenced"]
    assert not told["other"], "another sum is another type"


def test_time_is_the_robots_own_where_it_is_asked_for(processes, environment):
    assert start(processes, environment, "--sim-time", "--speed-factor", "5")("clock")["seconds"] < 3600


def test_the_stock_action_client_drives_it_to_goals_and_cancels(visit):
    generated("nav2_msgs.action")
    near = visit("navigate", 0.8, 0, "base_link", 0)
    assert near["state"] == "SUCCEEDED" and near["feedback"] > 3 and near["frame"] == "map"
    assert near["left"][0] > near["left"][-1]
    wall = visit("navigate", 5, 2, "map", 0)
    assert wall["state"] == "ABORTED" and "obstacle" in wall["text"]
    assert visit("navigate", 1, 1, "moon", 0)["state"] == "REJECTED"
    assert visit("navigate", 12, 5, "map", 3)["state"] == "CANCELED"


def test_the_waypoint_is_a_marker_that_can_be_moved(visit):
    generated("visualization_msgs.srv")
    moved = visit("markers")
    assert moved["markers"] == ["waypoint"] and moved["place"] == [2.6, 3.2] and moved["objects"] > 10
    assert moved["numbers"][1] > moved["numbers"][0]
