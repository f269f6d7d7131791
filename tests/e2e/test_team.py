"""A team in a window: a swarm of six simulated robots at one master, as a user commands them and as the robots see it."""
import os
import shutil
import subprocess

import pytest

from conftest import ROS_TOOLS, Processes, start_simulator, wait_for
from desktop import DARK, Keys, Window, missing, output
from views import Views

ROBOTS = [f"r{number}" for number in range(1, 7)]
TEAM = ({"places": ("map", "scene3d")}, {"team": ("team",), "records": ("plot", "log", "alerts", "connections")})
CONFIGURATION = """
ruics:
  Swarm:
    type: team
    rfics:
      hall: {type: ros, robot: hall, topics: map}
      ${robot}: {for: r1..r6, type: ros, robot: "${robot}", namespace: "/${robot}"}
    frames:
      - {for: r1..r6, parent: hall/map, child: "${robot}/map"}
    uics:
      team: {left_out: [hall]}
  ${robot}:
    for: r1..r6
    type: mobilebase
    start: when_shown
    rfics:
      base: {type: ros, namespace: "/${robot}"}
"""
HEADING, ROW = 26, 26
BAR = 36


class Team:
    """All that the tests of this module share."""

    def __init__(self, robot, window):
        self.robot, self.window = robot, window
        self.views = Views(window, TEAM)
        self.speeds = {name: robot.start_tool("rostopic", "echo", "-p", f"/{name}/odom/twist/twist/linear/x", name=f"{name}-speed") for name in ROBOTS}
        self.tasks = {name: robot.start_tool("rostopic", "echo", "-p", f"/{name}/move_base/status/status_list[0]/text", name=f"{name}-task")
                      for name in ROBOTS}

    @staticmethod
    def last(process):
        lines = [line for line in process.out.read_text().splitlines(keepends=True) if line.endswith("\n") and not line.startswith("%")]
        return lines[-1].strip().split(",", 1)[1].strip('"') if lines else ""

    def speed(self, name):
        return abs(float(self.last(self.speeds[name]) or "nan"))

    def task(self, name):
        return self.last(self.tasks[name])

    def driving(self):
        return [name for name in ROBOTS if self.speed(name) > 0.05]

    def corner(self):
        """The upper left corner of the team view, below its title."""
        left, _, _, bottom = self.views.lines["team"]
        return left, bottom

    def press(self, number):
        """One of the buttons, from the left; the first is as wide as its words."""
        left, top = self.corner()
        self.window.click((left + (50, 130, 210)[number], top + BAR // 2))

    def row(self, number):
        left, top = self.corner()
        return left + 40, top + BAR + HEADING + ROW * number - ROW // 2

    def bad(self):
        """Pixels of what is bad in the table's rows."""
        left, top = self.corner()
        picture = self.window.picture()
        return picture.count(DARK["bad"], left, top + BAR + HEADING, picture.width, top + BAR + HEADING + ROW * len(ROBOTS))

    def nodes(self):
        return [node for node in self.robot.nodes() if "robotui" in node]


@pytest.fixture(scope="module")
def team(tmp_path_factory):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    absent = [tool for tool in ROS_TOOLS if shutil.which(tool) is None]
    if absent:
        pytest.skip(f"the ROS tools {absent} are not installed")
    folder = tmp_path_factory.mktemp("team")
    processes = Processes(folder)
    environment = dict(os.environ) | {"ROS_HOME": str(folder / "ros"), "XDG_STATE_HOME": str(folder / "state"), "PYTHONUNBUFFERED": "1",
                                      "ROS_IP": "127.0.0.1"}
    configuration = folder / "team.yaml"
    configuration.write_text(CONFIGURATION)
    try:
        robot = start_simulator(processes, environment, 0, "swarm", "--swarm", len(ROBOTS))
        yield Team(robot, Window.open(robot, configuration))
    finally:
        processes.end()


@pytest.fixture(autouse=True)
def last_picture(tmp_path, team):
    yield
    subprocess.run(["import", "-silent", "-window", "root", str(tmp_path / "end.png")], timeout=60, check=False)


def test_one_stop_stops_all_at_once_and_a_release_asks(team):
    wait_for(lambda: len(team.driving()) >= 4, what="a swarm on its way")
    wait_for(lambda: len(team.nodes()) == len(ROBOTS) + 1, what="an interface for each robot, and none of their own UIs")

    team.press(0)
    wait_for(lambda: not team.driving(), what="standstill of all")
    wait_for(lambda: team.bad() > 200, what="six rows that say so")

    team.press(1)
    assert team.bad() > 200, "nothing is released before the answer"
    Keys.press("space")
    wait_for(lambda: team.bad() < 60, what="the release")
    assert not team.driving(), "nothing moves by that"


def test_a_goal_goes_to_the_selected_robot_alone(team):
    team.window.click(team.row(2))
    left, top, right, bottom = team.views.lines["places"]
    Keys.press("Tab")
    place = ((left + right) // 2, bottom + 200)
    team.window.move(place)
    output("xdotool", "click", "3")
    # At a place without a robot the first entry is the map, the second sends who is selected.
    Keys.press("Down")
    Keys.press("Down")
    Keys.press("Return")
    wait_for(lambda: team.task("r2").startswith("going to") or team.task("r2") == "arrived", what="r2 on its way")
    assert all(not team.task(name).startswith("going") for name in ROBOTS if name != "r2")


def test_a_killed_robot_says_so_and_the_others_go_on(team):
    before = team.bad()
    assert "killed" in team.robot.tool("rosnode", "kill", "/r5/robot")
    wait_for(lambda: team.bad() > before + 20, what="a row that says why")
    rows = len(team.speeds["r4"].out.read_text())
    wait_for(lambda: len(team.speeds["r4"].out.read_text()) > rows + 500, what="odometry of the next one")
    assert team.window.process.poll() is None


def test_enter_opens_the_robots_own_interface(team):
    before = len(team.nodes())
    team.window.click(team.row(1))
    Keys.press("Return")
    wait_for(lambda: len(team.nodes()) == before + 1, what="the interface of its own, which did not run before")
