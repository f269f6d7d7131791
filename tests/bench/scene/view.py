"""The 3D view of a program, looked at from outside: how large it is, whether all is seen, its pictures a second, how soon it answers the mouse."""
import collections
import contextlib
import os
import signal
import time

import numpy
from Xlib.ext import damage

import windows
from building import CannotMeasure
from processes import family, pss_megabytes
from windows import Area

SIZE = (1000, 700)                                                  # pixels of the view
INEXACT, SIZINGS = 2, 8                                             # pixels, attempts: a busy window manager is late
STRIP = 8                                                           # rows that are compared
LEAST_PICTURES, PATIENCE = 4, 15                                    # where they are slow
START_PATIENCE = 120
DRAG, ENOUGH, LEAST_DRAWN = 8, 16, 3                                # seconds, rectangles, how often one is the same
STILL = 1.5                                                         # seconds in which nothing more comes
PATCH = 20                                                          # pixels that tell how the camera stands
CLEAR = 150                                                         # of three times 255, between its colours
HALTS = 50                                                          # attempts
JUMP = 60                                                           # pixels of the mouse


class View:
    """The view of one program that runs. It is halted while another one is measured."""

    def __init__(self, screen, program, title, left):
        self.screen = screen
        self.program = program
        self.window = self._opened(title)
        self.window.configure(x=left, y=30)
        self.area = self._sized()

    def _opened(self, title):
        end = time.monotonic() + START_PATIENCE
        while time.monotonic() < end and self.program.process.poll() is None:
            window = self.screen.window(title, family(self.program.process.pid))
            if window:
                time.sleep(1)                                       # until it is laid out
                return window
            time.sleep(0.1)
        raise CannotMeasure(f"{self.program.name} did not open its window\n{self.program.log.read_text()[-2000:]}")

    def _sized(self):
        """Makes the window so large that the view has its size."""
        for _ in range(SIZINGS):
            area = self._found()
            wrong = SIZE[0] - area.width, SIZE[1] - area.height
            if max(map(abs, wrong)) <= INEXACT:
                return area
            place = self.screen.place(self.window)
            self.window.configure(width=place.width + wrong[0], height=place.height + wrong[1])
            self.screen.display.sync()
            time.sleep(1)
        raise CannotMeasure(f"the view of {self.program.name} cannot be made {SIZE[0]} x {SIZE[1]} pixels large, but {area}")

    def _found(self):
        """
        The smallest of the large rectangles that are drawn again and again while the middle of the window is dragged: where the heading above the
        view changes at the same time, both are drawn as one rectangle.
        """
        end = time.monotonic() + START_PATIENCE
        while time.monotonic() < end:
            counts = collections.Counter(self._drawn())             # a new drag each time: one that began too early moves nothing
            again = [area for area, count in counts.items() if count >= LEAST_DRAWN]
            if again:
                return min(again, key=lambda area: area.size)
        raise CannotMeasure(f"{self.program.name} shows no view that can be turned\n{self.program.log.read_text()[-2000:]}")

    def _drawn(self):
        """Large rectangles that are drawn in a few seconds of dragging, until there are some."""
        place = self.screen.place(self.window)
        found = []
        end = time.monotonic() + DRAG
        with self.screen.drawn(damage.DamageReportRawRectangles) as drawn, windows.turning(self.screen.name, place):
            while time.monotonic() < end and len(found) < ENOUGH:
                found += [each for each in drawn(0.1) if each.within(place) and each.size > place.size / 2]
        return found

    def picture(self):
        return self.screen.pixels(self.area)[:, :, :3].astype(int)

    def covered(self, picture=None):
        """The share of pixels that are not the background."""
        picture = self.picture() if picture is None else picture
        return float((numpy.abs(picture - picture[STRIP, self.area.width // 2]).sum(axis=2) > 24).mean())

    def wait_until_complete(self, rim):
        """Until something is seen and no more comes; with a RIM, until the white end of the cloud is there, too."""
        end = time.monotonic() + START_PATIENCE
        last, since = -1.0, time.monotonic()
        while time.monotonic() < end:
            picture = self.picture()
            share = self.covered(picture)
            if abs(share - last) > 0.002 or share < 0.01 or rim and white(picture) < 0.01:
                last, since = share, time.monotonic()
            if time.monotonic() - since > STILL:
                return share
            time.sleep(0.1)
        raise CannotMeasure(f"{self.program.name} did not show all: {share * 100:.1f} % of its view is covered")

    def frames_per_second(self, seconds):
        """
        Pictures that differ from the one before in a few rows in the middle, while the view is turned. One that shows fewer than two for long is
        taken to show one in that time, which is more than it does.
        """
        strip = Area(self.area.x, self.area.middle[1], self.area.width, STRIP)      # few, as they arrive at once
        times, last = [], None
        with self.screen.drawn() as drawn, windows.turning(self.screen.name, self.area):
            begun = time.monotonic() + 0.5
            while (now := time.monotonic()) < begun + seconds or len(times) < LEAST_PICTURES and now < begun + PATIENCE:
                drawn(0.2)
                pixels = self.screen.pixels(strip)
                if last is not None and not numpy.array_equal(pixels, last) and now > begun:
                    times.append(time.monotonic())
                last = pixels
        if self.program.process.poll() is not None:
            raise CannotMeasure(f"{self.program.name} has ended\n{self.program.log.read_text()[-2000:]}")
        return (len(times) - 1) / (times[-1] - times[0]) if len(times) > 1 else 1 / (time.monotonic() - begun)

    def latencies(self, moves, pause):
        """Seconds from a jump of the mouse, PAUSE seconds after the answer to the one before, to pixels that show the other side."""
        with self._held() as places:
            patch, sides = self._sides(places)
            found = []
            for number in range(moves):
                found.append(self._answer(places[(number + 1) % 2], patch, sides[number % 2], sides[(number + 1) % 2]))
                time.sleep(pause)
        return found

    @contextlib.contextmanager
    def _held(self):
        x, y = self.area.middle
        self.screen.move(x, y)
        self.screen.button(True)
        for step in range(1, 5):                                    # first moves only begin a drag
            self.screen.move(x + 3 * step, y)
        try:
            yield ((x, y), (x + JUMP, y))
        finally:
            self.screen.button(False)

    def _sides(self, places):
        """Where the view differs most between two places of the mouse, and its mean colour there for each."""
        end = time.monotonic() + START_PATIENCE
        apart = numpy.zeros((1, 1))
        while apart.max() < CLEAR:                                  # a view that answers late looks as if it had come to rest
            if time.monotonic() > end:
                raise CannotMeasure(f"the view of {self.program.name} does not follow the mouse")
            means = []
            for place in reversed(places):                          # and so the mouse is where the first jump begins
                self.screen.move(*place)
                means.insert(0, patches(self._rested()))
            apart = numpy.abs(means[0] - means[1]).sum(axis=2)
        row, column = numpy.unravel_index(apart.argmax(), apart.shape)
        patch = Area(self.area.x + int(column) * PATCH, self.area.y + int(row) * PATCH, PATCH, PATCH)
        return patch, [mean[row, column] for mean in means]

    def _rested(self):
        """The picture once it stays the same."""
        end = time.monotonic() + PATIENCE
        last, since = self.picture(), time.monotonic()
        while time.monotonic() < min(end, since + STILL):
            time.sleep(0.1)
            picture = self.picture()
            if not numpy.array_equal(picture, last):
                last, since = picture, time.monotonic()
        return last

    def _answer(self, place, patch, before, after):
        with self.screen.drawn() as drawn:
            begun = time.monotonic()
            self.screen.move(*place)
            while time.monotonic() < begun + PATIENCE:
                drawn(0.2)
                now = time.monotonic()
                mean = self.screen.pixels(patch)[:, :, :3].mean(axis=(0, 1))
                if numpy.abs(mean - after).sum() < numpy.abs(mean - before).sum():
                    return now - begun
        raise CannotMeasure(f"{self.program.name} did not answer the mouse within {PATIENCE} s")

    def megabytes(self):
        return pss_megabytes(self.program.process.pid)

    @contextlib.contextmanager
    def awake(self):
        self.send(signal.SIGCONT)
        try:
            yield self
        finally:
            self.halt()

    def halt(self):
        """Where it has the display to itself for a moment (XGrabServer), it would halt all that is drawn: then a moment later."""
        for _ in range(HALTS):
            self.send(signal.SIGSTOP)
            with self.screen.asked(0.5) as answers:
                if answers:
                    return
                self.send(signal.SIGCONT)
            time.sleep(0.02)
        raise CannotMeasure(f"{self.program.name} cannot be halted: it keeps the display to itself")

    def send(self, sign):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.program.process.pid, sign)


def white(picture):
    """The share of bright pixels without a colour; ours are shaded by depth."""
    return float(((picture.min(axis=2) > 90) & (picture.max(axis=2) - picture.min(axis=2) < 12)).mean())


def patches(picture):
    """The mean colour of each patch of a picture."""
    tall, wide = (size // PATCH for size in picture.shape[:2])
    return picture[:tall * PATCH, :wide * PATCH].reshape(tall, PATCH, wide, PATCH, 3).mean(axis=(1, 3))
