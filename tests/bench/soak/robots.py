"""Simulated robots, each with a process, and a configuration for each."""
import contextlib
import os
import pathlib
import queue
import subprocess
import threading

from building import CannotMeasure, variable

# Of each framework: the robot of the simulator, and what the configuration says of the interface.
FRAMEWORKS = {"ros": ("natalie", ""), "ros2": ("natalie", ""), "player": ("keira", ""), "carmen": ("natalie", ""), "yarp": ("natalie", ", prefix: /natalie")}
PATIENCE = 300
JVM = ["-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-Xmx128m", "-Dslf4j.internal.verbosity=ERROR"]


class Robots(contextlib.ExitStack):
    """All of them; their configurations by name, and the variables by which they are found."""

    def __init__(self, folder):
        super().__init__()
        self.environment = {"ROS_IP": "127.0.0.1", "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
        self.configurations = {}
        for number, (framework, (robot, more)) in enumerate(FRAMEWORKS.items(), 1):
            self.environment.update(self._start(folder, framework, robot, number))
            name = f"{framework.capitalize()}bot"
            file = folder / f"{name}.yaml"
            file.write_text(f"ruics:\n  {name}:\n    type: mobilebase\n    rfics:\n      base: {{type: {framework}{more}}}\n", encoding="utf-8")
            self.configurations[name] = file

    def _start(self, folder, framework, robot, number):
        java = pathlib.Path(variable("JAVA_HOME", "soak"), "bin", "java")
        log = folder / f"robot-{framework}.log"
        with log.open("w") as err:
            process = subprocess.Popen([java, *JVM, "-cp", variable("ROBOTUI_SIMULATOR_PATH", "soak"), "org.robotui.sim.Main", "--robot", robot, "--speak", framework,
                                        "--seed", str(number), "--parent", str(os.getpid())], stdout=subprocess.PIPE, stderr=err, text=True)
        self.callback(process.wait, 10)
        self.callback(process.kill)
        return dict(line.split("=", 1) for line in said_in_one_piece(process, log))


def said_in_one_piece(process, log):
    """The variables that a robot says when it is there."""
    lines = queue.Queue()
    threading.Thread(target=lambda: [lines.put(line.strip()) for line in process.stdout], daemon=True).start()
    try:
        found = [lines.get(timeout=PATIENCE)]
        with contextlib.suppress(queue.Empty):
            while True:
                found.append(lines.get(timeout=0.5))
        return found
    except queue.Empty:
        raise CannotMeasure(f"a robot did not start\n{log.read_text()[-2000:]}") from None
