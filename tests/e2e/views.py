"""The views of a window: their tabs, where they are, and what stands in them."""
import time

import numpy

from conftest import busy, wait_for
from desktop import DARK, NAVIGATOR, TOP_BAR, Keys, output

TITLE = 0x262c34
TITLE_HEIGHT = 30
# Stacks of tabs by column of the window, from top to bottom.
MOBILE_BASE = ({"main": ("map", "scene3d", "tftree", "graph", "topics", "parameters", "services", "actions"),
                "records": ("plot", "log", "diagnostics", "joints", "gps", "alerts")},
               {"camera": ("camera",), "teleop": ("teleop",), "state": ("status", "connections")})
MANIPULATOR = ({"joints": ("jointcontrol", "postures", "tftree"), "records": ("scene3d", "plot", "log", "alerts")},
               {"plugins": ("plugins",), "state": ("status", "connections")})
STACKS = {name: views for column in MOBILE_BASE for name, views in column.items()}


def runs(flags, least):
    """First and last index of all runs of true values of at least some length."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], flags.astype(int), [0]))))
    return [(int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2]) if b - a >= least]


def like(pixels, colour, slack=2):
    wanted = numpy.array([colour >> 16 & 255, colour >> 8 & 255, colour & 255])
    return numpy.abs(pixels.astype(int) - wanted).max(axis=-1) <= slack


class Words:
    """What is written in one line of a picture, as places: letters nearer than a gap are one word."""

    def __init__(self, picture, rectangle, gap):
        left, top, right, bottom = rectangle
        part = picture.pixels[top:bottom, left:right].astype(int)
        ink = numpy.flatnonzero((numpy.abs(part - part[0, 0]).max(axis=2) > 60).any(axis=0)) + left
        self.spans = []
        for column in ink:
            if self.spans and column - self.spans[-1][1] < gap:
                self.spans[-1][1] = int(column)
            else:
                self.spans.append([int(column), int(column)])
        self.row = (top + bottom) // 2

    def places(self):
        return [((first + last) // 2, self.row) for first, last in self.spans]


class Views:
    """Hands and eyes on the views, in the dark theme; the pixels of a picture are those of the screen."""

    def __init__(self, window, columns=MOBILE_BASE, scale=1, title=TITLE):
        self.window = window
        self.columns = columns
        self.stacks = {name: views for column in columns for name, views in column.items()}
        self.scale = scale
        self.title = title
        self.lines = wait_for(self._find, seconds=90, what="the titles of all views")

    def _find(self):
        """The title lines, as rectangles: below each other in the two columns of the layout."""
        picture = self.window.picture()
        size = self.scale * TITLE_HEIGHT
        row = like(picture.pixels[self.scale * (TOP_BAR + 6)], self.title)
        columns = [run for run in runs(row, 100 * self.scale) if run[1] > self.scale * (NAVIGATOR + 100)]
        if len(columns) != len(self.columns):
            return None
        # A switched button may end a line's colour before the line ends.
        rights = [left - 4 for left, _ in columns[1:]] + [picture.width - 2]
        found = [[(left, top, max(right, edge), bottom) for top, bottom in runs(like(picture.pixels[:, left + 4], self.title), size - 4)]
                 for (left, right), edge in zip(columns, rights)]
        if [len(lines) for lines in found] != [len(column) for column in self.columns]:
            return None
        lines = dict(zip(self.stacks, sum(found, [])))
        first = next(iter(self.stacks))
        return lines if len(self._titles(picture, lines[first], first)) >= len(self.stacks[first]) else None

    def _titles(self, picture, line, stack):
        left, top, right, bottom = line
        words = Words(picture, (left, top + 3, right, bottom - 3), 9 * self.scale)
        return words.spans[:len(self.stacks[stack])]

    def stack(self, view):
        return next(name for name, views in self.stacks.items() if view in views)

    def open(self, view):
        """Clicks on a title and waits for its mark; answers the rectangle of the view."""
        self.lines = self._find() or self.lines                     # the window still settles in its first seconds
        stack = self.stack(view)
        left, top, right, bottom = line = self.lines[stack]
        first, last = self._titles(self.window.picture(), line, stack)[self.stacks[stack].index(view)]
        self.window.click(((first + last) // 2, (top + bottom) // 2))
        wait_for(lambda: self.window.picture().count(DARK["accent"], first, bottom - 4, last, bottom + 2) > (last - first) // 2,
                 what=f"the mark of {view}")
        return self.body(stack)

    def body(self, stack):
        """The rectangle below a title line, down to the next or to the line of the workbench's state."""
        left, _, right, bottom = self.lines[stack]
        below = [line[1] for line in self.lines.values() if line[0] == left and line[1] > bottom]
        end = min(below) - 4 if below else self.window.picture().height - 30 * self.scale
        return left, bottom + 2, right, end

    def part(self, rectangle):
        left, top, right, bottom = rectangle
        return self.window.picture().pixels[top:bottom, left:right]

    # ---- hands ------------------------------------------------------------------------------------------------------

    def filter(self, body, words, left=False):
        """Types into the field in the bar of a view, and goes to the first line that is left."""
        edge, top, right, bottom = body
        self.window.click((edge + 60 if left else right - 90, top + 18))
        Keys.press("ctrl+a")
        type_words(words)
        self.still((edge, top + 40, edge + (right - edge) // 3, bottom))
        Keys.press("Down")
        Keys.press("Down")

    def still(self, rectangle, seconds=0.6):
        """Waits until a part of the picture has not changed for a while, which is longer on a busy machine."""
        seconds *= min(busy(), 5)
        seen = [self.part(rectangle), time.monotonic()]

        def rests():
            now = self.part(rectangle)
            if not numpy.array_equal(seen[0], now):
                seen[:] = [now, time.monotonic()]
            return time.monotonic() - seen[1] > seconds

        wait_for(rests, what="a still picture")

    def button(self, rectangle):
        """The middle of the filled button, once it can be pressed."""
        left, top, right, bottom = rectangle

        def seen():
            picture = self.window.picture()
            return picture.middle(DARK["accent"], *rectangle) if picture.count(DARK["accent"], left, top, right, bottom) > 800 else None

        return wait_for(seen, what="a button that can be pressed")

    def fields(self, rectangle):
        """The fields for text, from top to bottom: what has the ground's colour up to one right edge."""
        left, top, right, bottom = rectangle
        ground = like(self.window.picture().pixels[top:bottom, left:right], DARK["ground"])
        found = []
        for row, flags in enumerate(ground):
            for first, last in runs(flags, 24):
                mine = next((each for each in found if each[3] >= row + top - 1 and abs(each[2] - last - left) <= 1), None)
                if mine:
                    mine[0], mine[3] = min(mine[0], first + left), row + top
                else:
                    found.append([first + left, row + top, last + left, row + top])
        return [each for each in found if each[3] - each[1] >= 12]

    def fill(self, field, words):
        self.window.click(((field[0] + field[2]) // 2, (field[1] + field[3]) // 2))
        Keys.press("ctrl+a")
        type_words(words)

    # ---- eyes -------------------------------------------------------------------------------------------------------

    def lives(self, rectangle, seconds=60):
        """Waits until a part of the picture changes."""
        before = self.part(rectangle)
        wait_for(lambda: not numpy.array_equal(before, self.part(rectangle)), seconds=seconds, what="something new in the view")

    def rows(self, rectangle):
        """The lines of text, as first and last row of pixels from the upper edge."""
        bright = self.part(rectangle).max(axis=2) > 0x78
        return runs(bright.any(axis=1), 5)


def type_words(words):
    output("xdotool", "type", "--delay", "25", "--", words)
