"""A robot under control in real time, as a user at the window drives it, and as robotui-rt-ctl sees it. The tests go on from each other."""
import contextlib
import os
import signal
import subprocess
import time

import pytest

from conftest import Processes, json_lines, needs_rt, processes_of, start_robotui, wait_for
from desktop import DARK, Keys, Window, java_of, missing
from realtime import Control, patient_arm
from views import MANIPULATOR, Views, runs, type_words

WORKBENCH = """ruics:
  arm:
    type: manipulator
    rfics:
      rt: {type: xbot}
    uics:
      jointcontrol: {speed: 0.4}
    safety:
      arm:
        stop_call: {interface: rt, service: stop_plugins}
"""
LOWER, UPPER = -2.9, 2.9            # of shoulder_yaw, rad
SECONDS_OF_HOMING = 3
BAR = 40                            # the line above the joints, and the one below
HEADINGS = 2                        # rows of words above the joints: headings, and the chain
AT_LIMIT = 0x8b6f35                 # the bar of a joint there
SWITCH = (10, 42)                   # from the left edge of the plugins
STATE = (52, 318)                   # name and state
STATUS = 110                        # below the list
HOMING, COMMUNICATION = 0, 2        # which switches theirs are
PATIENCE = (30, 40, 60)             # s, from one try to the next: long, as the next click on a switch turns it back

pytestmark = needs_rt


class Cell:
    """The control, and the window in front of it."""

    def __init__(self, folder, processes):
        environment = dict(os.environ) | {"ROS_HOME": str(folder / "ros"), "XDG_STATE_HOME": str(folder / "state")}
        self.control = Control(processes, environment, folder, patient_arm(folder, Homing={"time": SECONDS_OF_HOMING}))
        self.supervisor = self.control.start()
        self.workbench = folder / "workbench.yaml"
        self.workbench.write_text(WORKBENCH)
        wait_for(self.control.is_up, what="the plugins")
        self.open("window")

    def open(self, name):
        self.window = Window.open(self.control.robot, self.workbench, name=name)
        self.views = Views(self.window, MANIPULATOR)
        wait_for(self.window.is_live, what="a live robot")

    # ---- plugins ----------------------------------------------------------------------------------------------------

    def list(self):
        left, top, right, bottom = self.views.body("plugins")
        return left, top, right, top + int((bottom - top) * 0.4)

    def switches(self):
        """The middles of the switches in the list of plugins, from top to bottom."""
        left, top, _, bottom = self.list()
        strip = self.window.picture().pixels[top:bottom, left + SWITCH[0]:left + SWITCH[1]].astype(int)
        ink = abs(strip - strip[0, 0]).max(axis=2) > 60
        return [(left + sum(SWITCH) // 2, top + (first + last) // 2) for first, last in runs(ink.any(axis=1), 13) if last - first < 20]

    def switch(self, which):
        return wait_for(lambda: enough(self.switches(), COMMUNICATION + 1), what="the switches")[which]

    def reds_of_plugin(self, which):
        """How much is red in its name and state."""
        left = self.list()[0]
        _, row = self.switch(which)
        return self.window.picture().count(DARK["bad"], left + STATE[0], row - 12, left + STATE[1], row + 12)

    def reds_of_status(self):
        """How much is red in what is said of the selected plugin, below its name."""
        left, _, right, bottom = self.list()
        return self.window.picture().count(DARK["bad"], left, bottom, right, bottom + STATUS)

    def is_on(self, which):
        column, row = self.switch(which)
        return self.window.picture().count(DARK["accent"], column - 16, row - 8, column + 16, row + 8) > 150

    def turn(self, which, plugin, state):
        """Clicks on a switch."""
        again(lambda: self.press(self.switch(which)), lambda: self.control.state(plugin) == state, f"{plugin} {state}")

    def reload(self, which, plugin):
        """By the keys: past the start to the reload."""
        def keys():
            self.select_plugin(which)
            for key in ("Tab", "Tab", "space"):
                Keys.press(key)
        again(keys, lambda: self.control.plugins()[plugin] == ("stopped", ""), f"{plugin} loaded anew")

    def select_plugin(self, which):
        column, row = self.switch(which)
        self.press((column + 60, row))

    def press(self, place):
        """And goes away: a word about what is under the pointer would lie over the switches below."""
        self.window.click(place)
        left, top, _, _ = self.list()
        self.window.move((left + 120, top - 20))

    # ---- joints -----------------------------------------------------------------------------------------------------

    def table(self):
        left, top, right, bottom = self.views.body("joints")
        return left, top + BAR, right, bottom - BAR

    def row(self, joint):
        """The middle of a joint's name, by its number."""
        left, top, _, bottom = self.table()
        rows = wait_for(lambda: enough(self.views.rows((left + 20, top, left + 130, bottom)), HEADINGS + joint + 1), what="the joints")
        first, last = rows[HEADINGS + joint]
        return left + 60, top + (first + last) // 2

    def strip(self, joint):
        left, _, right, _ = self.table()
        _, row = self.row(joint)
        return left, row - 8, right, row + 8

    def drive(self):
        """Takes control: the view asks, and is answered."""
        left, top, right, bottom = self.views.body("joints")
        self.window.click((left + 60, top + 18))
        self.window.click(self.views.button((left, bottom - 70, right, bottom)))
        wait_for(self.window.is_yours, what="control")

    def end_driving(self):
        """And give control back, where it was not ended before by a display that was busy."""
        self.window.click(self.row(0))
        Keys.press("Escape")

    def target(self, degrees):
        """Types one for the first joint."""
        self.window.click(self.row(0))
        Keys.press("Return")
        self.views.still(self.strip(0), 0.3)
        Keys.press("ctrl+a")
        type_words(str(degrees))
        Keys.press("Return")

    def drive_toward(self, degrees, arrived):
        def begin():
            self.end_driving()
            self.drive()
            self.target(degrees)
        again(begin, arrived, "motion")

    def joint(self, name="shoulder_yaw"):
        return self.control.joints()[name]

    def stands(self):
        """Whether no joint moves, nor is told to."""
        before = self.control.joints()
        time.sleep(0.3)
        return self.control.joints() == before


def enough(found, count):
    return found if len(found) >= count else None


def again(deed, condition, what):
    """Does something until it is so. A display that was busy for too long stops what its window does: then a user begins again."""
    for patience in PATIENCE:
        deed()
        with contextlib.suppress(AssertionError):
            return wait_for(condition, patience, what)
    raise AssertionError(f"tried {len(PATIENCE)} times for {what}")


@pytest.fixture(scope="module")
def cell(tmp_path_factory):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    folder = tmp_path_factory.mktemp("cell")
    processes = Processes(folder)
    try:
        yield Cell(folder, processes)
    finally:
        processes.end()


@pytest.fixture(autouse=True)
def last_picture(tmp_path):
    """Keeps what the screen showed at the end of each test."""
    yield
    if not missing():
        subprocess.run(["import", "-silent", "-window", "root", str(tmp_path / "end.png")], timeout=60, check=False)


# ---- plugins --------------------------------------------------------------------------------------------------------


def test_driving_is_asked_for_and_given_back(cell):
    assert not cell.window.is_yours()

    def drive_and_end():
        cell.drive()
        cell.end_driving()

    again(drive_and_end, lambda: not cell.window.is_yours(), "control to be given back")
    assert all(joint.control == "free" for joint in cell.control.joints().values())


def test_homing_is_started_and_the_joints_are_seen_to_move(cell):
    assert not cell.is_on(HOMING)

    cell.turn(HOMING, "Homing", "running")

    cell.views.lives(cell.table())
    wait_for(lambda: cell.joint("elbow_pitch").position > 0.2, what="motion")
    wait_for(lambda: cell.is_on(HOMING), what="the switch")
    assert cell.window.is_yours(), "who switches has control"


def test_a_host_that_is_killed_is_seen_and_the_robot_holds(cell):
    cell.select_plugin(HOMING)
    wait_for(lambda: cell.reds_of_plugin(HOMING) == 0, what="a plugin that is well")
    assert cell.reds_of_status() == 0

    os.kill(cell.control.hosts("--host", "0")[0], signal.SIGSEGV)

    wait_for(lambda: cell.control.state("Homing") == "stopped", what="the plugin's end")
    assert "signal 11 (Segmentation fault)" in cell.control.plugins()["Homing"][1]
    held = cell.joint("elbow_pitch")
    assert held.control in ("holding", "safe") and held.position > 0.2
    wait_for(cell.stands, what="standstill")
    wait_for(lambda: not cell.is_on(HOMING), what="the switch")
    wait_for(lambda: cell.reds_of_plugin(HOMING) > 40, what="the fault in the list")
    wait_for(lambda: cell.reds_of_status() > 100, what="the fault of the selected plugin")
    wait_for(lambda: sum(cell.window.picture().count(DARK[role], *cell.table()) for role in ("warning", "bad")) > 100,
             what="joints that hold")


def test_a_plugin_is_reloaded_and_started_again(cell):
    cell.reload(HOMING, "Homing")
    wait_for(lambda: cell.reds_of_plugin(HOMING) == 0, what="the fault to go")

    cell.turn(HOMING, "Homing", "running")

    wait_for(lambda: "at home" in cell.control.ctl("status", "Homing"), what="the posture home")
    assert cell.joint("elbow_pitch").position == pytest.approx(1.35, abs=1e-3)
    cell.turn(HOMING, "Homing", "stopped")


# ---- driving --------------------------------------------------------------------------------------------------------


def test_a_target_beyond_a_limit_ends_at_the_limit(cell):
    cell.turn(COMMUNICATION, "XBotCommunicationPlugin", "running")

    cell.drive_toward(9000, lambda: cell.joint().position == UPPER)

    wait_for(lambda: cell.window.picture().count(AT_LIMIT, *cell.strip(0)) > 200, what="a bar at its limit")
    cell.end_driving()


def test_a_command_beyond_a_limit_is_cut_and_counted(cell):
    cell.window.click(cell.row(0))
    left, _, right, bottom = cell.table()
    detail = (left, bottom - 90, right, bottom)
    cell.views.still(detail)
    before, cut = cell.views.part(detail), cell.joint().cut

    cell.control.ctl("reference", "shoulder_yaw=99", "--for", "0.3")

    wait_for(lambda: cell.joint().cut > cut, what="the cut")
    assert cell.joint().position == cell.joint().reference == UPPER
    wait_for(lambda: (cell.views.part(detail) != before).any(), what="the count")


# ---- the end --------------------------------------------------------------------------------------------------------


def test_a_workbench_that_is_killed_while_it_drives_leaves_a_robot_that_stands(cell):
    cell.drive_toward(-9000, lambda: cell.joint().position < UPPER - 0.3)

    os.kill(java_of(cell.window.process, "equinox.launcher"), signal.SIGKILL)

    wait_for(cell.stands, what="standstill")
    joint = cell.joint()
    assert joint.position > LOWER + 0.3, "it did not go on to the target"
    assert joint.control == "commanded" and joint.owner == "XBotCommunicationPlugin", "the plugin holds it where it is"
    assert cell.supervisor.poll() is None
    cell.control.ctl("reference", f"shoulder_yaw={joint.position}", "--for", "0.1")     # nobody commands it any more
    cell.window.process.wait(60)


def test_a_new_workbench_drives_and_lets_go_when_it_is_closed(cell):
    cell.open("again")
    before = cell.joint().position
    cell.drive_toward(-9000 if before > 0 else 9000, lambda: abs(cell.joint().position - before) > 0.2)

    cell.window.close()

    assert cell.window.process.wait(40) == 0
    wait_for(cell.stands, what="standstill")
    cell.control.ctl("reference", f"shoulder_yaw={cell.joint().position}", "--for", "0.1")
    assert cell.supervisor.poll() is None
    said = cell.window.process.err.read_text()
    assert "Exception" not in said and "ERROR" not in said, said


def test_run_starts_the_control_that_a_configuration_names_and_ends_it(processes, environment, tmp_path):
    control = Control(processes, environment, tmp_path, patient_arm(tmp_path))
    workbench = tmp_path / "arm.yaml"
    workbench.write_text(f"control: {control.config.name}\n{WORKBENCH}")

    run = start_robotui(control.robot, "run", "--json", workbench)

    wait_for(lambda: any(line["port"] == "rt.joints" and line["rate_hz"] > 5 for line in json_lines(run)), 120, "live joints")
    control.ctl("switch", "Homing", "1")
    run.send_signal(signal.SIGTERM)
    with contextlib.suppress(subprocess.TimeoutExpired):
        run.wait(60)
    assert run.poll() is not None
    wait_for(lambda: not processes_of("robotui-rt-hal", control.config), what="the end of the control")
