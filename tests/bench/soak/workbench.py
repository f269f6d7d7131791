"""The workbench as a process that is looked at from outside, after a collection."""
import pathlib
import re
import signal
import subprocess

from building import CannotMeasure, variable
from display import wait_for
from priority import prefer
from processes import family, text_of

import robotui

PATIENCE = 600
GRAPHICS = ("Font", "Image", "GC", "Cursor", "Path", "Pattern", "Region", "TextLayout", "Transform")
# What holds something of the system and was not disposed of is told when it is collected.
TRACKED = "-Dorg.eclipse.swt.graphics.Resource.reportNonDisposed=true"
FORGOTTEN = "Not properly disposed"
HISTOGRAM = re.compile(r"^\s*\d+:\s+(\d+)\s+(\d+)\s+(\S+)", re.M)
TOTAL = re.compile(r"^Total\s+\d+\s+(\d+)", re.M)


class Workbench:
    """Ends with its block."""

    def __init__(self, display, configurations, environment):
        self.display = display
        self.log = display.folder / "robotui.log"
        product = pathlib.Path(variable("ROBOTUI_WINDOW_PRODUCT", "soak"), "robotui")
        with self.log.open("w") as log:
            self.process = subprocess.Popen([product, "-config", *configurations.values(), "-scriptsocket"], stdout=log, stderr=log, start_new_session=True,
                                            env={**display.environment, **environment, "JAVA_TOOL_OPTIONS": TRACKED})
        prefer([self.process])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()

    def scripts(self):
        """A connection for scripts, once all robots answer."""
        place = re.compile(r"scripts may come by (\S+)")
        wait_for(lambda: place.search(self.log.read_text()), "the socket for scripts", PATIENCE)
        connection = robotui.connect(place.search(self.log.read_text()).group(1))
        for ui in connection.run("uis().map(u => u.name)"):
            connection.run(f"waitForLink({PATIENCE}, {ui!r})")
        return connection

    @property
    def virtual_machine(self):
        return next((pid for pid in family(self.process.pid) if text_of(pid, "comm").strip() == "java"), None)

    def asked(self, *words):
        jcmd = pathlib.Path(variable("JAVA_HOME", "soak"), "bin", "jcmd")
        done = subprocess.run([jcmd, str(self.virtual_machine), *words], capture_output=True, text=True, timeout=PATIENCE)
        if done.returncode != 0:
            raise CannotMeasure(f"{words[0]}: {done.stdout}{done.stderr}\n{self.log.read_text()[-2000:]}")
        return done.stdout

    def sample(self):
        """What it keeps now, in MB and numbers, and its objects by class."""
        self.asked("GC.run")
        histogram = self.asked("GC.class_histogram")                # of what is reachable
        classes = {name: (int(count), int(size)) for count, size, name in HISTOGRAM.findall(histogram)}
        pid = self.virtual_machine
        widgets = sum(count for name, (count, _) in classes.items() if name.startswith("org.eclipse.swt.widgets.") and "$" not in name)
        loaded = re.search(r"^java\.cls\.loadedClasses=(\d+).*?^java\.cls\.unloadedClasses=(\d+)", self.asked("PerfCounter.print"), re.M | re.S)
        return {"heap": int(TOTAL.search(histogram)[1]) / 1e6, "resident": resident_megabytes(pid), "threads": len(list(pathlib.Path(f"/proc/{pid}/task").iterdir())),
                "files": len(list(pathlib.Path(f"/proc/{pid}/fd").iterdir())), "classes": int(loaded[1]) - int(loaded[2]),
                "graphics": sum(classes.get(f"org.eclipse.swt.graphics.{kind}", (0, 0))[0] for kind in GRAPHICS), "widgets": widgets,
                "forgotten": self.log.read_text().count(FORGOTTEN), "x_server": resident_megabytes(self.display.processes[0].pid)}, classes


def resident_megabytes(pid):
    return int(re.search(r"^VmRSS:\s+(\d+) kB", text_of(pid, "status"), re.M)[1]) / 1000
