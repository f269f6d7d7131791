"""The views of the demo's robot, as a user drives them and as the robot sees it. One window for all."""
import json
import os
import pathlib
import shutil
import subprocess

import numpy
import pytest

from conftest import ROS_TOOLS, Processes, start_simulator, wait_for
from desktop import DARK, Keys, Motion, Window, missing
from test_window import drive
from views import STACKS, Views, Words, like, type_words

PEERS = pathlib.Path(__file__).parent / "peers"
# The plot and an alert that is always on: no battery is fuller than full.
CONFIGURATION = """
ruics:
  Robot:
    type: mobilebase
    rfics:
      base: {type: ros}
    uics:
      plot:
        window: 30
        axes:
          - traces:
              - {source: base.odom, path: linear.x, label: forward, unit: m/s}
      sound:
        alerts:
          - {name: Never full, when: battery_state charge < 2, sound: beep}
    connect:
      camera.image: base.camera/image_raw
"""
BLUE = 0x4da3ff


class Robot:
    """All that the tests of a module share."""


@pytest.fixture(scope="module")
def shared(tmp_path_factory):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    absent = [tool for tool in ROS_TOOLS if shutil.which(tool) is None]
    if absent:
        pytest.skip(f"the ROS tools {absent} are not installed")
    folder = tmp_path_factory.mktemp("views")
    processes = Processes(folder)
    environment = dict(os.environ) | {"ROS_HOME": str(folder / "ros"), "XDG_STATE_HOME": str(folder / "state"), "PYTHONUNBUFFERED": "1"}
    configuration = folder / "views.yaml"
    configuration.write_text(CONFIGURATION)
    try:
        all_of_it = Robot()
        all_of_it.robot = start_simulator(processes, environment, 0, "simulator")
        all_of_it.window = Window.open(all_of_it.robot, configuration)
        all_of_it.views = Views(all_of_it.window)
        all_of_it.motion = Motion(all_of_it.robot)
        all_of_it.folder = folder
        yield all_of_it
    finally:
        processes.end()


@pytest.fixture(autouse=True)
def last_picture(tmp_path, shared):
    """Keeps what the screen showed at the end of each test; none leaves the robot driving or stopped."""
    yield
    subprocess.run(["import", "-silent", "-window", "root", str(tmp_path / "end.png")], timeout=60, check=False)


@pytest.fixture
def robot(shared):
    return shared.robot


@pytest.fixture
def window(shared):
    return shared.window


@pytest.fixture
def views(shared):
    return shared.views


@pytest.fixture
def motion(shared):
    return shared.motion


@pytest.fixture
def keys():
    hands = Keys()
    yield hands
    hands.let_go()


# ---- all tabs -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("view", [view for views in STACKS.values() if len(views) > 1 for view in views])
def test_each_tab_opens_and_shows_something(views, view):
    body = views.open(view)

    wait_for(lambda: shows(views.part(body)), what=f"something to see in {view}")


def shows(part):
    """Letters or lines in a tenth of the height at least."""
    ink = numpy.abs(part.astype(int) - part[3, 3]).max(axis=2) > 40
    return ink.any(axis=1).mean() > 0.1


@pytest.mark.parametrize("view", ["gps", "plot", "diagnostics", "joints", "status", "connections"])
def test_what_a_tab_shows_is_live(views, view):
    views.lives(views.open(view))


# ---- topics ---------------------------------------------------------------------------------------------------------


def select_topic(views, words):
    """Filters the list down to a topic and selects it; answers the rectangle of what is about it."""
    left, top, right, bottom = body = views.open("topics")
    views.filter(body, words)
    return left + int((right - left) * 0.6), top + 36, right, bottom


def leaf(views, detail, number):
    """Turns to a leaf of the selection: the last three words beside its name."""
    left, top, right, _ = detail
    words = wait_for(lambda: enough(Words(views.window.picture(), (left, top + 4, right, top + 28), 14).places(), 4), what="the leaves")
    views.window.click(words[number - 3])


def enough(places, count):
    return places if len(places) >= count else None


def subscribers(robot, topic):
    text = robot.tool("rostopic", "info", topic)
    return [line for line in text.split("Subscribers:")[1].splitlines() if line.strip().startswith("* ")]


def test_an_echo_subscribes_and_a_view_that_is_left_takes_nothing(views, robot):
    assert not subscribers(robot, "/imu/data")

    left, top, right, bottom = select_topic(views, "imu/data")
    Keys.press("Return")

    wait_for(lambda: subscribers(robot, "/imu/data"), what="a subscription")
    views.lives((left, top + 60, right, bottom))
    wait_for(lambda: len(views.rows((left + 120, top + 60, right, bottom))) > 8, what="all of the message")

    views.open("map")
    wait_for(lambda: not subscribers(robot, "/imu/data"), what="the end of the subscription")


def test_a_message_from_the_form_arrives(views, robot):
    heard = robot.start_tool("/usr/bin/python3", PEERS / "listener.py", "/words", name="listener")
    wait_for(lambda: "/words" in robot.tool("rostopic", "list"), what="the listener")

    detail = select_topic(views, "/words")
    leaf(views, detail, 2)
    fields = wait_for(lambda: views.fields(detail), what="the form")
    views.fill(fields[0], "good morning")
    Keys.press("ctrl+Return")

    wait_for(lambda: "good morning" in heard.out.read_text(), what="the message")


# ---- services -------------------------------------------------------------------------------------------------------


def form_of(views, view, words):
    """Chooses one of what can be asked; answers the rectangle of form, answer and history."""
    left, top, right, bottom = body = views.open(view)
    views.filter(body, words, left=True)
    return left + int((right - left) * 0.34) + 6, top, right, bottom


def test_a_service_called_from_the_form_has_its_effect_and_its_reply_is_seen(views, robot):
    diagnostics = robot.start_tool("rostopic", "echo", "/diagnostics", name="diagnostics")
    wait_for(lambda: motors(diagnostics) == "on", what="motors that are on")

    form = form_of(views, "services", "motors")
    call = views.button(form)
    reply = ((form[0] + form[2]) // 2 + 20, form[1] + 60, form[2], call[1] + 16)
    before = views.part(reply)
    views.window.click(call)

    try:
        wait_for(lambda: motors(diagnostics) == "switched off", what="motors that are off")
        wait_for(lambda: not numpy.array_equal(before, views.part(reply)), what="the reply")
        wait_for(lambda: len(views.rows(reply)) >= 2, what="success and message")
    finally:
        robot.tool("rosservice", "call", "/motors", "true")
    wait_for(lambda: motors(diagnostics) == "on", what="motors that are on")


def motors(echo):
    """What the robot has last said about its motors."""
    parts = echo.out.read_text().split('name: "robot: motors"')
    said = [part.split("message:")[1].split('"')[1] for part in parts[1:] if part.count('"') > 3]
    return said[-1] if said else None


# ---- actions --------------------------------------------------------------------------------------------------------


@pytest.fixture
def results(robot, request):
    """What move_base says at the end of goals: 2 for preempted, 3 for succeeded."""
    echo = robot.start_tool("rostopic", "echo", "/move_base/result/status/status", name=f"results-{request.node.name}")
    return lambda: [int(line) for line in echo.out.read_text().splitlines() if line.isdigit()]


def send_goal(views, x, y):
    """Fills in the form of move_base as far as it is needed and sends it; answers the line of the buttons."""
    form = form_of(views, "actions", "move_base")
    column, row = views.button(form)
    fields = (form[0], form[1] + 50, (form[0] + form[2]) // 2 + 20, row - 18)
    found = wait_for(lambda: enough(views.fields(fields), 4), what="the form")
    if found[0][1] > form[1] + 160:
        views.window.click((form[0] + 42, form[1] + 104))
        views.window.move((form[0] + 42, form[1] + 10))     # a tooltip over the fields would hide them
    found = wait_for(lambda: opened(views.fields(fields), form), what="the fields of the header")
    for number, words in ((2, "map"), (3, str(x)), (4, str(y))):
        views.fill(found[number], words)
    views.window.click(views.button((form[0], row - 16, form[2], row + 16)))
    return form[0] + 2, row - 8, form[2], row + 8


def opened(fields, form):
    return fields if len(fields) > 4 and fields[0][1] < form[1] + 160 else None


def test_a_goal_from_the_form_moves_the_robot_and_cancel_preempts_it(views, motion, results):
    buttons = send_goal(views, 7, 5)
    wait_for(motion.drives, seconds=60, what="motion")

    views.window.click(Words(views.window.picture(), buttons, 10).places()[1])

    wait_for(lambda: results() == [2], what="the end of the goal")
    wait_for(motion.stands, what="standstill")


def test_a_stop_cancels_a_goal(views, motion, results, window):
    send_goal(views, 7, 5)
    wait_for(motion.drives, seconds=60, what="motion")

    Keys.press("F12")

    try:
        wait_for(motion.stands, what="standstill")
        wait_for(lambda: results() == [2], what="the end of the goal")
        assert motion.stands_for(50)
    finally:
        window.click(wait_for(window.release_button, what="the window to show the stop"))
    wait_for(lambda: window.release_button() is None, what="the release")
    assert motion.stands_for(25), "a release moves nothing"


# ---- parameters -----------------------------------------------------------------------------------------------------


def leaves_of_parameters(views, body, number):
    left, top, right, _ = body
    words = wait_for(lambda: enough(Words(views.window.picture(), (left, top + 6, right - 200, top + 30), 14).places(), 2),
                     what="the leaves")
    views.window.click(words[number])


def test_a_parameter_edited_in_place_is_what_the_robot_has(views, robot):
    assert float(robot.tool("rosparam", "get", "/robot/max_linear_speed")) != 0.55
    body = views.open("parameters")
    leaves_of_parameters(views, body, 0)
    views.filter(body, "linear_speed")

    Keys.press("Down")      # from the namespace to what is in it
    Keys.press("Return")
    views.still(body)
    Keys.press("ctrl+a")
    type_words("0.55")
    Keys.press("Return")

    wait_for(lambda: float(robot.tool("rosparam", "get", "/robot/max_linear_speed")) == 0.55, what="the parameter")


def test_a_setting_of_a_running_program_is_what_its_clients_see(views, robot):
    left, top, right, bottom = body = views.open("parameters")
    leaves_of_parameters(views, body, 1)
    views.filter(body, "robot")
    limits = (left + (right - left) // 2, top + 60, right, bottom)
    fields = wait_for(lambda: enough(views.fields(limits), 4), what="the settings")

    views.fill(fields[0], "0.5")
    Keys.press("Return")

    wait_for(lambda: settings(robot)["max_linear_speed"] == 0.5, what="the setting")


def settings(robot):
    return json.loads(robot.tool("/usr/bin/python3", str(PEERS / "settings.py"), "/robot", seconds=40).splitlines()[-1])


# ---- records --------------------------------------------------------------------------------------------------------


def test_the_plot_shows_how_fast_it_drives(views, window, motion, keys):
    left, top, right, bottom = views.open("plot")
    curve = (left + 60, top + 10, left + int((right - left) * 0.66), bottom - 30)

    drive(window, motion, keys)
    wait_for(lambda: height(views.part(curve)) > 30, what="a curve that rises")
    keys.let_go()


def height(part):
    rows = numpy.flatnonzero(like(part, BLUE, 40).any(axis=1))
    return int(rows[-1] - rows[0]) if len(rows) else 0


def test_the_log_lists_what_the_robot_says(views, robot):
    left, top, right, bottom = views.open("log")
    lines = (left, top + 40, right, bottom)

    robot.tool("rosservice", "call", "/motors", "false")
    robot.tool("rosservice", "call", "/motors", "true")
    wait_for(lambda: len(views.rows(lines)) >= 2, what="two lines of the log")

    robot.tool("rostopic", "pub", "-1", "/rosout_agg", "rosgraph_msgs/Log", "{level: 8, name: /peer, msg: an error}")
    wait_for(lambda: like(views.part(lines), DARK["bad"]).sum() > 20, what="an error")


def test_an_alert_is_told_in_words(window):
    def told():
        picture = window.picture()
        return picture.count(0xe0a93b, 100, picture.height - 24, picture.width // 2, picture.height) > 60

    wait_for(told, what="the alert")


def test_an_alert_is_listed_until_it_was_seen(views, window):
    left, top, _, bottom = views.open("alerts")
    dots = (left, top + 60, left + 40, bottom)
    _, row = wait_for(lambda: window.picture().middle(DARK["bad"], *dots), what="the alert")

    window.click((left + 120, row))
    Keys.press("a")

    wait_for(lambda: window.picture().count(DARK["bad"], *dots) == 0, what="the alert to wait for nobody")
    assert window.picture().count(DARK["warning"], *dots) > 10, "it lasts"


# ---- the end --------------------------------------------------------------------------------------------------------


def test_at_the_end_nothing_went_wrong_on_the_way(window):
    """Last: also closing is quiet."""
    window.close()

    assert window.process.wait(90) == 0
    said = window.process.err.read_text()
    assert "Exception" not in said and "ERROR" not in said, said
