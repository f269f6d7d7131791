"""One scene in both programs: shown, compared, and measured in turns. Who is not measured is halted."""
import contextlib
import signal
import time
import xmlrpc.client

import robotui_scene
import rviz_scene
import scenes
from building import CannotMeasure
from priority import prefer
from processes import Programs
from view import View
from windows import Screen

WARM_SECONDS = 5                                                    # of the virtual machine, which compiles then
LEFT, RIGHT = 0, 1300                                               # pixels: no window covers another
ALIKE_PATIENCE = 60                                                 # seconds, of slow machines that still load
ALIKE = 0.6, 1.6                                                     # what one covers of its view, in terms of the other
OURS, RVIZ, THINNED = "robotui", "rviz", "thinned"
DRAGGED, RESTED = 0.15, 1.0                                         # seconds between moves: the camera still counts as moving; it does not
MOVES = {DRAGGED: 12, RESTED: 5}


class Stage(contextlib.ExitStack):
    """Both programs with a scene, from `with` on."""

    def __init__(self, bench, scene):
        super().__init__()
        self.bench = bench
        self.scene = scene
        self.views = {}

    def __enter__(self):
        with contextlib.ExitStack() as opened:                      # ends what was started, should something fail
            opened.push(self)
            self._open()
            opened.pop_all()
        return self

    def _open(self):
        self.programs = self.enter_context(Programs(self.bench.folder))
        self.programs.environment.update(self.bench.display.window_environment)
        self.screen = Screen(self.bench.display.name)
        self.callback(self.screen.close)
        self.publisher = self._start("publisher", self.bench.publisher)
        self._describe_robots()
        self.feed(self.scene.feeds[0])
        ours = self._start(OURS, robotui_scene.command(self.scene, False, self.bench.folder))
        rviz = self._start(RVIZ, rviz_scene.command(self.scene, self.bench.folder))
        self.views = {OURS: self._view(ours, robotui_scene.TITLE, LEFT), RVIZ: self._view(rviz, rviz_scene.TITLE, RIGHT)}
        self._wait_until_alike()
        self._halt()

    def _start(self, name, command):
        program = self.programs.start(name, command)
        prefer([program.process])
        return program

    def _describe_robots(self):
        master = xmlrpc.client.ServerProxy(self.programs.environment["ROS_MASTER_URI"])
        for robot in self.scene.robots:
            space = f"/{robot.name}" if robot.name else ""
            master.setParam("/bench", f"{space}/robot_description", robot.description)
            master.setParam("/bench", f"{space}/robot_state_publisher/publish_frequency", 1000.0)     # with each joint state
            self._start(f"state-publisher{robot.name}", [scenes.STATE_PUBLISHER, *([f"__ns:={space}"] if space else [])])

    def feed(self, variant):
        self.publisher.tell(variant[1])
        if self.publisher.answer() != "ready":
            raise CannotMeasure("the publisher does not know what to send")

    def _view(self, program, title, left):
        view = View(self.screen, program, title, left)
        self.callback(view.send, signal.SIGCONT)                    # a halted program would not hear that it shall end
        return view

    def _wait_until_alike(self):
        end = time.monotonic() + ALIKE_PATIENCE
        while not self._are_alike():
            if time.monotonic() > end:
                raise CannotMeasure("they do not show the same")

    def _are_alike(self):
        covered = {name: view.wait_until_complete(self.scene.rim) for name, view in self.views.items()}
        self.bench.say("  of their views " + ", ".join(f"{name} covers {share * 100:.1f} %" for name, share in covered.items()))
        self.bench.keep_picture(self.scene.name)
        return covered[RVIZ] > 0 and ALIKE[0] < covered[OURS] / covered[RVIZ] < ALIKE[1]

    def _halt(self):
        for view in self.views.values():
            view.halt()

    def frames(self, variant):
        """Rounds of frames per second by program, in the reverse order each time, and what memory they have at the end."""
        self.feed(variant)
        found = {name: [] for name in self.views}
        for number in range(-1, self.bench.rounds):                 # the first one does not count
            for name in list(self.views)[::-1 if number % 2 else 1]:
                with self.views[name].awake() as view:
                    value = view.frames_per_second(WARM_SECONDS if number < 0 else self.bench.seconds)
                found[name] += [value] if number >= 0 else []
                self.bench.say(f"  {number + 1}/{self.bench.rounds} {variant[0]:24}{name:9}{value:6.1f} frames/s")
        memory = {name: view.megabytes() for name, view in self.views.items()}
        self.bench.say(f"  {variant[0]}: " + ", ".join(f"{name} {size:.0f} MB" for name, size in memory.items()))
        return found, memory

    def thinned(self):
        """Ours as it is by itself, where the cloud is thinned while the camera moves: frames at rest of the cloud and while it comes, and latencies."""
        program = self._start(THINNED, robotui_scene.command(self.scene, True, self.bench.folder))
        view = self._view(program, robotui_scene.TITLE, LEFT)
        view.wait_until_complete(self.scene.rim)
        found = {}
        for variant in self.scene.feeds:
            self.feed(variant)
            view.frames_per_second(WARM_SECONDS)
            found[variant[0]] = [view.frames_per_second(self.bench.seconds) for _ in range(self.bench.rounds)]
            self.bench.say(f"  {variant[0]}, thinned: " + ", ".join(f"{rate:.1f}" for rate in found[variant[0]]) + " frames/s")
        return found, {pause: self._latencies(view, pause, THINNED) for pause in MOVES}

    def _latencies(self, view, pause, name):
        rounds = [view.latencies(MOVES[pause], pause) for _ in range(self.bench.rounds)]
        self.bench.say(f"  input latency of {name}, {pause} s after the last: "
                       + "; ".join(" ".join(f"{each * 1e3:.0f}" for each in sorted(found)) for found in rounds) + " ms")
        return rounds
