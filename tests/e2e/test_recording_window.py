"""Recordings that are named in place of a configuration: views that fit, and a bar by which they are moved in time."""
import time

import pytest

from conftest import Robot, start_robotui, wait_for
from desktop import DARK, NAVIGATOR, Keys, Window, missing
from playback import CLOSE, RECORDING, Bar


@pytest.fixture
def nobody(processes, environment):
    """Nobody to be reached."""
    if not RECORDING.exists():
        pytest.skip("the shared recordings are not here")
    return Robot(processes, "http://127.0.0.1:1", environment)


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
    wait_for(lambda: len(scan(window)) > 30, what="a scan on the map")

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
    wait_for(lambda: bar.is_at(0.3), what="the position where the pointer was dragged back")
    wait_for(lambda: alike(scan(window), before) > 0.5, what="the scan of the first time again")
    assert alike(there, before) < 0.5

    Keys.press("ctrl+alt+p")
    wait_for(lambda: (bar.position() or 0) > bar.at(0.3)[0] + CLOSE, what="it to play by a key of the window")


def steady_scan(window, unlike=frozenset()):
    """The pixels of the laser, when two looks see the same: the map fits in what it knows, and begins anew where more comes."""
    first = scan(window)
    time.sleep(1)
    second = scan(window)
    return first if len(first) > 30 and alike(first, second) > 0.95 and alike(first, unlike) < 0.5 else None


def test_without_a_window_what_cannot_be_opened_is_said_and_the_others_are_played(nobody, tmp_path):
    broken = tmp_path / "broken.bag"
    broken.write_bytes(b"#ROSBAG V2.0\n" + bytes(range(256)) * 8)

    robotui = start_robotui(nobody, "run", "--json", "--for", "6", broken, RECORDING)

    assert robotui.wait(60) == 2
    said = robotui.err.read_text()
    assert f"{broken} cannot be opened: " in said, said
    assert '"ruic":"sena_loop"' in robotui.out.read_text()
