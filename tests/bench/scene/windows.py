"""The display as a user has it: windows, pixels, and a mouse. What is drawn anywhere is told by XDamage."""
import contextlib
import select
import threading
import time
from dataclasses import dataclass

import numpy
from Xlib import X, display, error
from Xlib.ext import damage, xtest
from Xlib.protocol import request

MOVES_PER_SECOND, PIXELS_PER_MOVE, SWEEP = 100, 3, 240


@dataclass(frozen=True)
class Area:
    x: int
    y: int
    width: int
    height: int

    @property
    def middle(self):
        return self.x + self.width // 2, self.y + self.height // 2

    @property
    def size(self):
        return self.width * self.height

    def within(self, other):
        """Whether it is a part of the other, and not all of it."""
        return (self != other and other.x <= self.x and self.x + self.width <= other.x + other.width
                and other.y <= self.y and self.y + self.height <= other.y + other.height)


class Screen:
    """A connection to the display. One thread."""

    def __init__(self, name):
        self.name = name
        self.display = display.Display(name)
        self.root = self.display.screen().root
        self.display.damage_query_version()

    def close(self):
        self.display.close()

    def pixels(self, area):
        """Rows of pixels, each blue, green, red and a byte of no meaning."""
        image = self.root.get_image(area.x, area.y, area.width, area.height, X.ZPixmap, 0xFFFFFFFF)
        return numpy.frombuffer(image.data, numpy.uint8).reshape(area.height, area.width, 4)

    def window(self, title, pids):
        """The window with a title, as the window manager has it, of one of these processes; or None."""
        clients = self.root.get_full_property(self.display.intern_atom("_NET_CLIENT_LIST"), X.AnyPropertyType)
        for each in clients.value if clients else ():
            with contextlib.suppress(error.XError):                 # it may be gone by now
                window = self.display.create_resource_object("window", each)
                name = window.get_full_text_property(self.display.intern_atom("_NET_WM_NAME")) or ""
                owner = window.get_full_property(self.display.intern_atom("_NET_WM_PID"), X.AnyPropertyType)
                if title in name and owner and owner.value[0] in pids:
                    return window
        return None

    def place(self, window):
        """Where a window is on the screen."""
        size, origin = window.get_geometry(), window.translate_coords(self.root, 0, 0)
        return Area(-origin.x, -origin.y, size.width, size.height)

    @contextlib.contextmanager
    def drawn(self, level=damage.DamageReportNonEmpty):
        """A function that waits for what is drawn, at most so many seconds, and says which rectangles."""
        watched = self.root.damage_create(level)
        self.display.sync()

        def rectangles(seconds):
            if not self.display.pending_events():
                select.select([self.display.fileno()], [], [], max(0, seconds))
            events = [self.display.next_event() for _ in range(self.display.pending_events())]
            if events:
                self.display.damage_subtract(watched)
            return [Area(e.area.x, e.area.y, e.area.width, e.area.height) for e in events if hasattr(e, "area")]

        try:
            yield rectangles
        finally:
            self.display.damage_destroy(watched)
            self.display.sync()
            for _ in range(self.display.pending_events()):
                self.display.next_event()

    @contextlib.contextmanager
    def asked(self, seconds):
        """Whether the display answers within so long. It has answered when this ends."""
        question = request.GetInputFocus(display=self.display.display, defer=True)
        self.display.flush()
        try:
            yield bool(select.select([self.display.fileno()], [], [], seconds)[0])
        finally:
            question.reply()

    def button(self, down):
        xtest.fake_input(self.display, X.ButtonPress if down else X.ButtonRelease, 1)
        self.display.sync()

    def move(self, x, y):
        xtest.fake_input(self.display, X.MotionNotify, x=x, y=y)
        self.display.sync()


@contextlib.contextmanager
def turning(name, area):
    """Drags to and fro over the middle, a hundred moves a second, so that the camera never stands."""
    ended = threading.Event()
    hand = Screen(name)

    def drag():
        x, y = area.middle
        hand.move(x, y)
        hand.button(True)
        begun = time.monotonic()
        step = 0
        while not ended.wait(max(0, begun + step / MOVES_PER_SECOND - time.monotonic())):
            step += 1
            along = step * PIXELS_PER_MOVE % (2 * SWEEP)
            hand.move(x + min(along, 2 * SWEEP - along) - SWEEP // 2, y)
        hand.button(False)
        hand.close()

    thread = threading.Thread(target=drag)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()
