"""The bar of recordings in a window, for tests and pictures."""
import numpy

from conftest import SHARED, wait_for
from desktop import DARK, NAVIGATOR, output

RECORDING = SHARED / "data/bags/sena_loop.bag"      # a car goes round a block for 59 s, with a laser scanner
STATUS, BUTTONS, STRIP = 24, 28, 48                 # heights, from the bottom of the window
CLOSE = 2.5                                         # points, on the strip


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

    def expand(self):
        """Shows the recordings with their topics: their names take the left part of the strip."""
        before = self.left
        self.window.click((self.left + 6, self.height - STATUS - BUTTONS // 2))
        wait_for(lambda: (self._ends() or (0,))[0] > before + 100, what="the topics")
        self.left, self.right = self._ends()

    def is_at(self, share):
        position = self.position()
        return position is not None and abs(position - self.at(share)[0]) < CLOSE

    def drag(self, start, end):
        self.window.move(self.at(start))
        output("xdotool", "mousedown", "1")
        for step in range(1, 21):
            self.window.move(self.at(start + (end - start) * step / 20))
        output("xdotool", "mouseup", "1")
