"""Waypoints of the scene: the demo's robot drives to them in their order, and the stop ends that."""
import math

import pytest

from conftest import wait_for
from desktop import Keys, Motion, Window, missing

NEAR = 0.35
CONFIGURATION = """ruics:
  Robot:
    type: single
    view: scene3d
    rfics:
      base: {{type: ros}}
    uics:
      scene3d:
        waypoints: {waypoints}
"""


class Believed:
    """Where localisation has said that the robot is, since the beginning."""

    def __init__(self, robot):
        self.process = robot.start_tool("rostopic", "echo", "-p", "/amcl_pose", name="believed")
        wait_for(self.places, what="the place of the robot")

    def places(self):
        lines = self.process.out.read_text().splitlines(keepends=True)
        if len(lines) < 2:
            return []
        names = lines[0].strip().split(",")
        x, y = (names.index(f"field.pose.pose.position.{axis}") for axis in "xy")
        return [(float(row[x]), float(row[y])) for row in (line.split(",") for line in lines[1:] if line.endswith("\n"))]

    def passed(self, place):
        """How many messages it took until the robot was there, or none."""
        return next((number for number, at in enumerate(self.places()) if math.dist(at, place) < NEAR), None)


@pytest.fixture
def motion(simulator):
    return Motion(simulator)


@pytest.fixture
def believed(simulator):
    return Believed(simulator)


def open_window(simulator, folder, places):
    configuration = folder / "waypoints.yaml"
    configuration.write_text(CONFIGURATION.format(waypoints=[{"x": round(x, 2), "y": round(y, 2), "yaw": yaw} for x, y, yaw in places]))
    window = Window.open(simulator, configuration)
    wait_for(window.is_live, seconds=120, what="a live robot")
    return window


def begin(window, motion):
    """
    Clicks into the scene, takes the tool and presses Enter, until the robot drives: frames may still come in. Waits long
    before it presses again: Enter would end a drive that a busy machine only begins.
    """
    def drives():
        if motion.drives():
            return True
        Keys.press("Escape")            # a click with the tool in hand would place another waypoint
        window.click((window.picture().width - 200, window.picture().height // 2))
        Keys.press("r")
        Keys.press("Return")
        try:
            return wait_for(motion.drives, seconds=20, what="motion")
        except AssertionError:
            return False

    wait_for(drives, seconds=120, what="the robot to drive off")


def test_the_robot_drives_to_the_waypoints_in_their_order(simulator, motion, believed, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    x, y = believed.places()[-1]
    first, second = (x + 1.2, y), (x + 1.2, y + 1.0)
    window = open_window(simulator, tmp_path, [(*first, 0), (*second, 1.57)])

    begin(window, motion)
    wait_for(lambda: believed.passed(second) is not None, seconds=60, what="the second waypoint")
    wait_for(motion.stands, seconds=30, what="the arrival")
    assert believed.passed(first) < believed.passed(second)


def test_the_stop_ends_the_drive_for_good(simulator, motion, believed, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    x, y = believed.places()[-1]
    window = open_window(simulator, tmp_path, [(x + 1.2, y, 0), (x + 1.2, y + 1.0, 1.57)])

    begin(window, motion)
    Keys.press("F12")
    wait_for(motion.stands, what="standstill")
    window.click(wait_for(window.release_button, what="the window to show the stop"))
    wait_for(lambda: window.release_button() is None, what="the release")
    assert motion.stands_for(50), "nothing drives on by itself"
