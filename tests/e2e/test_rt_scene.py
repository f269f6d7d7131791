"""The demo's arm under control in real time, as it is seen in space."""
import numpy
import pytest

from conftest import Processes, needs_rt, wait_for
from desktop import Window, missing
from realtime import Control, patient_arm
from views import MANIPULATOR, Views

WORKBENCH = """ruics:
  arm:
    type: manipulator
    rfics:
      rt: {type: xbot}
    uics:
      scene3d: {tree: false}
"""
SHELL = 0x80                        # the shells of the arm are brighter, whatever the light; grid and ground are darker
GREY = 30
WORDS = 40                          # the lines of words at the bottom, and the axes beside them
BENT = 1.6                          # rad, of the elbow
PATIENCE = 90

pytestmark = needs_rt


@pytest.fixture(name="arm")
def arm_in_a_window(environment, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    processes = Processes(tmp_path)
    try:
        control = Control(processes, environment, tmp_path, patient_arm(tmp_path))
        control.start()
        wait_for(control.is_up, PATIENCE, "the plugins")
        workbench = tmp_path / "workbench.yaml"
        workbench.write_text(WORKBENCH)
        yield control, Views(Window.open(control.robot, workbench), MANIPULATOR)
    finally:
        processes.end()


def shells(views):
    """The first row of the picture in which the arm is, from above, and its height; none where it is not seen."""
    left, top, right, bottom = views.body("records")
    pixels = views.part((left, top, right, bottom - WORDS)).astype(int)
    bright = (pixels.min(axis=2) > SHELL) & (numpy.ptp(pixels, axis=2) < GREY)
    rows = numpy.flatnonzero(bright.sum(axis=1) > 3)
    return (int(rows[0]), int(rows[-1] - rows[0])) if len(rows) else None


def rests(views):
    """The arm as it is seen at rest: twice the same."""
    views.still(views.body("records"), 1.0)
    return shells(views)


def test_the_arm_in_the_picture_follows_its_joints(arm):
    control, views = arm
    wait_for(lambda: (shells(views) or (0, 0))[1] > 100, PATIENCE, "the arm")
    top, height = rests(views)
    control.ctl("switch", "XBotCommunicationPlugin", "1")

    control.ctl("reference", f"elbow_pitch={BENT}", "--for", "4")

    assert control.joints()["elbow_pitch"].position == pytest.approx(BENT, abs=0.01)
    wait_for(lambda: shells(views)[0] > top + height // 6, PATIENCE, "an arm that is bent")
    control.ctl("reference", "elbow_pitch=0", "--for", "4")
    wait_for(lambda: abs(shells(views)[0] - top) <= 3, PATIENCE, "an arm that is straight again")
