"""A display of a benchmark's own."""
import os
import pathlib
import subprocess
import time

from building import CannotMeasure

PATIENCE = 60


class Display:
    """A display with a window manager, and a home that keeps nothing of the user's. Software draws, as on machines without a graphics card."""

    def __init__(self, folder, screen="1600x1000x24"):
        self.folder = folder
        self.screen = screen
        self.window_environment = {"GDK_BACKEND": "x11", "QT_QPA_PLATFORM": "xcb", "NO_AT_BRIDGE": "1", "LIBGL_ALWAYS_SOFTWARE": "1",
                                   "DBUS_SESSION_BUS_ADDRESS": "disabled:",   # else one is started that stays
                                   "XDG_STATE_HOME": str(folder / "state"), "HOME": str(folder)}
        self.processes = []

    @property
    def name(self):
        return self.window_environment["DISPLAY"]

    @property
    def environment(self):
        """For programs that open windows and speak to ROS on this machine."""
        others = {name: value for name, value in os.environ.items() if name not in ("WAYLAND_DISPLAY", "ROS_HOSTNAME", "DISPLAY")}
        return {**others, **self.window_environment, "ROS_IP": "127.0.0.1"}

    def __enter__(self):
        reader, writer = os.pipe()
        self._start("Xvfb", "-displayfd", str(writer), "-screen", "0", self.screen, "-nolisten", "tcp", pass_fds=[writer])
        os.close(writer)
        with os.fdopen(reader) as answer:                           # ends with the server, so that this cannot hang
            number = answer.readline().strip()
        if not number:
            self.__exit__()
            raise CannotMeasure(f"the display did not start\n{(self.folder / 'Xvfb.log').read_text()[-2000:]}")
        self.window_environment["DISPLAY"] = f":{number}"
        self._start("openbox")
        return self

    def _start(self, *command, pass_fds=()):
        with (self.folder / f"{command[0]}.log").open("w") as log:
            self.processes.append(subprocess.Popen(command, env=self.environment, stdout=log, stderr=log, pass_fds=pass_fds,
                                                   start_new_session=True))

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.terminate()
            process.wait(10)


def wait_for(condition, what, seconds=PATIENCE):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise CannotMeasure(f"{what} did not come")
        time.sleep(0.02)
