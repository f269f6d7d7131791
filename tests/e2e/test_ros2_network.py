"""ROS 2 on two machines: found by multicast and by name, and followed where one packet of twenty is lost."""
import pathlib

from conftest import last_of, start_robotui, wait_for
from network import ADDRESSES, network    # noqa: F401 (a fixture)
from test_rclpy_robot import DOMAIN, line_of, lines, python_of

PEERS = pathlib.Path(__file__).parent / "peers"
CYCLONE = ("<CycloneDDS><Domain><General><Interfaces><NetworkInterface name=\"bad0\" multicast=\"true\"/></Interfaces></General>"
           "</Domain></CycloneDDS>")
DELAY, LOSS = 0.005, 0.05


def start(machine, peer, *arguments, **variables):
    """A program of ROS 2, or of DDS alone, that looks for others wherever multicast reaches."""
    python = python_of(peer)
    root = str(python.parent.parent)
    machine.environment |= {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET", "LD_LIBRARY_PATH": f"{root}/lib",
                            "FASTDDS_BUILTIN_TRANSPORTS": "UDPv4", "AMENT_PREFIX_PATH": root} | variables
    return machine.start_tool(python, PEERS / f"{peer}_robot.py", *map(str, arguments), name=peer)


def workbench(machine, **variables):
    machine.environment |= {"ROS_DOMAIN_ID": str(DOMAIN)} | variables
    return start_robotui(machine, "run", "--json", "ros2")


def test_a_robot_of_the_network_is_found_and_nothing_kept_is_lost_on_a_bad_link(network):                    # noqa: F811
    network.impair(DELAY, LOSS)
    robot = start(network.robot, "rclpy")
    wait_for(lambda: "ready" in lines(robot), seconds=60, what="the robot")
    robotui = workbench(network.workbench, ROS_AUTOMATIC_DISCOVERY_RANGE="SUBNET")

    wait_for(lambda: line_of(robotui, "odom", True), seconds=60, what="a live odom")
    for port in ("map", "robot_description"):
        wait_for(lambda: (line := last_of(robotui, port)) and line["age_s"] is not None and line["age_s"] >= 0, seconds=60, what=f"the {port}")


def test_a_machine_that_is_named_is_asked_also_where_its_programs_announce_themselves_by_multicast(network):  # noqa: F811
    start(network.robot, "cyclone", DOMAIN, CYCLONEDDS_URI=CYCLONE)
    robotui = workbench(network.workbench, ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST", ROS_STATIC_PEERS=ADDRESSES[0])

    wait_for(lambda: line_of(robotui, "chatter", True), seconds=60, what="a live chatter")
