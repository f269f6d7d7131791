"""A user at the window: eyes that look at its picture, hands that press keys and buttons."""
import os
import pathlib
import re
import shutil
import subprocess

import numpy

from conftest import Robot, busy, start_robotui, wait_for

TOOLS = ("xdotool", "import", "convert")
DARK = {"ground": 0x1b1f24, "panel": 0x22272e, "text": 0xd7dde4, "accent": 0x4da3ff, "good": 0x3fb68b, "bad": 0xe5534b,
        "warning": 0xe0a93b, "laser": 0xff8a65, "robot": 0x448bd8}
LIGHT = {"ground": 0xf2f4f7, "panel": 0xffffff, "text": 0x1f2730, "accent": 0x0b63c4, "good": 0x0a7350, "bad": 0xc4302b,
         "laser": 0xd1491c}
TOP_BAR = 44
NAVIGATOR = 200
LEASE, RECORD = 190, 145                            # with what is between them


def missing():
    """What this machine lacks for tests in a window, empty for nothing."""
    absent = [tool for tool in TOOLS if shutil.which(tool) is None]
    if not os.environ.get("DISPLAY"):
        absent.insert(0, "a display (DISPLAY is not set)")
    return ", ".join(absent)


def output(*arguments):
    result = subprocess.run(arguments, stdin=subprocess.DEVNULL, capture_output=True, timeout=60, check=False)
    assert result.returncode == 0, f"{arguments}: {result.stderr.decode()}"
    return result.stdout


def pause(seconds):
    """Words for xdotool, which then waits so long; longer on a busy machine."""
    return "sleep", f"{seconds * min(busy(), 5):.2f}"


class Picture:
    """Pixels by row and column."""

    def __init__(self, ppm):
        header = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", ppm)
        self.width, self.height = (int(figure) for figure in header.groups())
        self.pixels = numpy.frombuffer(ppm, numpy.uint8, offset=header.end()).reshape(self.height, self.width, 3)

    @staticmethod
    def of(file):
        return Picture(output("convert", str(file), "-depth", "8", "ppm:-"))

    def places(self, colour, left=0, top=0, right=None, bottom=None):
        """Columns and rows of all pixels of a colour in a rectangle."""
        wanted = numpy.array([colour >> 16 & 255, colour >> 8 & 255, colour & 255])
        part = self.pixels[top:bottom, left:right].astype(int)
        rows, columns = numpy.nonzero(numpy.abs(part - wanted).max(axis=2) <= 2)
        return columns + left, rows + top

    def count(self, colour, *rectangle):
        return len(self.places(colour, *rectangle)[0])

    def middle(self, colour, *rectangle):
        """The middle of what has a colour: the median, which a few pixels elsewhere do not move."""
        columns, rows = self.places(colour, *rectangle)
        return (int(numpy.median(columns)), int(numpy.median(rows))) if len(columns) else None

    def colours(self):
        return len(numpy.unique(self.pixels.reshape(-1, 3), axis=0))


class Window:
    """The window of a ./robotui. Places in it are pixels from its upper left corner."""

    def __init__(self, process):
        self.process = process
        self._stick = None
        self.id = wait_for(self._find, seconds=120, what="the window")

    @staticmethod
    def open(robot, *arguments, name="window"):
        """Starts one that remembers no earlier run: after a busy one it would ask what to leave out."""
        own = Robot(robot.processes, robot.uri, robot.environment | {"XDG_STATE_HOME": str(robot.processes.folder / f"{name}-state")})
        return Window(start_robotui(own, "run", *arguments, name=name, display=True))

    def _find(self):
        """Also says early why there will be none."""
        assert self.process.poll() is None, self.process.err.read_text()
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "(^| - )RobotUI *$"], capture_output=True, text=True,
                               timeout=60, check=False).stdout.split()
        return next((window for window in found if self._is_ours(window)), None)

    def _is_ours(self, window):
        owner = subprocess.run(["xdotool", "getwindowpid", window], capture_output=True, text=True, timeout=60, check=False).stdout
        try:
            return os.getsid(int(owner)) == self.process.pid
        except (ValueError, ProcessLookupError):
            return False

    def picture(self):
        return Picture(output("import", "-silent", "-window", self.id, "-depth", "8", "ppm:-"))

    def move(self, place):
        output("xdotool", "mousemove", "--window", self.id, *map(str, place))

    def click(self, place):
        self.move(place)
        output("xdotool", "click", "1")

    def close(self):
        """By the window manager's key."""
        output("xdotool", "windowactivate", "--sync", self.id, "key", "alt+F4")

    # ---- what it shows, in the dark theme ---------------------------------------------------------------------------

    def is_live(self):
        """Whether the first robot's dot in the navigator is full and green."""
        return self._dot("good") > 40

    def _dot(self, role):
        return self.picture().count(DARK[role], 12, 80, 28, 112)

    def is_yours(self):
        """Whether the dot of the lease, left of the stop, is full and green: the robot is driven from this window."""
        picture = self.picture()
        stop = self._left_of_stop(picture)
        return picture.count(DARK["good"], stop - LEASE - 20, 0, stop, TOP_BAR) > 40

    def stop_button(self):
        picture = self.picture()
        return picture.middle(DARK["bad"], picture.width // 2, 0, picture.width, TOP_BAR)

    def release_button(self):
        """Where it is, while a stop is latched: what is between search and record."""
        picture = self.picture()
        right = self._left_of_stop(picture) - LEASE - RECORD - 20
        bar = picture.pixels[4:TOP_BAR - 4, right - 90:right].astype(int)
        rows, columns = numpy.nonzero(numpy.abs(bar - bar[0, 0]).max(axis=2) > 60)
        return (int(numpy.median(columns)) + right - 90, int(numpy.median(rows)) + 4) if len(columns) > 50 else None

    @staticmethod
    def _left_of_stop(picture):
        """The button's face, not words of the same colour."""
        columns, _ = picture.places(DARK["bad"], picture.width // 2, 0, picture.width, TOP_BAR)
        return int(numpy.nonzero(numpy.bincount(columns) > TOP_BAR // 2)[0].min())

    def stick(self):
        """The middle of the teleop view's disc, the largest dark thing of the right column; where it was, once it is seen."""
        self._stick = self._stick or self._seen_stick()
        return self._stick

    def _seen_stick(self):
        picture = self.picture()
        rectangle = (int(picture.width * 0.7), 2 * TOP_BAR, picture.width, picture.height - 40)
        return picture.middle(DARK["ground"], *rectangle) if picture.count(DARK["ground"], *rectangle) > 10_000 else None

    def robot(self):
        """Where the map draws the robot: the accent, mixed with the ground."""
        picture = self.picture()
        return picture.middle(DARK["robot"], NAVIGATOR + 20, 3 * TOP_BAR, int(picture.width * 0.68), picture.height - 60)


class Keys:
    """Holds keys and the mouse button down, and lets go of them at the end of the test."""

    def __init__(self):
        self.down = []

    def hold(self, key):
        self.down.append(("keyup", key))
        output("xdotool", "keydown", key)

    def grip(self):
        self.down.append(("mouseup", "1"))
        output("xdotool", "mousedown", "1")

    def let_go(self):
        while self.down:
            output("xdotool", *self.down.pop())

    @staticmethod
    def press(key):
        output("xdotool", "key", key)


def java_of(process, word):
    """The process id of the Java that a ./robotui has started, known by a word of its command line."""
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if os.getsid(int(entry.name)) == process.pid and word in (entry / "cmdline").read_text():
                return int(entry.name)
        except (OSError, ValueError):
            continue
    return None


class Motion:
    """Follows the odometry with rostopic: time of the robot's clock, place and speeds of every message."""

    def __init__(self, robot, name="odometry"):
        self.process = robot.start_tool("rostopic", "echo", "-p", "/odom", name=name)
        wait_for(lambda: self.count() > 2, what="odometry")

    def rows(self, last=None):
        lines = self.process.out.read_text().splitlines(keepends=True)
        names = lines[0].strip().split(",")
        wanted = [names.index(name) for name in ("%time", "field.pose.pose.position.x", "field.pose.pose.position.y",
                                                 "field.twist.twist.linear.x", "field.twist.twist.angular.z")]
        whole = [line.split(",") for line in lines[1:] if line.endswith("\n")]
        return [[float(line[i]) for i in wanted] for line in (whole[-last:] if last else whole)]

    def count(self):
        return max(0, self.process.out.read_text().count("\n") - 1)

    def speed(self):
        return self.rows(1)[0][3]

    def place(self):
        return self.rows(1)[0][1:3]

    def drives(self):
        _, _, _, linear, angular = self.rows(1)[0]
        return abs(linear) > 0.1 or abs(angular) > 0.1

    def stands(self, messages=10):
        """Whether it has not moved for some messages."""
        rows = self.rows(messages)
        return len(rows) == messages and all(abs(linear) < 0.02 and abs(angular) < 0.02 for _, _, _, linear, angular in rows)

    def seconds_until_it_stood(self, since):
        """How long after a moment of the wall clock the last motion was."""
        wait_for(self.stands, seconds=60, what="standstill")
        moving = [stamp for stamp, _, _, linear, angular in self.rows() if abs(linear) >= 0.02 or abs(angular) >= 0.02]
        return moving[-1] * 1e-9 - since

    def stands_for(self, messages):
        """Sees that it stands, for as many messages from now on."""
        before = self.count()
        wait_for(lambda: self.count() >= before + messages, what="more odometry")
        return self.stands(messages)
