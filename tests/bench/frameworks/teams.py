"""A team of robots of one framework in the application without a window: how much of the machine it takes."""
import json
import os
import pathlib
import time

import building
from building import CannotMeasure
from processes import Program, family, processor_seconds, pss_megabytes

HERE = pathlib.Path(__file__).resolve().parent
ROBOTS = 50
SETTLED, MEASURED = 5, 10
PATIENCE = 120
LEAST = 5                                                   # Hz of odometry that each robot has, of ten
ODOMETRY = {"ros": "odom", "carmen": "base_odometry"}


def robots(folder, name, recordings):
    """The program of the robots, and the settings of each."""
    if name == "carmen":
        program = Program("fleet", [building.SYSTEM_PYTHON, HERE / "carmen_fleet.py", ROBOTS, recordings], dict(os.environ), folder)
        return program, [f"{{type: carmen, host: 127.0.0.1, port: {port}}}" for port in json.loads(program.answer())]
    java = pathlib.Path(building.variable("JAVA_HOME", "frameworks"), "bin", "java")
    program = Program("swarm", [java, "-XX:+UseSerialGC", "-cp", building.variable("ROBOTUI_SIMULATOR_PATH", "frameworks"), "org.robotui.sim.Main",
                                "--swarm", ROBOTS], dict(os.environ), folder)
    master = program.answer().partition("=")[2]
    return program, [f"{{type: ros, master: '{master}', namespace: /r{number + 1}}}" for number in range(ROBOTS)]


def team(folder, name, recordings):
    """Processors used, and memory, once all robots are live in one team."""
    program, settings = robots(folder, name, recordings)
    try:
        config = folder / "team.yaml"
        config.write_text("ruics:\n  Team:\n    type: team\n    rfics:\n"
                          + "".join(f"      r{number + 1}: {each}\n" for number, each in enumerate(settings)))
        plain = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        application = Program("team", [pathlib.Path(building.variable("ROBOTUI_ROOT", "frameworks"), "robotui"), "run", "--json", config],
                              plain | {"XDG_STATE_HOME": str(folder / "state")}, folder)
        try:
            await_all(application, ODOMETRY[name])
            return used(application)
        finally:
            application.end()
    finally:
        program.end()


def await_all(application, port):
    live, end = set(), time.monotonic() + PATIENCE
    while len(live) < ROBOTS:
        if time.monotonic() > end:
            raise CannotMeasure(f"{len(live)} of {ROBOTS} robots were live within {PATIENCE} s")
        line = json.loads(application.answer(PATIENCE))
        robot, _, name = line["port"].partition(".")
        if name == port and line["rate_hz"] >= LEAST:
            live.add(robot)


def used(application):
    time.sleep(SETTLED)
    pids = family(application.process.pid)
    before, begin = sum(map(processor_seconds, pids)), time.monotonic()
    time.sleep(MEASURED)
    return {"cpu": (sum(map(processor_seconds, pids)) - before) / (time.monotonic() - begin), "pss": pss_megabytes(application.process.pid)}
