"""Recordings that are named in place of a configuration: views that fit, and a bar by which they are moved in time."""
import numpy
import pytest

from conftest import SHARED, Robot, start_robotui, wait_for
from desktop import DARK, NAVIGATOR, Keys, Window, missing, output

RECORDING = SHARED / "data/bags/sena_loop.bag"      # a car goes round a block for 59 s, with a laser scanner
STATUS, BUTTONS, STRIP = 24, 28, 48                 # heights, from the bottom of the window
CLOSE = 2.5                                         # points, on the strip


@pytest.fixture
def nobody(processes, environment):
    """Nobody to be reached."""
    if not RECORDING.exists():
        pytest.skip("the shared recordings are not here")
    return Robot(processes, "http://127.0.0.1:1", environment)


def mixed(over, under, share):
    channels = [(over >> shift & 255, under >> shift & 255) for shift in (16, 8, 0)]
    return int.from_bytes(bytes(round(b + (a - b) * share) for a, b in channels), "big")


class Bar:
    """The bar below the views."""

    def __init__(self, window):
        self.window = window
        self.height = window.picture().height
        self.top = self.height - STATUS - BUTTONS - STRIP
        self.left, self.right = wait_for(self._ends, seconds=60, what="the messages in the strip")

    def _ends(self):
        columns, _ = self.window.picture().places(mixed(DARK["accent"], DARK["ground"], 0.55), NAVIGATOR, self.top, None, self.top + STRIP)
        return (int(columns.min()), int(columns.max())) if len(columns) > 300 else None

    def at(self, share):
        return round(self.left + share * (self.right - self.left)), self.top + 28

    def position(self, picture=None):
        """The column of the position's line, where that is seen."""
        columns, _ = (picture or self.window.picture()).places(DARK["text"], NAVIGATOR, self.top + 20, None, self.top + 36)
        return float(numpy.median(columns)) if len(columns) > 10 else None

    def is_at(self, share):
        position = self.position()
        return position is not None and abs(position - self.at(share)[0]) < CLOSE

    def drag(self, start, end):
        self.window.move(self.at(start))
        output("xdotool", "mousedown", "1")
        for step in range(1, 21):
            self.window.move(self.at(start + (end - start) * step / 20))
        output("xdotool", "mouseup", "1")


def scan(window):
    """Which pixels of the map the laser has."""
    picture = window.picture()
    columns, rows = picture.places(DARK["laser"], NAVIGATOR, 80, None, picture.height - 110)
    return set(zip(columns.tolist(), rows.tolist()))


def alike(some, others):
    return len(some & others) / max(1, len(some | others))


def test_views_show_what_was_at_the_time_to_which_the_pointer_is_dragged(nobody):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    window = Window.open(nobody, RECORDING)
    bar = Bar(window)

    window.click(bar.at(0.3))
    wait_for(lambda: (bar.position() or 0) > bar.at(0.3)[0] + CLOSE, what="the recording to play")
    Keys.press("space")                             # the bar has the focus, as it was pressed
    window.click(bar.at(0.3))
    wait_for(lambda: bar.is_at(0.3), what="the position where it was pressed, standing still")
    before = wait_for(lambda: steady_scan(window), what="the scan of that time")

    bar.drag(0.3, 0.7)
    wait_for(lambda: bar.is_at(0.7), what="the position where the pointer was dragged")
    there = wait_for(lambda: steady_scan(window, unlike=before), what="another scan")

    bar.drag(0.7, 0.3)
    wait_for(lambda: alike(scan(window), before) > 0.5, what="the scan of the first time again")
    assert alike(there, before) < 0.5

    Keys.press("ctrl+alt+p")
    wait_for(lambda: (bar.position() or 0) > bar.at(0.3)[0] + CLOSE, what="it to play by a key of the window")


def steady_scan(window, unlike=frozenset()):
    """The pixels of the laser, when two looks see the same."""
    first, second = scan(window), scan(window)
    return first if len(first) > 30 and alike(first, second) > 0.95 and alike(first, unlike) < 0.5 else None


def test_without_a_window_what_cannot_be_opened_is_said_and_the_others_are_played(nobody, tmp_path):
    broken = tmp_path / "broken.bag"
    broken.write_bytes(b"#ROSBAG V2.0\n" + bytes(range(256)) * 8)

    robotui = start_robotui(nobody, "run", "--json", "--for", "6", broken, RECORDING)

    assert robotui.wait(60) == 2
    said = robotui.err.read_text()
    assert f"{broken} cannot be opened: " in said, said
    assert '"ruic":"sena_loop"' in robotui.out.read_text()
