"""One run of the workbench: started, looked at from outside, ended, and what it says of itself."""
import json
import os
import pathlib
import signal
import subprocess
import time

import answers
import building
from building import CannotMeasure, variable
from display import wait_for
from processes import Programs, family, pss_megabytes

CROWD = pathlib.Path(__file__).resolve().parents[2] / "e2e" / "peers" / "many_topics.py"
PATIENCE = 60
SETTLED, MEASURED = 10, 12            # seconds after the first picture: the virtual machine compiles until then


class Workbench:
    def __init__(self, display, configuration, environment, *options):
        self.file = display.folder / f"measured-{time.monotonic_ns()}.json"
        self.log = display.folder / "robotui.log"
        product = pathlib.Path(variable("ROBOTUI_WINDOW_PRODUCT", "ui"), "robotui")
        self.started = time.time()
        with self.log.open("w") as log:
            self.process = subprocess.Popen([product, "-config", configuration, "-measure", self.file, *options],
                                            env={**display.environment, **environment}, stdout=log, stderr=log)

    def cpu_seconds(self):
        ticks = 0
        for pid in family(self.process.pid):
            fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
            ticks += int(fields[11]) + int(fields[12])
        return ticks / os.sysconf("SC_CLK_TCK")

    def pss_megabytes(self):
        return pss_megabytes(self.process.pid)

    def said(self):
        """It writes anew every second."""
        if not self.file.exists():
            raise CannotMeasure(f"the workbench wrote no figures\n{self.log.read_text()[-2000:]}")
        return json.loads(self.file.read_text())

    def has_painted(self):
        return self.file.exists() and self.said()["first_picture_epoch_ms"] > 0

    def end(self):
        self.process.terminate()
        try:
            self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            for pid in reversed(family(self.process.pid)):
                os.kill(pid, signal.SIGKILL)
            self.process.wait()


def measured(workbench, then=lambda: {}):
    """Processor time per second while it runs on, what it says of itself, and what is measured THEN."""
    try:
        wait_for(workbench.has_painted, "a live picture")
        time.sleep(SETTLED)
        before, cpu = time.monotonic(), workbench.cpu_seconds()
        time.sleep(MEASURED)
        result = {"cpu": (workbench.cpu_seconds() - cpu) / (time.monotonic() - before), "pss": workbench.pss_megabytes()}
        said = workbench.said()
        result |= then()
    finally:
        workbench.end()
    if said["display_ms"]["count"] == 0:
        raise CannotMeasure(f"the display thread gave no sign\n{workbench.log.read_text()[-2000:]}")
    return {**result, "start": said["first_picture_epoch_ms"] / 1000 - workbench.started,
            "p50": said["display_ms"]["p50"], "p99": said["display_ms"]["p99"], "longest": said["display_ms"]["max"],
            "frames": said["frames"]}


def robots_round(display, robots, count):
    """COUNT robots, the first of them selected."""
    ruics = "".join(f"  Robot{i}:\n    type: mobilebase\n    rfics:\n      base: {{type: ros, namespace: /r{i}}}\n" for i in range(count))
    with Programs(display.folder) as programs:
        return with_robots(display, robots, count, programs, ruics)


def topics_round(display, robots, crowd):
    """One robot, whose map, topics and ports are seen, beside a CROWD of topics and nodes."""
    ruics = "  Robot:\n    type: mobilebase\n    rfics:\n      base: {type: ros}\n    layout: {row: [map, {column: [topics, status]}]}\n"
    with Programs(display.folder) as programs:
        if crowd:
            expect("registered", programs.start("crowd", [building.SYSTEM_PYTHON, CROWD, *crowd]))
        return with_robots(display, robots, 1, programs, ruics, asked=bool(crowd))


def with_robots(display, robots, count, programs, ruics, asked=False):
    configuration = display.folder / "robots.yaml"
    configuration.write_text("ruics:\n" + ruics)
    expect("ready", programs.start("robots", [*robots, count]))
    environment = {"ROS_MASTER_URI": programs.environment["ROS_MASTER_URI"]}
    if not asked:
        return measured(Workbench(display, configuration, environment))
    workbench = Workbench(display, configuration, environment, "-scriptsocket")
    return measured(workbench, lambda: answers.of(workbench, display))


def expect(word, program):
    if program.answer() != word:
        raise CannotMeasure(f"{program.name} did not start")


def demo_round(display):
    """The demo's robot, which runs already, as robots do."""
    root = pathlib.Path(variable("ROBOTUI_ROOT", "ui"))
    return simulated(display, root / "configs" / "demo.yaml")


def team_round(display, count):
    """A swarm of COUNT robots as configs/swarm.yaml has it, all on one map and in one table."""
    root = pathlib.Path(variable("ROBOTUI_ROOT", "ui"))
    configuration = display.folder / "swarm.yaml"
    configuration.write_text((root / "configs" / "swarm.yaml").read_text().replace("r1..r50", f"r1..r{count}"))
    return simulated(display, configuration, "--swarm", str(count))


def simulated(display, configuration, *options):
    simulator = subprocess.Popen([pathlib.Path(variable("JAVA_HOME", "ui"), "bin", "java"), "-XX:+UseSerialGC",
                                  "-XX:TieredStopAtLevel=1", "-Dslf4j.internal.verbosity=ERROR", "-cp", variable("ROBOTUI_SIMULATOR_PATH", "ui"),
                                  "org.robotui.sim.Main", *options], stdout=subprocess.PIPE, text=True)
    try:
        uri = next(line for line in simulator.stdout if line.startswith("ROS_MASTER_URI=")).strip().split("=", 1)[1]
        time.sleep(2)
        return measured(Workbench(display, configuration, {"ROS_MASTER_URI": uri, "ROS_IP": "127.0.0.1"}))
    finally:
        simulator.kill()
        simulator.wait(10)
