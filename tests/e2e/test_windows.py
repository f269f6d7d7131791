"""Windows that a configuration asks for."""
import os
import subprocess

import pytest

from conftest import Robot, free_port, wait_for
from desktop import DARK, TOP_BAR, Keys, Window, missing, output, pause

RUICS = "ruics:\n" + "".join(f"  {name}:\n    type: mobilebase\n    rfics:\n      base: {{type: ros}}\n" for name in ("Natalie", "Keira", "Marvin"))


@pytest.fixture
def nowhere(processes, environment):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    return Robot(processes, f"http://127.0.0.1:{free_port()}", environment)


class Windows:
    """All windows of one ./robotui."""

    def __init__(self, robot, folder, text, name="windows"):
        file = folder / f"{name}.yaml"
        file.write_text(text)
        self.first = Window.open(robot, file, name=name)
        self.process = self.first.process

    def ids(self):
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "(^| - )RobotUI *$"], capture_output=True, text=True,
                               timeout=60, check=False).stdout.split()
        return [window for window in found if self.first._is_ours(window)]

    def await_count(self, count):
        wait_for(lambda: len(self.ids()) == count, seconds=90, what=f"{count} windows")
        return self.ids()

    def selected(self):
        """Which row of the robots each window marks, from 0; none for a window without a robot."""
        return [row_of(picture_of(self.first, window)) for window in self.ids()]

    def close_one(self):
        left = self.ids()
        output("xdotool", "windowactivate", "--sync", left[-1], *pause(0.5), "key", "alt+F4")
        self.await_count(len(left) - 1)

    def close_all(self):
        while self.ids():
            self.close_one()
        assert self.process.wait(90) == 0


def picture_of(any_window, window):
    """In front of all others, which would cover it."""
    output("xdotool", "windowactivate", "--sync", window, *pause(0.4))
    other = object.__new__(Window)
    other.process, other.id, other._stick = any_window.process, window, None
    return other.picture()


def row_of(picture):
    mark = picture.middle(DARK["accent"], 0, TOP_BAR, 3, picture.height // 2)
    return (mark[1] - 80) // 48 if mark else None


def bounds(window):
    words = dict(line.split("=") for line in output("xdotool", "getwindowgeometry", "--shell", window).decode().split() if "=" in line)
    return tuple(int(words[word]) for word in ("X", "Y", "WIDTH", "HEIGHT"))


def new_window(window):
    """By the first entry of the menu Window."""
    output("xdotool", "windowactivate", "--sync", window, "mousemove", "--window", window, "362", "20", "click", "1")
    output("xdotool", *pause(1), "key", "Down", *pause(0.3), "key", "Return")


def test_each_window_begins_with_its_robot_and_a_new_one_with_what_is_left(nowhere, tmp_path):
    windows = Windows(nowhere, tmp_path, "windows: [Natalie, Marvin]\n" + RUICS)
    windows.await_count(2)
    wait_for(lambda: sorted(map(str, windows.selected())) == ["0", "2"], what="the robots of both windows")

    new_window(windows.ids()[0])
    windows.await_count(3)
    wait_for(lambda: sorted(map(str, windows.selected())) == ["0", "1", "2"], what="the robot that no window showed")

    for _ in range(2):
        windows.close_one()
        assert windows.process.poll() is None, "closing one of several ends nothing"


def test_a_window_opens_where_the_user_left_it(nowhere, tmp_path):
    text = "windows: [Natalie, Keira]\n" + RUICS
    windows = Windows(nowhere, tmp_path, text)
    windows.await_count(2)
    wait_for(lambda: sorted(map(str, windows.selected())) == ["0", "1"], what="the robots of both windows")
    keira = windows.ids()[windows.selected().index(1)]
    output("xdotool", *pause(3), "windowsize", "--sync", keira, "1000", "700")
    output("xdotool", "windowmove", "--sync", keira, "300", "120", *pause(1))
    left = sorted(map(bounds, windows.ids()))
    windows.close_all()

    for start in ("second", "third"):
        again = Windows(nowhere, tmp_path, text)
        again.await_count(2)
        wait_for(lambda again=again: all(map(close, sorted(map(bounds, again.ids())), left)), what=f"windows at {left} in the {start} run")
        output("xdotool", *pause(3))
        again.close_all()


def close(one, other):
    """But for roundings; the frame of a window manager is wider."""
    return all(abs(a - b) <= 2 for a, b in zip(one, other, strict=True))


def test_a_wrong_name_is_said_with_its_place_and_the_nearest(environment, tmp_path):
    file = tmp_path / "wrong.yaml"
    file.write_text("windows: [Natlie, Keira]\n" + RUICS)
    result = subprocess.run([os.path.join(os.path.dirname(__file__), "../../robotui"), "check", file], env=environment, capture_output=True, text=True,
                            timeout=120, check=False)
    assert result.returncode == 1
    assert "wrong.yaml:1:11: error: there is no RUIC 'Natlie' for a window; did you mean 'Natalie'?" in result.stdout
