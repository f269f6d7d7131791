"""ROS 2 on two machines: found by multicast and by name, and followed where one packet of twenty is lost."""
import pathlib
import signal

from conftest import await_end, start_robotui, tell, wait_for
from network import ADDRESSES, network    # noqa: F401 (a fixture)
from test_rclpy_robot import DOMAIN, line_of, lines, python_of
from test_record import decode, last, record

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


def test_a_robot_of_the_network_is_found_and_nothing_reliable_is_lost_on_a_bad_link(network, tmp_path):           # noqa: F811
    python_of("recordings")
    network.impair(DELAY, LOSS)
    robot = start(network.robot, "rclpy", "--numbers")
    wait_for(lambda: "ready" in lines(robot), seconds=60, what="the robot")
    machine, file = network.workbench, tmp_path / "run.mcap"
    machine.environment |= {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"}
    topics = ("numbers", "odom", "map", "robot_description")
    recording = record(machine.processes, machine.environment, "ros2", file, *(word for topic in topics for word in ("--ports", topic)))
    wait_for(lambda: last(recording).get("messages", 0) > 1100, seconds=120, what="a thousand numbers")
    tell(recording, signal.SIGINT)
    await_end(recording)

    assert last(recording)["dropped"] == 0
    decoded = decode(file)["topics"]
    assert {"/numbers", "/odom", "/map", "/Robot/base.robot_description"} <= set(decoded), "also what was sent before anybody listened"
    carried, lost = network.counts()
    assert lost > 0.02 * (carried + lost), "the link was as bad as it was to be"
    assert decoded["/numbers"]["count"] > 500 and decoded["/numbers"]["missing"] == 0


def test_a_machine_that_is_named_is_asked_also_where_its_programs_announce_themselves_by_multicast(network):  # noqa: F811
    start(network.robot, "cyclone", DOMAIN, CYCLONEDDS_URI=CYCLONE)
    machine = network.workbench
    machine.environment |= {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_STATIC_PEERS": ADDRESSES[0]}
    robotui = start_robotui(machine, "run", "--json", "ros2")

    wait_for(lambda: line_of(robotui, "chatter", True), seconds=60, what="a live chatter")
