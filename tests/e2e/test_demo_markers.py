"""The demo robot's markers, as a client of rospy meets them."""
import json
import pathlib

PEERS = pathlib.Path(__file__).parent / "peers"


def test_rospy_reads_the_markers_and_moves_the_waypoint(simulator):
    seen = json.loads(simulator.tool("/usr/bin/python3", PEERS / "waypoint.py", "2.6", "3.2", seconds=60).splitlines()[-1])
    assert seen["menu"] == ["Go", "Back to the robot"]
    assert seen["numbers"] == [0, 0, 1]
    assert seen["place"] == [2.6, 3.2]
    assert {"server rack", "sofa", "person"} <= set(seen["names"])
