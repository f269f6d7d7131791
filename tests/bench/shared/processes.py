"""The programs that are measured: started once, told on stdin what to do, ended with all their children."""
import contextlib
import os
import pathlib
import queue
import re
import signal
import socket
import subprocess
import sys
import threading
import time

from building import CannotMeasure

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "shared"))

from ports import free_port  # noqa: E402

PATIENCE = 60


class Program:
    """A program that answers each line on its stdin with one line on its stdout."""

    def __init__(self, name, command, environment, folder):
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))       # who is ended ends what was started
        self.name = name
        self.log = folder / f"{name}.log"
        with self.log.open("w") as log:
            self.process = subprocess.Popen([str(word) for word in command], env=environment, stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=log, text=True, start_new_session=True, cwd=folder)
        self.answers = queue.Queue()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self.process.stdout:
            self.answers.put(line.strip())
        self.answers.put(None)

    def tell(self, line):
        try:
            self.process.stdin.write(line + "\n")
            self.process.stdin.flush()
        except OSError:
            raise self._failed("ended") from None

    def answer(self, patience=PATIENCE):
        try:
            line = self.answers.get(timeout=patience)
        except queue.Empty:
            raise self._failed(f"did not answer within {patience:g} s") from None
        if line is None or line.startswith("error"):
            raise self._failed(line or "ended")
        return line

    def _failed(self, how):
        return CannotMeasure(f"{self.name}: {how}\n{self.log.read_text()[-2000:]}")

    def end(self):
        for sign in (signal.SIGTERM, signal.SIGKILL):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self.process.pid, sign)
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.process.wait(5)
                return


class Programs(contextlib.ExitStack):
    """All programs of one measurement, around one real ROS master."""

    def __init__(self, folder):
        super().__init__()
        port = free_port()
        self.folder = folder
        self.environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1",
                                ROS_HOME=str(folder), ROS_LOG_DIR=str(folder))
        self.environment.pop("ROS_HOSTNAME", None)
        master = self.start("master", ["rosmaster", "--core", "-p", port])
        wait_for_port(port, master)

    def start(self, name, command):
        program = Program(name, command, self.environment, self.folder)
        self.callback(program.end)
        return program


def family(pid):
    """A process and all below it: a launcher is a script or a small program, and what is measured runs below."""
    found, open_list = [], [pid]
    while open_list:
        pid = open_list.pop()
        found.append(pid)
        open_list += [int(child) for child in text_of(pid, f"task/{pid}/children").split()]
    return found


def text_of(pid, name):
    """What the system says of a process; nothing of one that has ended, which it may do at any time."""
    try:
        return pathlib.Path(f"/proc/{pid}/{name}").read_text()
    except OSError:
        return ""


def processor_seconds(pid):
    """The processor time of a process since its start; 0 where it has ended."""
    fields = text_of(pid, "stat").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK") if fields else 0.0


def pss_megabytes(pid):
    """The proportional set size of a family."""
    sizes = (re.search(r"^Pss:\s+(\d+) kB", text_of(each, "smaps_rollup"), re.M) for each in family(pid))
    return sum(int(size[1]) for size in sizes if size) / 1000


def wait_for_port(port, program):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end and program.process.poll() is None:
        with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port), 1):
            return
        time.sleep(0.05)
    raise CannotMeasure(f"the ROS master did not start\n{program.log.read_text()[-2000:]}")
