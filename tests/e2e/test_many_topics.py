"""A window on a robot with two thousand topics of two hundred nodes, next to a roscore."""
import json
import pathlib
import subprocess

import pytest

from conftest import busy, wait_for
from desktop import Keys, Window, missing
from views import Views

PEERS = pathlib.Path(__file__).parent / "peers"
TOPICS = 2000
NODES = 200
# How fluid the window is says ./robotui bench ui. Here only a display thread that hangs fails: it answers a hundred times a second.
ANSWERS = 50
HANGS = 10


@pytest.fixture(autouse=True)
def last_picture(tmp_path, processes):
    yield
    subprocess.run(["import", "-silent", "-window", "root", str(tmp_path / "end.png")], timeout=60, check=False)


@pytest.fixture
def large(roscore):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    crowd = roscore.start_tool("/usr/bin/python3", PEERS / "many_topics.py", str(TOPICS), str(NODES), name="crowd")
    wait_for(lambda: "registered" in crowd.out.read_text(), seconds=120, what="the registrations")
    return roscore


def test_a_window_on_two_thousand_topics_finds_one_and_stays_usable(large, tmp_path):
    file = tmp_path / "measure.json"
    window = Window.open(large, "ros", "--measure", file)
    views = Views(window)
    left, top, right, bottom = body = views.open("topics")
    names = (left + 40, top + 60, (left + right) // 2, bottom)
    wait_for(lambda: len(views.rows(names)) > 10, seconds=60, what="the list of topics")

    views.filter(body, "sought words")
    wait_for(lambda: len(views.rows(names)) == 1, seconds=60, what="the one topic that fits")
    window.click((names[0] + 40, names[1] + views.rows(names)[0][0] + 5))
    Keys.press("Return")

    wait_for(lambda: "* " in subscribers(large, "/sought/words"), seconds=60, what="a subscription")
    echo = (left + int((right - left) * 0.6), top + 60, right, bottom)
    views.lives(echo)
    wait_for(lambda: answers(file), seconds=60, what="the first answers of the display thread")
    for _ in range(3):
        before = answers(file)
        wait_for(lambda: answers(file) >= before + ANSWERS, seconds=HANGS * busy(), what="answers of the display thread")
        views.lives(echo)


def subscribers(robot, topic):
    return robot.tool("rostopic", "info", topic).split("Subscribers:")[1]


def answers(file):
    """How many signs the display thread has given so far; written every second, but not while it gives none."""
    return json.loads(file.read_text())["display_ms"]["count"] if file.exists() else 0
