"""Views arranged by hand in a real window, and what is left of that after a crash."""
import os
import random
import signal
import time

import pytest
import yaml

from conftest import Robot, free_port, wait_for
from desktop import DARK, NAVIGATOR, TOP_BAR, Keys, Window, java_of, missing, output, pause

CONFIG = """
ruics:
  Natalie:
    rfics: {base: {type: ros}}
    uics: {map: {}, plot: {}, status: {}}
    layout: {row: [{tabs: [map, plot]}, status]}
    perspectives:
      Apart: {column: [map, status]}
      Map: map
      Plot first: {row: [{tabs: [status, plot], front: plot}, map]}
"""
WRITTEN = {"row": [{"weight": 1.0, "tabs": ["map", "plot"]}, {"weight": 1.0, "view": "status"}]}
TITLE = TOP_BAR + 15
TITLE_NEAR, TITLE_HALF = 100, 20                      # how far the words of a title may be from where it is taken
NAMES = ("Apart", "Map", "Plot first")


@pytest.fixture
def nowhere(processes, environment):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    return Robot(processes, f"http://127.0.0.1:{free_port()}", environment)


class Arranged:
    """A window of one configuration, and what is kept beside it. It may be killed and started again."""

    def __init__(self, robot, folder):
        self.robot, self.state = robot, folder / "layouts-state" / "robotui" / "overlays"
        self.file = folder / "layouts.yaml"
        self.file.write_text(CONFIG)
        self.start()

    def start(self):
        self.window = Window.open(self.robot, self.file, name="layouts")
        output("xdotool", "windowactivate", "--sync", self.window.id)
        wait_for(lambda: self.window.picture().count(DARK["ground"]) > 50_000, seconds=60, what="views")

    def kill(self):
        os.kill(java_of(self.window.process, "equinox"), signal.SIGKILL)
        self.window.process.wait(60)

    def kept(self):
        """What is kept of Natalie's views; nothing where nothing is."""
        files = [file for file in self.state.glob("*.yaml")]
        return yaml.safe_load(files[0].read_text()).get("Natalie", {}).get("views", {}) if files else {}

    def layout(self):
        return self.kept().get("arrangement", {}).get("layout", WRITTEN)

    def size(self):
        picture = self.window.picture()
        return picture.width, picture.height

    def accent(self):
        return self.window.picture().count(DARK["accent"], NAVIGATOR, TOP_BAR, *self.size())

    def drag(self, start, end):
        """As a hand does: it takes a title that it sees, and lets go when it sees the frame around the place where the view would lie."""
        wait_for(lambda: self.title_at(start), what="the title")
        before = self.accent()
        self.window.move(start)
        keys = Keys()
        keys.grip()
        try:
            for part in range(1, 11):
                self.window.move([int(a + (b - a) * part / 10) for a, b in zip(start, end)])
            wait_for(lambda: self.framed(end, before), what="a frame around the place where it would lie")
        finally:
            keys.let_go()

    def framed(self, end, before):
        """Whether the place is framed; a hand that does not see it moves a little."""
        self.window.move([end[0] - 1, end[1]])
        self.window.move(end)
        return self.accent() > before + 2000

    def title_at(self, place):
        """Whether the title of a view that is seen is painted near a place."""
        x, y = place
        return self.window.picture().count(DARK["text"], x - TITLE_NEAR, y - TITLE_HALF, x + TITLE_NEAR, y + TITLE_HALF) > 20


def middle(arranged):
    width, height = arranged.size()
    return NAVIGATOR + (width - NAVIGATOR) // 2, TOP_BAR + (height - TOP_BAR) // 2


def test_a_view_is_dragged_and_lies_there_after_a_crash(nowhere, tmp_path):
    arranged = Arranged(nowhere, tmp_path)
    (x, _), (width, height) = middle(arranged), arranged.size()

    arranged.drag((x + 40, TITLE), (NAVIGATOR + 200, height - 100))

    below = {"column": [{"weight": 0.5, "tabs": ["map", "plot"]}, {"weight": 0.5, "view": "status"}]}
    wait_for(lambda: arranged.layout() == below, what="the view below the map")
    arranged.kill()
    arranged.start()
    assert arranged.layout() == below
    # Where it lies it can be dragged away.
    arranged.drag((NAVIGATOR + 90, middle(arranged)[1] - 10), (width - 80, TOP_BAR + 300))
    wait_for(lambda: arranged.layout() == {"row": [{"weight": 0.5, "tabs": ["map", "plot"]}, {"weight": 0.5, "view": "status"}]},
             what="the view at the right again")
    output("xdotool", "key", "ctrl+alt+z")
    wait_for(lambda: arranged.layout() == below, what="the change that was taken back")


def test_one_more_view_is_added_by_its_name(nowhere, tmp_path):
    arranged = Arranged(nowhere, tmp_path)

    output("xdotool", "key", "--delay", "0", "ctrl+shift+a", *"plot", "Return")

    wait_for(lambda: arranged.kept().get("arrangement", {}).get("added") == {"plot-2": "plot"}, what="a second plot")
    arranged.kill()
    arranged.start()
    assert arranged.kept()["arrangement"]["added"] == {"plot-2": "plot"}

    output("xdotool", "key", "--delay", "0", "ctrl+shift+a", *"console", "Return")
    wait_for(lambda: arranged.kept()["arrangement"]["added"].get("console") == "console", what="a console")
    # The line is kept before the view is there: what is typed until then goes elsewhere, and is typed again. It has no A, by which a
    # plot opens its list of fields, which would take all that follows.
    wait_for(lambda: typed(arranged, "Plot first"), what="what was typed into it")


def typed(arranged, perspective):
    output("xdotool", *pause(1), "type", "--delay", "30", f'perspective("{perspective}")\n')
    end = time.monotonic() + 4
    while arranged.kept().get("perspective") != perspective and time.monotonic() < end:
        time.sleep(0.1)
    return arranged.kept().get("perspective") == perspective


def test_whenever_it_is_killed_it_starts_with_a_layout_that_was(nowhere, tmp_path):
    times = 50 if os.environ.get("ROBOTUI_LONG") == "1" else 5
    chance = random.Random(11)
    arranged = Arranged(nowhere, tmp_path)
    wanted = {}
    for number, name in enumerate(NAMES, 1):
        output("xdotool", "key", f"ctrl+alt+{number}")
        wait_for(lambda: arranged.kept().get("perspective") == name, what=f"the perspective {name}")
        wanted[name] = arranged.layout()
    assert wanted["Map"] == {"view": "map"} and len(wanted) == 3

    for _ in range(times):
        for _ in range(chance.randrange(1, 6)):
            output("xdotool", "key", f"ctrl+alt+{chance.randrange(1, 4)}", "sleep", f"{chance.random() * 0.4:.2f}")
        arranged.kill()
        kept = arranged.kept()
        assert wanted[kept["perspective"]] == kept["arrangement"]["layout"]
        assert not list(arranged.state.glob("*damaged*"))
        arranged.start()
    assert arranged.kept() == kept
