"""That the workbench changes nothing at robots that speak CARMEN, YARP and SmartSoft: what independent clients of each hear, who drives, what servers know.

The three robots are recorded at the same time, each without, with and after the workbench; records stay in target/side-effects-FRAMEWORK-CASE.json.
"""
import json
import os
import pathlib
import signal
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import pytest

from conftest import Processes, Robot, end, needs_long, start_robotui, start_sim_program, wait_for
from side_effects import Stopped, Witness, closed, comes_back, ended, guards_of, keep, rhythm, same_rhythm, shows

PEERS = pathlib.Path(__file__).parent / "peers"
SECONDS = 3
STOPPED, LONG_STOPPED = 4, 8
HELD_UP = 0.9         # by a server that waits for a second
SPEED, RATE = 0.1, 20      # as peers/frames.py drives, and the robot says how
LATE = 0.3           # after which a robot may stop by itself, as nobody drives it


@dataclass(frozen=True)
class Framework:
    """What differs. Without a guard where there is none to be had."""

    name: str
    variable: str
    odometry: str
    scan: str
    more: str = ""
    guarded: bool = True


FRAMEWORKS = (Framework("carmen", "CENTRALHOST", "base_odometry", "robot_frontlaser"),
              Framework("yarp", "YARP_NAMESERVER", "odo/odometry", "laser", more=", prefix: /natalie", guarded=False),
              Framework("smartsoft", "SMART_NS_ADDR", "base/baseState", "laser/laserScan"))


class Driven:
    """A simulated robot of one framework, somebody who drives it, and somebody who listens."""

    def __init__(self, framework, machine):
        self.framework, self.machine = framework, machine
        name = framework.name
        self.process = start_sim_program(machine.processes, machine.environment, f"{name}-robot",
                                         ["org.robotui.carmen", "org.robotui.yarp", "org.robotui.smartsoft"], "--speak", name)

    def begin(self):
        self.address = wait_for(self.said, seconds=90, what=f"the robot of {self.framework.name}")
        self.driver = Witness(self.peer("drive"))
        self.witness = Witness(self.peer("hear"))

    def steady(self):
        """A robot that has just been started is late at first, and then makes up for it."""
        said = [line for line in self.witness.lines() if line["topic"] == "odom"][-2 * RATE:]
        return len(said) == 2 * RATE and abs(said[0]["linear"] - SPEED) < 1e-6 and abs(rhythm(said, "odom")["hz"] / RATE - 1) < 0.02

    def said(self):
        return next((line.partition("=")[2] for line in self.process.out.read_text().splitlines() if line.startswith(self.framework.variable)), None)

    def client(self, what):
        return "/usr/bin/python3", str(PEERS / f"{self.framework.name}_client.py"), self.address, what

    def peer(self, what):
        return self.machine.start_tool(*self.client(what), name=f"{self.framework.name}-{what}")

    def known(self):
        """How many connections the server's process has, and what it knows."""
        return {"connections": connections(self.process.pid), "known": json.loads(self.machine.tool(*self.client("known")))}

    def settings(self, guard):
        host, _, port = self.address.partition(":")
        guard = f", guard: {str(guard).lower()}" if self.framework.guarded else ""
        return f"{{type: {self.framework.name}, host: {host}, port: {port}{self.framework.more}{guard}}}"

    def phase(self, name, seconds):
        return self.witness.phase(name, seconds) | self.known()


def connections(pid):
    """How many TCP connections a process has."""
    inodes = {link[8:-1] for link in map(target_of, pathlib.Path(f"/proc/{pid}/fd").iterdir()) if link.startswith("socket:[")}
    rows = [row.split() for table in ("tcp", "tcp6") for row in pathlib.Path(f"/proc/net/{table}").read_text().splitlines()[1:]]
    return sum(row[9] in inodes and row[3] != "0A" for row in rows)


def target_of(link):
    """Nothing of what was closed meanwhile."""
    try:
        return str(link.readlink())
    except FileNotFoundError:
        return ""


class Three:
    """The robots of all three frameworks, what was heard of each without a workbench, and what is heard since then."""

    def __init__(self, machine):
        self.machine = machine
        self.robots = [Driven(framework, machine) for framework in FRAMEWORKS]
        for robot in self.robots:
            robot.begin()
        for robot in self.robots:
            wait_for(robot.steady, seconds=60, what=f"the robot of {robot.framework.name} to be driven, and to say so steadily")
        self.phases = {}
        self.record()
        self.phase("without")
        self.without = {robot: phases[0] for robot, phases in self.phases.items()}

    def record(self):
        """Begins anew."""
        self.phases = {robot: [] for robot in self.robots}

    def phase(self, name, seconds=SECONDS):
        """What each of the three hears in the same seconds, and what their servers know after that."""
        with ThreadPoolExecutor() as threads:
            for robot, phase in zip(self.robots, threads.map(lambda each: each.phase(name, seconds), self.robots)):
                self.phases[robot].append(phase)

    def workbench(self, guard):
        config = self.machine.processes.folder / f"three-{guard}.yaml"
        config.write_text("ruics:\n" + "".join(
            f"  {robot.framework.name}:\n    type: mobilebase\n    rfics:\n      base: {robot.settings(guard)}\n" for robot in self.robots))
        started = start_robotui(self.machine, "run", "--json", str(config))
        for robot in self.robots:
            for port in (robot.framework.odometry, robot.framework.scan):
                wait_for(lambda port=port: shows(started, port, 10), seconds=90, what=f"{port} in the workbench")
        return started

    def back(self, workbench):
        for robot in self.robots:
            comes_back(workbench, robot.framework.odometry, 10)

    def left(self, workbench, patience=20):
        """Waits until no connection of the workbench is left at any robot."""
        wait_for(lambda: not any(self.linked(robot) for robot in self.robots), seconds=patience, what=f"the end of the connections of {workbench.pid}")

    def linked(self, robot):
        """How many connections a robot has that it does not have without a workbench."""
        return max(0, connections(robot.process.pid) - self.without[robot]["connections"])

    def unharmed(self, case):
        for robot, phases in self.phases.items():
            keep(f"{robot.framework.name}-{case}", [self.without[robot], *phases])
        for robot, phases in self.phases.items():
            for phase in phases:
                same_rhythm(phase, self.without[robot])
                driven_by_its_driver_alone(robot, phase)


def driven_by_its_driver_alone(robot, phase):
    """The robot goes as fast as its driver wants it, but where the machine has kept its driver from saying so."""
    said = [line["at"] for line in robot.driver.lines()]
    late = [(a, b + LATE) for a, b in zip(said, said[1:]) if b - a > LATE]
    other = [line for line in phase["heard"]
             if line["topic"] == "odom" and abs(line["linear"] - SPEED) > 1e-6 and not any(a < line["at"] < b for a, b in late)]
    assert not other, (robot.framework.name, phase["name"], other)


@pytest.fixture(scope="module")
def robots(tmp_path_factory):
    processes = Processes(tmp_path_factory.mktemp("three"))
    environment = dict(os.environ) | {"XDG_STATE_HOME": str(processes.folder / "state"), "PYTHONUNBUFFERED": "1"}
    try:
        yield Three(Robot(processes, "", environment))
    finally:
        processes.end()


@pytest.fixture
def three(robots):
    robots.record()
    return robots


def ours(known):
    """Names that the workbench has entered: the one port of YARP, which a killed process cannot take out of the list."""
    return [name for name in known if name.startswith("/robotui/")]


def test_nothing_changes_while_the_workbench_runs_nor_when_it_is_stopped_or_closed(three):
    before = {robot: robot.known()["known"] for robot in three.robots}
    started = three.workbench(False)
    three.phase("with")
    with Stopped(started):
        three.phase("while it is stopped", STOPPED)
    three.back(started)
    closed(started)
    three.left(started)
    three.phase("after")

    three.unharmed("closed")
    for robot, (during, _, after) in three.phases.items():
        assert during["connections"] > three.without[robot]["connections"], robot.framework.name
        assert after["known"] == before[robot], robot.framework.name


def test_a_guard_leaves_for_a_workbench_that_is_stopped_and_a_killed_one_leaves_a_name_at_most(three):
    before = {robot: robot.known()["known"] for robot in three.robots}
    started = three.workbench(True)
    guards = guards_of(started)
    guarded = [robot for robot in three.robots if robot.framework.guarded]
    assert len(guards) == len(guarded)
    with Stopped(started):
        wait_for(lambda: not any(three.linked(robot) for robot in guarded), seconds=30, what="the guards to leave")
        three.phase("while it is stopped")
    three.back(started)
    end(started, how=signal.SIGKILL)
    three.left(started)
    three.phase("after the kill")

    three.unharmed("killed")
    wait_for(lambda: ended(guards), what="the end of the guards")
    for robot, phases in three.phases.items():
        known = phases[-1]["known"]
        assert [name for name in known if name not in ours(known)] == before[robot], robot.framework.name
        assert len(ours(known)) == (0 if robot.framework.guarded else 1), robot.framework.name


@needs_long
@pytest.mark.parametrize("guard", [False, True])
def test_a_server_of_push_waits_for_a_workbench_that_is_stopped_unless_it_has_a_guard(processes, environment, guard):
    """A model of SmartSoft's own server: this is measured, and stands in docs/side-effects.md. What it has given up halfway spoils our link, which is made anew."""
    machine = Robot(processes, "", environment)
    robot = machine.start_tool("/usr/bin/python3", str(PEERS / "smartsoft_robot.py"), name="robot")
    port = int(wait_for(robot.out.read_text, what="the robot's port"))
    witness = Witness(machine.start_tool("/usr/bin/python3", str(PEERS / "smartsoft_client.py"), f"127.0.0.1:{port}", "hear", name="witness"))
    wait_for(lambda: len(witness.lines()) > 2 * RATE, what="the witness")
    phases = [witness.phase("without", SECONDS)]
    config = processes.folder / "waiting.yaml"
    config.write_text("ruics:\n  Robot:\n    type: mobilebase\n    rfics:\n"
                      f"      base: {{type: smartsoft, host: 127.0.0.1, port: {port}, guard: {str(guard).lower()}}}\n")
    started = start_robotui(machine, "run", "--json", str(config))
    wait_for(lambda: shows(started, "laser/laserScan", 10), seconds=90, what="scans in the workbench")
    begin = time.time()
    with Stopped(started):
        time.sleep(LONG_STOPPED)                # nothing tells when a server goes on not to speak
    heard = [line["at"] for line in witness.lines() if line["topic"] == "scan" and line["at"] > begin - 1]
    gaps = [b - a for a, b in zip(heard, heard[1:])]
    waits = sum(gap > HELD_UP for gap in gaps)
    comes_back(started, "laser/laserScan", 10)
    phases.append(witness.phase("after its return", SECONDS))
    closed(started)
    keep(f"smartsoft-waiting-{'guarded' if guard else 'plain'}", [*phases, {"name": "while it is stopped", "longest": max(gaps), "waits": waits}])
    same_rhythm(phases[1], phases[0])
    assert waits == 0 if guard else waits > 1, sorted(gaps)[-5:]
