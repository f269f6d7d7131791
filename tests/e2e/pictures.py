#!/usr/bin/python3
"""Makes pictures of docs/images anew, from the finished product on simulated robots: pictures.py [PICTURE...], in a display of 1600 x 1000.
Without names it makes all that it knows; the others of docs/images are taken by hand."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from conftest import ROOT, Processes, Robot, start_simulator, wait_for
from desktop import DARK, LIGHT, NAVIGATOR, Keys, Motion, Picture, Window, missing, output
from playback import Bar
from test_install import Served, sample_sites
from test_new_robot import Form
from views import MANIPULATOR, Views

IMAGES = ROOT / "docs" / "images"
MOST_BYTES = 250_000
WIDTH = 1500
# Of each picture the configuration, and colours of what must be seen in it.
CONFIGURED = {"scene-two-frameworks-dark.png": ("two-frameworks", [0x3ecf8e, 0xf5b83d]), "swarm-dark.png": ("swarm", [DARK["good"]])}
# The same of robots under control in real time: also what is cut out of the window, none for all of it.
CONTROLLED = {"scene-arm-dark.png": ("arm", "records"), "humanoid-dark.png": ("humanoid", None)}
SECONDS_OF_HOMING = 1.5                         # the motion takes some more
# Of forms, on a robot that two frameworks reach.
EXCHANGE = "exchange-dark.png"
NEW_ROBOT = "new-robot-dark.png"
INSTALL = "install-dark.png"
PLAYED = "recording-dark.png"
WELCOME = "welcome-dark.png"
TWO_FACES = "simulator: [{{robot: keira, speaks: [ros, player]}}]\nruics:\n  Keira:\n    type: mobilebase\n    rfics:\n      base: {{type: {type}}}\n"
# Made together, as the robot drives meanwhile; the first ones are one view each.
OF_VIEWS = {"scene-mobile-dark.png": "scene3d", "frames-dark.png": "tftree", "graph-dark.png": "graph"}
DEMO = {*OF_VIEWS, "workbench-dark.png", "ros-inspect-dark.png", "workbench-light.png", "ros-plot-light.png"}
KNOWN = {*CONFIGURED, *CONTROLLED, EXCHANGE, NEW_ROBOT, INSTALL, PLAYED, WELCOME, *DEMO}
DRIVE = """
use("Natalie"); waitForLink(); waitFor(() => value("base.scan") && value("base.map"), 20); takeControl();
startRecording("FILE", {robots: ["Natalie"]});
for (let i = 0; i < 4; i++) { drive(0.35, 0, 3); drive(0.1, i % 2 ? 0.5 : -0.5, 2); }
stopRecording();
"""
# Across the building, so that it drives for a while.
GOAL = "{header: {frame_id: map}, pose: {position: {x: 11.5, y: 7.2}, orientation: {w: 1}}}"
BACK = "{header: {frame_id: map}, pose: {position: {x: 3.4, y: 7.0}, orientation: {z: 0.7, w: 0.7}}}"


def save(window, name, part=None, seen=None):
    """
    Small enough for a repository: fewer pixels, and no more colours than can be told apart here. A part is a rectangle of what is seen: of the
    window, or of another one, as of the root with all that lies over the window.
    """
    raw = window.process.out.parent / name
    subprocess.run(["import", "-silent", "-window", seen or window.id, raw], check=True, timeout=30)
    picture = Picture.of(raw)
    left, top, right, bottom = part or (0, 0, picture.width, picture.height)
    subprocess.run(["convert", raw, "-crop", f"{right - left}x{bottom - top}+{left}+{top}", "+repage", "-resize", f"{WIDTH}>", "-dither", "None", "-colors", "255", "-strip", "-define", "png:compression-level=9",
                    f"png8:{IMAGES / name}"], check=True, timeout=60)
    size = (IMAGES / name).stat().st_size
    assert size < MOST_BYTES, f"{name} has {size} bytes"
    print(f"{name}: {size} bytes")


def send(robot, goal):
    robot.tool("rostopic", "pub", "-1", "/move_base_simple/goal", "geometry_msgs/PoseStamped", goal)


def on_its_way(robot, goal, seconds):
    motion = Motion(robot, name=f"odometry-{time.monotonic_ns()}")
    send(robot, goal)
    wait_for(motion.drives, what="motion")
    time.sleep(seconds)                         # what the trail and the plot show


def with_title(views, stack):
    """A view with the line of titles above it."""
    left, top, _, _ = views.lines[stack]
    return left, top, *views.body(stack)[2:]


def of_views(window, views):
    for name, view in OF_VIEWS.items():
        left, top, right, bottom = views.open(view)
        window.move(((left + right) // 2, (top + bottom) // 2))
        time.sleep(10)                          # a cloud and the rates; where all is seen at first
        if view == "scene3d":
            window.click((right - 40, bottom - 60))
            for key in ("Escape", "plus", "plus"):
                Keys.press(key)
            time.sleep(2)
        save(window, name, with_title(views, "main"))
    views.open("map")


def dark(robot, configuration):
    window = Window.open(robot, configuration, "--theme", "dark", name="dark")
    views = Views(window)
    of_views(window, views)
    on_its_way(robot, GOAL, 11)
    save(window, "workbench-dark.png")
    body = views.open("topics")
    left, top, right, bottom = body
    wait_for(lambda: len(views.rows((left + 40, top + 60, (left + right) // 2, bottom))) > 10, what="topics")
    views.filter(body, "odom")
    Keys.press("Return")
    time.sleep(3)
    save(window, "ros-inspect-dark.png")
    window.close()


def light(robot, configuration):
    window = Window.open(robot, configuration, "--theme", "light", name="light")
    wait_for(lambda: window.picture().count(LIGHT["laser"]) > 200, seconds=60, what="a scan")
    on_its_way(robot, BACK, 9)
    save(window, "workbench-light.png")
    on_its_way(robot, GOAL, 12)
    save(window, "ros-plot-light.png")
    window.close()


def configured(processes, environment, wanted):
    """Those of ready configurations, which start their own robots."""
    for name, (configuration, colours) in CONFIGURED.items():
        if name in wanted:
            window = Window(processes.start([ROOT / "robotui", "run", "--theme", "dark", configuration], name, environment))
            wait_for(lambda: all(window.picture().count(colour) > 200 for colour in colours), seconds=180, what=f"all robots of {configuration}")
            time.sleep(15)                      # the rates of its ports, and trails
            save(window, name)
            window.close()


def controlled(processes, environment, wanted):
    """Those of real-time controls, which are started by their configurations, at home or on their way there."""
    for name, (configuration, stack) in CONTROLLED.items():
        if name in wanted:
            window = Window(processes.start([ROOT / "robotui", "run", "--theme", "dark", configuration], name, environment))
            views = Views(window, MANIPULATOR)
            wait_for(window.is_live, seconds=60, what=f"the {configuration}")
            time.sleep(8)                       # the rates of its ports, and a scene that shows all
            subprocess.run([ROOT / "robotui", "rt-ctl", "switch", "Homing", "1"], env=environment, check=True, timeout=60)
            time.sleep(SECONDS_OF_HOMING)
            save(window, name, with_title(views, stack) if stack else None)
            window.close()
            window.process.wait(60)


def titled(title):
    """The window of a form, once it is there."""
    def found():
        names = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True, text=True, timeout=20, check=False)
        return next(iter(names.stdout.split()), None)
    return wait_for(found, what=f"the window {title}")


def everything():
    return Picture(output("import", "-silent", "-window", "root", "-depth", "8", "ppm:-"))


def two_faces(processes, framework="ros"):
    file = processes.folder / "two-faces.yaml"
    file.write_text(TWO_FACES.format(type=framework))
    return file


def exchange(processes, environment):
    """The file names another framework: the form opens by itself, and tries it."""
    file = two_faces(processes)
    window = Window(processes.start([ROOT / "robotui", "run", "--theme", "dark", file], "exchange", environment))
    wait_for(window.is_live, seconds=60, what="the robot")
    time.sleep(10)                              # the rates of its ports
    two_faces(processes, "player")
    titled("^Change the framework of Keira")
    seen = everything()
    wait_for(lambda: everything().count(DARK["bad"], 0, seen.height // 2) > 500, what="the verdict, below what is lost")
    time.sleep(1)
    used = int(everything().pixels.any(axis=(1, 2)).nonzero()[0].max())   # what lies below the window is black
    save(window, EXCHANGE, (0, 0, seen.width, used), seen="root")
    Keys.press("Escape")
    window.close()


def new_robot(processes, environment):
    """The second step for a robot that speaks Player."""
    robot = processes.start([ROOT / "robotui", "run", "--json", two_faces(processes)], "two-faces", environment)
    said = wait_for(lambda: re.search(r"export PLAYER_HOST=(\S+) PLAYER_PORT=(\S+)", robot.err.read_text()), seconds=60, what="the robot")
    (processes.folder / "empty.yaml").write_text("ruics: {}\n")
    place = {"PLAYER_HOST": said.group(1), "PLAYER_PORT": said.group(2)}
    window = Window.open(Robot(processes, "", environment | place), processes.folder / "empty.yaml", "--theme", "dark", name="new")
    form = Form(window)
    form.framework("player")
    form.connect()
    wait_for(form.may_go_on, what="the robot")
    form.next()
    wait_for(form.may_go_on, what="views")
    time.sleep(2)
    save(window, NEW_ROBOT, seen=form.window)
    output("xdotool", "windowactivate", "--sync", form.window, "key", "Escape", "sleep", "1")
    window.close()


def install(processes, environment):
    """A site that the user knows, opened by the search."""
    sample_sites.make(processes.folder, "one")
    (processes.folder / "served").mkdir()
    site = Served(processes.folder, processes.folder / "served")
    site.show("one")
    state = processes.folder / "install-state/robotui"
    state.mkdir(parents=True)
    (state / "update-sites.txt").write_text(f"{site.address}\n", encoding="utf-8")
    (processes.folder / "empty.yaml").write_text("ruics: {}\n", encoding="utf-8")
    window = Window.open(Robot(processes, "", environment), processes.folder / "empty.yaml", "--theme", "dark", name="install")
    output("xdotool", "windowactivate", "--sync", window.id)
    output("xdotool", "key", "--delay", "0", "ctrl+3", *"install", "Return")
    form = titled("^Install software")
    wait_for(lambda: Picture(output("import", "-silent", "-window", form, "-depth", "8", "ppm:-")).count(DARK["accent"]) > 20, what="what the site offers")
    time.sleep(1)
    save(window, INSTALL, seen=form)
    output("xdotool", "windowactivate", "--sync", form, "key", "Escape", "sleep", "1")
    window.close()
    site.server.shutdown()


def searched(window, words, title):
    """The window that a command opens which is found by its words."""
    output("xdotool", "windowactivate", "--sync", window.id)
    output("xdotool", "key", "ctrl+3", "sleep", "1", "type", "--delay", "20", words)
    output("xdotool", "sleep", "1", "key", "Return")
    return titled(title)


def welcome(processes, environment):
    (processes.folder / "empty.yaml").write_text("ruics: {}\n", encoding="utf-8")
    window = Window.open(Robot(processes, "", environment), processes.folder / "empty.yaml", "--theme", "dark", name="welcome")
    form = searched(window, "welcome", "^Welcome")
    time.sleep(1)
    save(window, WELCOME, seen=form)
    output("xdotool", "windowactivate", "--sync", form, "key", "Escape", "sleep", "1")
    window.close()


def recording(processes, environment):
    """A recording of the simulated robot that plays, with its topics: it is made first, on a drive through the room."""
    (processes.folder / "drive.js").write_text(DRIVE.replace("FILE", str(processes.folder / "natalie.mcap")), encoding="utf-8")
    recorded = processes.start([ROOT / "robotui", "run", ROOT / "configs/demo.yaml", "--script", processes.folder / "drive.js", "--text"], "record", environment)
    assert recorded.wait(timeout=120) == 0, recorded.err.read_text()
    window = Window(processes.start([ROOT / "robotui", "run", "--theme", "dark", processes.folder / "natalie.mcap"], "recording", environment))
    bar = Bar(window)
    bar.expand()
    window.move((NAVIGATOR + 400, bar.height - 8))    # away from the button and its tooltip, and from all that answers
    wait_for(lambda: (bar.position() or 0) > bar.at(0.3)[0], seconds=60, what="a way gone")
    save(window, PLAYED)
    window.close()


def main():
    if missing():
        sys.exit(f"pictures need {missing()}")
    wanted = set(sys.argv[1:]) or KNOWN
    if wanted - KNOWN:
        sys.exit(f"known are {', '.join(sorted(KNOWN))}")
    with tempfile.TemporaryDirectory() as folder:
        processes = Processes(pathlib.Path(folder))
        environment = dict(os.environ) | {"ROS_HOME": f"{folder}/ros", "XDG_STATE_HOME": f"{folder}/state", "PYTHONUNBUFFERED": "1"}
        configuration = pathlib.Path(folder) / "demo.yaml"
        configuration.write_text((ROOT / "configs" / "demo.yaml").read_text().replace("simulator: mobile-base\n", ""))
        try:
            configured(processes, environment, wanted)
            controlled(processes, environment, wanted)
            if EXCHANGE in wanted:
                exchange(processes, environment)
            if NEW_ROBOT in wanted:
                new_robot(processes, environment)
            if INSTALL in wanted:
                install(processes, environment)
            if WELCOME in wanted:
                welcome(processes, environment)
            if PLAYED in wanted:
                recording(processes, environment)
            if wanted & DEMO:
                robot = start_simulator(processes, environment, 0, "simulator")
                dark(robot, configuration)
                light(robot, configuration)
        finally:
            processes.end()


if __name__ == "__main__":
    main()
