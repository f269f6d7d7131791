"""That the workbench changes nothing: what an independent listener hears, how the robot moves, what the master knows.

Each case is recorded without, with and after the workbench; the record stays in target/side-effects-CASE.json.
"""
import json
import math
import os
import pathlib
import re
import signal
import statistics
import time
import xmlrpc.client

import pytest

from conftest import ROOT, end, last_of, start_robotui, wait_for
from desktop import Window, missing

PEERS = pathlib.Path(__file__).parent / "peers"
RATE = 10.0
SPEED = 0.2
SECONDS = 8
OURS = re.compile(r"/robotui_\w+")


# ---- what is recorded -------------------------------------------------------------------------------------------------


class Graph:
    """A roscore, a robot that another node drives, and somebody who listens."""

    def __init__(self, roscore):
        self.ros = roscore
        self.master = xmlrpc.client.ServerProxy(roscore.uri)
        robot = str(PEERS / "accountable_robot.py")
        self._start("robot", robot)
        self._start("driver", robot, "--driver")
        self.witness = self._start("witness", str(PEERS / "witness.py"), "odom", "scan", "cmd_vel")
        wait_for(lambda: any(line.get("linear") == SPEED for line in self.lines()), what="the robot to be driven")

    def _start(self, name, *arguments):
        return self.ros.start_tool("/usr/bin/python3", *arguments, name=name)

    def lines(self):
        text = self.witness.out.read_text()
        return [json.loads(line) for line in text[:text.rfind("\n") + 1].splitlines()]

    def _ask(self, method, *arguments):
        code, status, value = getattr(self.master, method)("/side_effects", *arguments)
        assert code == 1, status
        return value

    def state(self):
        """All that the master knows, in an order of its own."""
        kinds = ("publishers", "subscribers", "services")
        state = {kind: sorted([name, sorted(nodes)] for name, nodes in entries)
                 for kind, entries in zip(kinds, self._ask("getSystemState"))}
        return state | {"types": sorted(self._ask("getTopicTypes")), "parameters": self._ask("getParam", "/")}

    def ours(self):
        return sorted(set(OURS.findall(json.dumps(self.state()))))

    def phase(self, name):
        """Listens for a while."""
        begin = time.time()
        wait_for(lambda: self.lines()[-1]["at"] > begin + SECONDS, seconds=3 * SECONDS, what=f"what is heard {name}")
        heard = [line for line in self.lines() if begin <= line["at"] <= begin + SECONDS]
        return {"name": name, "state": self.state(), "heard": heard} | {topic: rhythm(heard, topic) for topic in ("odom", "scan")}


def rhythm(heard, topic):
    """As rostopic hz tells it, and how many messages were missing."""
    lines = [line for line in heard if line["topic"] == topic]
    gaps = [b["at"] - a["at"] for a, b in zip(lines, lines[1:])]
    return {"hz": 1 / statistics.mean(gaps), "longest": max(gaps), "deviation": statistics.pstdev(gaps),
            "missing": lines[-1]["seq"] - lines[0]["seq"] + 1 - len(lines)}


def without_ours(state):
    """What the master knows apart from the workbench's nodes."""
    kept = {kind: [[name, [node for node in nodes if not OURS.match(node)]] for name, nodes in state[kind]]
            for kind in ("publishers", "subscribers", "services")}
    return state | {kind: [entry for entry in entries if entry[1]] for kind, entries in kept.items()}


def keep(case, phases):
    """Leaves the record beside the reports, without every single message."""
    folder = ROOT / "tests/e2e/target"
    folder.mkdir(exist_ok=True)
    record = [{key: value for key, value in phase.items() if key != "heard"} for phase in phases]
    (folder / f"side-effects-{case}.json").write_text(json.dumps(record, indent=1, default=str))


# ---- what is demanded of it -------------------------------------------------------------------------------------------


def same_rhythm(phase, reference):
    for topic in ("odom", "scan"):
        now, before = phase[topic], reference[topic]
        assert abs(now["hz"] / before["hz"] - 1) < 0.03, (phase["name"], topic, now, before)
        assert now["missing"] <= before["missing"] + 1, (phase["name"], topic, now, before)
        assert now["longest"] < before["longest"] + 0.5 / RATE, (phase["name"], topic, now, before)


def same_motion(phase):
    """Commanded by its driver alone, and every step as long as the driver wants it."""
    assert {line["from"] for line in phase["heard"] if line["topic"] == "cmd_vel"} == {"/driver"}
    places = [line for line in phase["heard"] if line["topic"] == "odom"]
    assert {line["linear"] for line in places} == {SPEED}, phase["name"]
    steps = [math.dist((a["x"], a["y"]), (b["x"], b["y"])) / (b["seq"] - a["seq"]) for a, b in zip(places, places[1:])]
    assert all(abs(step - SPEED / RATE) < 0.05 * SPEED / RATE for step in steps), (phase["name"], min(steps), max(steps))


def unharmed(phases):
    for phase in phases:
        same_rhythm(phase, phases[0])
        same_motion(phase)
        assert without_ours(phase["state"]) == phases[0]["state"], phase["name"]


# ---- the cases --------------------------------------------------------------------------------------------------------


@pytest.fixture
def graph(roscore):
    made = Graph(roscore)
    wait_for(lambda: len(made.state()["services"]) == 8, what="all nodes")      # two of each: rosout, robot, driver, witness
    return made


def headless(graph, name="robotui"):
    started = start_robotui(graph.ros, "run", "--json", "ros", name=name)
    wait_for(lambda: (line := last_of(started, "odom")) and line["rate_hz"] > RATE / 2, seconds=60, what="the odometry in the workbench")
    return started


def window(graph, name="window"):
    return Window(start_robotui(graph.ros, "run", "ros", name=name, display=True)).process


WITHOUT_DISPLAY = pytest.mark.skipif(bool(missing()), reason=f"tests in a window need {missing()}")
FACES = [headless, pytest.param(window, marks=WITHOUT_DISPLAY)]


@pytest.mark.parametrize("face", FACES)
def test_nothing_changes_while_the_workbench_runs_nor_when_it_is_closed(graph, face):
    phases = [graph.phase("without")]
    workbench = face(graph)
    phases.append(graph.phase("with"))
    assert len(graph.ours()) == 1

    os.kill(workbench.pid, signal.SIGTERM)
    workbench.wait(20)
    wait_for(lambda: not graph.ours(), seconds=3, what="the end of our registrations")
    phases.append(graph.phase("after"))

    keep(f"closed-{face.__name__}", phases)
    unharmed(phases)
    assert phases[-1]["state"] == phases[0]["state"]


def test_a_killed_workbench_harms_nobody_and_the_next_one_clears_up_after_it(graph):
    phases = [graph.phase("without")]
    killed = headless(graph)
    left = graph.ours()

    end(killed, how=signal.SIGKILL)
    phases.append(graph.phase("after the kill"))
    assert graph.ours() == left, "a killed process cannot have cleared up"

    another = headless(graph, name="another")
    wait_for(lambda: not set(left) & set(graph.ours()), what="the end of what the killed one left")
    phases.append(graph.phase("with another"))
    end(another, how=signal.SIGTERM, patience=20)
    wait_for(lambda: not graph.ours(), seconds=3, what="the end of our registrations")
    phases.append(graph.phase("after"))

    keep("killed", phases)
    unharmed(phases)
    assert phases[-1]["state"] == phases[0]["state"]


def test_a_workbench_that_hangs_harms_nobody(graph):
    phases = [graph.phase("without")]
    workbench = headless(graph)

    os.killpg(workbench.pid, signal.SIGSTOP)
    try:
        phases.append(graph.phase("while it hangs"))
        # The master goes on to serve those who come and go.
        graph.ros.tool("rostopic", "echo", "-n", "1", "/odom")
    finally:
        os.killpg(workbench.pid, signal.SIGCONT)
    wait_for(lambda: (line := last_of(workbench, "odom")) and line["rate_hz"] > RATE / 2 and line["age_s"] < 1, what="its return")
    end(workbench, how=signal.SIGTERM, patience=20)
    wait_for(lambda: not graph.ours(), seconds=3, what="the end of our registrations")
    phases.append(graph.phase("after"))

    keep("stopped", phases)
    unharmed(phases)
    assert phases[-1]["state"] == phases[0]["state"]
