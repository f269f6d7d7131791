"""The X server of a window ends: what a real master and a robot that is driven know of it afterwards."""
import shutil
import subprocess
import time
import xmlrpc.client

import pytest

from conftest import Robot, start_robotui, wait_for
from desktop import Keys, Motion, Window, missing

DISPLAY_LOST = 1
RUIC = "ruics:\n  Natalie:\n    type: {type}\n    rfics:\n      base: {{type: ros}}\n"
MAP_VIEW = RUIC.format(type="mobilebase")
SCENE = RUIC.format(type="single") + "    view: scene3d\n"
ODOMETRY = "{header: {frame_id: odom}, child_frame_id: base_link, pose: {pose: {orientation: {w: 1}}}}"


@pytest.fixture(name="screen")
def own_screen(processes, environment):
    """An X server that a test may kill: it chooses a free number and tells it."""
    if shutil.which("Xvfb") is None:
        pytest.skip("there is no Xvfb")
    server = processes.start(["Xvfb", "-displayfd", "1", "-screen", "0", "1400x900x24"], "screen", environment)
    server.name = ":" + wait_for(lambda: server.out.read_text().strip(), what="the X server")
    return server


def registrations(uri):
    """What nodes of the workbench are registered for."""
    _, _, kinds = xmlrpc.client.ServerProxy(uri).getSystemState("/test")
    return [topic for kind in kinds for topic, nodes in kind if any(node.startswith("/robotui_") for node in nodes)]


@pytest.mark.parametrize("configuration", [MAP_VIEW, SCENE], ids=["views", "scene"])
def test_a_window_that_loses_its_display_leaves_its_master(roscore, screen, tmp_path, configuration):
    roscore.start_tool("rostopic", "pub", "-r", "5", "/odom", "nav_msgs/Odometry", ODOMETRY, name="odometry")
    file = tmp_path / "robot.yaml"
    file.write_text(configuration)
    surroundings = roscore.environment | {"DISPLAY": screen.name, "XDG_STATE_HOME": str(tmp_path / "state")}
    surroundings.pop("WAYLAND_DISPLAY", None)
    window = start_robotui(Robot(roscore.processes, roscore.uri, surroundings), "run", file, display=True)
    wait_for(lambda: registrations(roscore.uri), seconds=120, what="a look at the robot")
    wait_for(lambda: titled(surroundings), seconds=120, what="the window")
    if configuration == SCENE:  # JOGL sets a handler of its own for the end of a display, with its first picture
        wait_for(lambda: any("ours is set again" in log.read_text() for log in (tmp_path / "state").rglob("robotui.log")),
                 seconds=60, what="the handler after the first picture")

    screen.kill()

    assert window.wait(60) == DISPLAY_LOST
    assert registrations(roscore.uri) == []
    said = window.err.read_text()
    assert "has lost its display" in said
    assert "not ended in time" not in said


def test_a_robot_that_is_driven_is_stopped_by_us_when_the_display_is_lost(simulator, processes, environment, screen, monkeypatch):
    if missing() or shutil.which("openbox") is None:
        pytest.skip("driving in a window needs openbox, and " + missing())
    monkeypatch.setenv("DISPLAY", screen.name)
    processes.start(["openbox"], "openbox", environment | {"DISPLAY": screen.name})
    said = simulator.start_tool("rostopic", "echo", "-p", "/cmd_vel", name="commands")
    window = Window.open(Robot(processes, simulator.uri, environment | {"DISPLAY": screen.name}), "ros")
    wait_for(window.is_live, seconds=60, what="a live robot")
    motion = Motion(simulator)
    keys = Keys()
    for patience in (10, 20, 40):
        window.click(wait_for(window.stick, what="the stick"))
        keys.hold("w")
        if drives_soon(motion, patience):
            break
        keys.let_go()

    assert motion.drives()
    screen.kill()

    assert window.process.wait(60) == DISPLAY_LOST
    wait_for(motion.stands, seconds=60, what="standstill")
    def speeds():
        return [float(line.split(",")[1]) for line in said.out.read_text().splitlines(keepends=True)[1:] if line.endswith("\n")]
    assert max(speeds()) > 0.1
    wait_for(lambda: speeds()[-1] == 0, what="the robot to be told to stand, so that it did not have to wait for its own time-out")


def drives_soon(motion, patience):
    """A display that was busy for too long stops the robot until the key comes again."""
    end = time.monotonic() + patience
    while time.monotonic() < end and not motion.drives():
        time.sleep(0.05)
    return motion.drives()


def titled(surroundings):
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "RobotUI *$"], env=surroundings, capture_output=True, text=True,
                           timeout=60, check=False)
    return found.stdout.split()
