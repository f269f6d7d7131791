"""A plan of a real ROS node in the scene: the ghost's way, and what was executed against it."""
import pathlib

import pytest

from conftest import wait_for
from desktop import Window, missing

SCRIPT = pathlib.Path(__file__).parent / "peers" / "planning_robot.py"
CONFIGURATION = """ruics:
  Arm:
    type: single
    view: scene3d
    rfics:
      base: {type: ros}
    uics:
      scene3d:
        automatic: false
        displays:
          - {type: robotmodel}
          - {type: trajectory, settings: {opacity: 1, width: 6}}
"""
PLANNED, EXECUTED = 0xf5b83d, 0x3ecf8e


def test_a_plan_of_rospy_is_shown_with_what_was_executed(roscore, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    roscore.start_tool("/usr/bin/python3", str(SCRIPT), name="planner")
    configuration = tmp_path / "plan.yaml"
    configuration.write_text(CONFIGURATION)
    window = Window.open(roscore, configuration)
    for colour, what in ((PLANNED, "the planned way"), (EXECUTED, "the executed way")):
        wait_for(lambda wanted=colour: window.picture().count(wanted) > 60, seconds=60, what=what)
