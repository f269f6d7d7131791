"""A robotui-rt that is measured: started for a window, and ended in any case."""
import contextlib
import json
import os
import pathlib
import signal
import subprocess

import building
from building import CannotMeasure
from processes import PATIENCE, Program

NAME = "bench"
MARGIN = 60                                                         # seconds that a start and an end may take
END = 10
RIGHTS = 3                                                          # how robotui-rt ends where it may not run in real time


def built(name, folder="bin"):
    path = pathlib.Path(building.variable("ROBOTUI_NATIVE", "rt"), folder, name)
    if not path.exists():
        raise CannotMeasure(f"{name} is not built: start this with ./robotui bench rt")
    return path


def limited(seconds, command):
    """COMMAND, which ends after so long whatever becomes of who started it: a thread in real time must not be left behind."""
    return ["timeout", "--foreground", "--kill-after=5", f"{seconds:.0f}", *(str(word) for word in command)]


class Control(contextlib.AbstractContextManager):
    """Runs the configuration for SECONDS at most, with its plugins started."""

    def __init__(self, folder, config, plugins, seconds, options=()):
        self.folder = folder
        self.log = folder / "robotui-rt.log"
        self.environment = dict(os.environ, XDG_RUNTIME_DIR=str(folder), XDG_STATE_HOME=str(folder),
                                ROBOTUI_RT_PLUGINS=str(built(".", "lib")))
        command = [built("robotui-rt"), "-C", config, "--name", NAME, "--no-ch", *options]
        with self.log.open("w") as log:
            self.process = subprocess.Popen(limited(seconds + MARGIN, command), env=self.environment, stdin=subprocess.DEVNULL,
                                            stdout=subprocess.DEVNULL, stderr=log, start_new_session=True)
        self.patience = seconds + PATIENCE
        self.watch = None
        try:
            self.watch = Program("rt_watch", [built("rt_watch"), NAME], self.environment, folder)
            self.ask("start " + " ".join(plugins))
        except BaseException:
            self.end()
            raise

    def ask(self, line):
        try:
            self.watch.tell(line)
            return json.loads(self.watch.answer(self.patience))
        except CannotMeasure as e:
            if self.process.poll() == RIGHTS:
                raise CannotMeasure(self.log.read_text()[-2000:]) from None
            raise CannotMeasure(f"{e}\n{self.log.read_text()[-2000:]}") from None

    def end(self):
        if self.watch is not None:
            self.watch.end()
        with contextlib.suppress(ProcessLookupError):
            self.process.terminate()                                # which robotui-rt is told, and ends its processes in order
        with contextlib.suppress(subprocess.TimeoutExpired):
            self.process.wait(END)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()

    def __exit__(self, *_):
        self.end()
