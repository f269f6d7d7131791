"""Maps that no robot means, sent by rospy: who watches goes on, is told which topic and which number, and keeps the last good map."""
import pathlib

import pytest

from conftest import last_of, start_robotui, wait_for
from desktop import DARK, NAVIGATOR, TOP_BAR, Keys, Window, missing, output

PEERS = pathlib.Path(__file__).parent / "peers"
SENTENCES = {"coarse": "resolution: must be from", "far": "origin.position: must be", "nowhere": "position"}
# Pixels of a line of words.
WORDS = 100
# Pixels of the walls of the good map, at least.
WALLS = 5_000
# How much brighter a wall is than the ground, also where the map is faded.
CONTRAST = 20


class Sender:
    """Says which map the robot sends."""

    def __init__(self, robot, folder):
        self.wanted = folder / "kind"
        self.send("good")
        for peer, arguments in {"rospy_robot": (), "rospy_map": (self.wanted,)}.items():
            robot.start_tool("/usr/bin/python3", PEERS / f"{peer}.py", *arguments, name=peer)

    def send(self, kind):
        new = self.wanted.with_suffix(".new")
        new.write_text(kind)
        new.replace(self.wanted)


@pytest.fixture
def sender(roscore, tmp_path):
    return Sender(roscore, tmp_path)


def test_the_port_names_topic_and_number_until_a_good_map_comes(roscore, sender):
    robotui = start_robotui(roscore, "run", "--json", "ros")

    def is_good():
        line = last_of(robotui, "map")
        return line and line["value"] and not line["problem"]

    wait_for(is_good, seconds=90, what="a map")
    good = last_of(robotui, "map")["value"]
    for kind, sentence in SENTENCES.items():
        sender.send(kind)
        wait_for(lambda: sentence in last_of(robotui, "map")["problem"], what=f"the sentence on a map that is {kind}")
        assert "/map" in last_of(robotui, "map")["problem"]
        assert last_of(robotui, "map")["value"] == good
        assert last_of(robotui, "scan")["link"] == "connected" and not last_of(robotui, "scan")["problem"]

        sender.send("good")
        wait_for(is_good, what=f"a good map after one that is {kind}")


def test_the_window_answers_and_stops_whatever_map_comes(roscore, sender):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    window = Window.open(roscore, "ros")
    wait_for(window.is_live, what="a live robot")
    wait_for(lambda: walls(window) > WALLS and not warned(window), what="a map without a warning")

    for kind in SENTENCES:
        sender.send(kind)
        wait_for(lambda: warned(window), what=f"the warning of a map that is {kind}")
        assert walls(window) > WALLS, "the last good map is gone"
        output("xdotool", "windowactivate", "--sync", window.id)
        Keys.press("F12")
        wait_for(window.release_button, what="the stop by F12")
        window.click(window.release_button())
        wait_for(lambda: not window.release_button(), what="the release")
        sender.send("good")
        wait_for(lambda: not warned(window), what=f"a good map after one that is {kind}")


def warned(window):
    """Whether the map shows words of warning."""
    picture = window.picture()
    return picture.count(DARK["warning"], *map_of(picture)) > WORDS


def walls(window):
    """How many pixels of the map's lower part are wall."""
    picture = window.picture()
    left, top, right, bottom = map_of(picture)
    part = picture.pixels[(top + bottom) // 2:bottom, left:right].astype(int)
    return int((part[:, :, 0] - (DARK["ground"] >> 16) > CONTRAST).sum())


def map_of(picture):
    return NAVIGATOR + 60, 2 * TOP_BAR, int(picture.width * 0.68), int(picture.height * 0.58)
