"""The window, as a user at its keyboard and mouse meets it."""
import contextlib
import math
import os
import signal
import subprocess
import time

import pytest

from conftest import ROOT, Robot, busy, end, free_port, listening, start_simulator, wait_for
from desktop import DARK, LIGHT, TOP_BAR, Keys, Motion, Picture, Window, java_of, missing

# What a robot may need to come to rest after the last command: its own time-out, and a machine with much to do.
REST = 1.2


@pytest.fixture(autouse=True)
def display(tmp_path, processes):
    """Keeps what the screen showed at the end beside what the processes said."""
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    yield
    subprocess.run(["import", "-silent", "-window", "root", str(tmp_path / "end.png")], timeout=60, check=False)


@pytest.fixture
def keys(display):
    hands = Keys()
    yield hands
    hands.let_go()


@pytest.fixture
def nowhere(processes, environment):
    """Where no master is."""
    port = free_port()
    robot = Robot(processes, f"http://127.0.0.1:{port}", environment)
    robot.port = port
    return robot


@pytest.fixture
def window(simulator):
    """The window on a robot, alive."""
    opened = Window.open(simulator, "ros")
    wait_for(opened.is_live, seconds=120, what="a live robot")
    return opened


@pytest.fixture
def motion(simulator):
    return Motion(simulator)


def drive(window, motion, keys):
    """Holds the key that drives. A display that was busy for too long stops the robot until the key comes again: so does a user."""
    for patience in (10, 20, 40):
        window.click(wait_for(window.stick, what="the stick"))
        keys.hold("w")
        with contextlib.suppress(AssertionError):
            return wait_for(motion.drives, seconds=patience, what="motion")
        keys.let_go()
    raise AssertionError("the robot does not drive")


# ---- looks ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("theme, colours", [("dark", DARK), ("light", LIGHT)])
def test_the_demo_shows_its_robot_in_both_themes(nowhere, tmp_path, theme, colours):
    for after in (8, 40):               # a busy machine takes longer until all is there
        picture = picture_after(after, nowhere, theme, tmp_path)
        width, height = picture.width, picture.height
        if picture.count(colours["laser"], 200, TOP_BAR, int(width * 0.68), height) > 300:
            break

    assert picture.colours() > 200
    assert picture.count(colours["bad"], width - 200, 0, width, TOP_BAR) > 1500, "the stop"
    assert picture.count(colours["ground"], 0, 0, width, TOP_BAR) > width * TOP_BAR / 3, "the top bar"
    assert picture.count(colours["panel"], 0, TOP_BAR, 200, height) > 20_000, "the navigator"
    assert picture.count(colours["accent"], 0, TOP_BAR, 6, height // 2) > 100, "the mark of the selected robot"
    assert picture.count(colours["good"], 12, 80, 28, 112) > 40, "the dot of a live robot"
    assert picture.count(colours["laser"], 200, TOP_BAR, int(width * 0.68), height) > 300, "the scan on the map"


def picture_after(seconds, robot, theme, folder):
    file = folder / f"window-{seconds}.png"
    window = Window.open(robot, "--theme", theme, "--screenshot", file, "--after", str(seconds), "--for", str(seconds + 2), name=f"window-{seconds}")
    assert window.process.wait(120) == 0, window.process.err.read_text()
    return Picture.of(file)


# ---- driving --------------------------------------------------------------------------------------------------------


def test_a_key_drives_while_it_is_held(window, motion, keys):
    before = motion.place()
    drive(window, motion, keys)
    wait_for(lambda: math.dist(motion.place(), before) > 0.1, what="some way")
    keys.let_go()

    assert motion.seconds_until_it_stood(time.time()) < REST * busy()


def test_the_stick_drives_while_it_is_held(window, motion, keys):
    column, row = wait_for(window.stick, what="the stick")
    window.click((column, row))

    keys.grip()
    window.move((column, row - 60))
    wait_for(lambda: motion.speed() > 0.1, what="forward motion")
    keys.let_go()

    assert motion.seconds_until_it_stood(time.time()) < REST * busy()


def test_a_window_that_loses_the_focus_stops_the_robot(window, motion, keys, processes, environment):
    drive(window, motion, keys)

    other = processes.start(["xev", "-event", "focus"], "xev", environment)
    wait_for(lambda: "FocusIn" in other.out.read_text(), what="the focus to go")

    assert motion.seconds_until_it_stood(time.time()) < REST * busy()
    end(other)


@pytest.mark.parametrize("how", ["key", "button", "terminal"])
def test_a_stop_is_latched_until_it_is_released(window, motion, keys, how, simulator):
    assert window.release_button() is None
    drive(window, motion, keys)

    stop(window, keys, how, simulator)
    assert motion.seconds_until_it_stood(time.time()) < REST * busy()
    assert motion.stands_for(25)
    release = wait_for(window.release_button, what="the window to show the stop")
    keys.let_go()
    window.click(window.stick())
    keys.hold("w")
    assert motion.stands_for(50)
    keys.let_go()

    window.click(release)
    wait_for(lambda: window.release_button() is None, what="the window to show the release")
    assert motion.stands_for(25)
    drive(window, motion, keys)


def stop(window, keys, how, simulator):
    if how == "key":
        keys.press("F12")
    elif how == "button":
        window.click(window.stop_button())
        window.move(window.stick())     # a button under the pointer has another colour
    else:
        state = {"XDG_STATE_HOME": str(simulator.processes.folder / "window-state")}
        told = subprocess.run([ROOT / "robotui", "stop"], env=simulator.environment | state, capture_output=True, text=True, timeout=60, check=False)
        assert told.returncode == 0 and "is stopped" in told.stdout + told.stderr, told


def test_a_goal_on_the_map_sends_the_robot_there(window, motion, simulator, keys):
    plan = simulator.start_tool("rostopic", "echo", "/plan/poses[-1]/pose/position", name="plan")
    column, row = wait_for(window.robot, what="the robot on the map")
    before = motion.place()

    window.click((column, row))
    keys.press("g")
    window.click((column + 40, row - 25))

    wait_for(lambda: "x:" in plan.out.read_text(), what="a plan")
    wait_for(lambda: math.dist(motion.place(), before) > 0.3, what="motion")
    wait_for(motion.stands, seconds=20, what="the arrival")


# ---- loss and recovery ----------------------------------------------------------------------------------------------


def test_a_robot_outlives_a_workbench_that_was_killed(window, motion, keys, simulator):
    rate = simulator.start_tool("rostopic", "hz", "/scan", name="hz")
    drive(window, motion, keys)
    wait_for(lambda: scan_rate(rate), what="the rate of the scan")

    os.kill(java_of(window.process, "equinox.launcher"), signal.SIGKILL)
    assert motion.seconds_until_it_stood(time.time()) < REST * busy()
    keys.let_go()
    window.process.wait(60)
    rate.out.write_text("")
    wait_for(lambda: (scan_rate(rate) or 0) > 15, what="the rate of the scan")

    again = Window.open(simulator, "ros", name="again")
    drive(again, motion, keys)


def scan_rate(process):
    rates = [float(line.split(":")[1]) for line in process.out.read_text().splitlines() if line.startswith("average rate:")]
    return rates[-1] if rates else None


def test_the_window_shows_that_the_robot_went_and_came_back(window, simulator, processes, environment):
    end(simulator.core, how=signal.SIGKILL)
    wait_for(lambda: not window.is_live(), what="the loss to be seen")

    start_simulator(processes, environment, simulator.port, "simulator2")

    wait_for(window.is_live, what="a live robot")


def test_a_window_that_was_there_first_finds_the_robot_when_it_comes(nowhere, processes, environment):
    window = Window.open(nowhere, "ros")
    assert not window.is_live()

    start_simulator(processes, environment, nowhere.port, "simulator")

    wait_for(window.is_live, what="a live robot")


# ---- the end --------------------------------------------------------------------------------------------------------


def test_closing_the_window_ends_all_at_once(nowhere):
    window = Window.open(nowhere, "demo")
    wait_for(window.is_live, what="a live robot")
    workbench = java_of(window.process, "equinox.launcher")
    uri = next(line.split("=", 1)[1].split()[0] for line in window.process.err.read_text().splitlines() if "export ROS_MASTER_URI=" in line)

    window.close()
    closed = time.monotonic()
    wait_for(lambda: not is_running(workbench), seconds=20, what="the end of the workbench")
    assert time.monotonic() - closed < 2 * busy()
    assert window.process.wait(6 * busy()) == 0
    assert not listening(int(uri.rsplit(":", 1)[1]))


def test_closing_ends_also_when_the_robot_hangs(window, motion, simulator, keys):
    drive(window, motion, keys)
    os.kill(simulator.core.pid, signal.SIGSTOP)
    try:
        keys.let_go()
        window.close()
        assert window.process.wait(4 * busy()) == 0
    finally:
        os.kill(simulator.core.pid, signal.SIGCONT)


def is_running(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as stat:
            return stat.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


# ---- configurations -------------------------------------------------------------------------------------------------


def test_a_wrong_configuration_is_explained_in_the_window(nowhere, tmp_path):
    broken = tmp_path / "broken.yaml"
    broken.write_text("ruics:\n  Robot:\n    type: mobilebase\n    rfics:\n      base: {type: ros, mastr: here}\n")

    window = Window.open(nowhere, broken)

    wait_for(lambda: explains(window.picture()), what="the explanation")
    assert window.process.poll() is None


def explains(picture):
    """A red mark and the place in the accent's colour, in the area of the views."""
    area = (200, TOP_BAR, picture.width, picture.height)
    return picture.count(DARK["bad"], *area) > 15 and picture.count(DARK["accent"], *area) > 50
