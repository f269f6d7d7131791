"""How it is recorded and judged that the workbench changes nothing: the rhythm of what a witness hears, and how the robot moves."""
import json
import math
import os
import signal
import statistics
import time

from conftest import ROOT, below, end, json_lines, last_of, processes_of, wait_for
from metronome import Metronome

SPEED = 0.2
SLACK = 0.25         # s; what a machine that does much else may cost one process, and less than whoever is blocked waits


def rhythm(heard, topic):
    """As rostopic hz tells it, and how many messages were missing."""
    lines = [line for line in heard if line["topic"] == topic]
    gaps = [b["at"] - a["at"] for a, b in zip(lines, lines[1:])]
    if not gaps:
        return {"hz": 0.0, "longest": math.inf, "deviation": math.inf, "missing": 0}
    return {"hz": 1 / statistics.mean(gaps), "longest": max(gaps), "deviation": statistics.pstdev(gaps),
            "missing": lines[-1]["seq"] - lines[0]["seq"] + 1 - len(lines)}


def keep(case, phases):
    """Leaves the record beside the reports, without every single message."""
    folder = ROOT / "tests/e2e/target"
    folder.mkdir(exist_ok=True)
    record = [{key: value for key, value in phase.items() if key != "heard"} for phase in phases]
    (folder / f"side-effects-{case}.json").write_text(json.dumps(record, indent=1, default=str))


def same_rhythm(phase, reference, topics=("odom", "scan")):
    """As often as before, and never later than before by more than the slack and what the machine paused everybody."""
    paused = phase["paused"]
    for topic in topics:
        now, before = phase[topic], reference[topic]
        said = (phase["name"], topic, now, before, paused)
        assert abs(now["hz"] / before["hz"] - 1) < 0.03 + paused["sum"] / phase["seconds"], said
        assert now["missing"] <= before["missing"] + 1, said
        assert now["longest"] < before["longest"] + SLACK + paused["longest"], said


def same_steps(phase, step):
    """Every step of the robot is as long as its driver wants it."""
    places = [line for line in phase["heard"] if line["topic"] == "odom"]
    assert {line["linear"] for line in places} == {SPEED}, phase["name"]
    steps = [math.dist((a["x"], a["y"]), (b["x"], b["y"])) / (b["seq"] - a["seq"]) for a, b in zip(places, places[1:])]
    assert all(abs(each - step) < 0.05 * step for each in steps), (phase["name"], min(steps), max(steps))


def longest_gap(witness, since, topic="odom"):
    """The longest time in which a witness heard nothing of a topic."""
    times = [line["at"] for line in witness.lines() if line["topic"] == topic and line["at"] > since - 1]
    return max(b - a for a, b in zip(times, times[1:]))


class Witness:
    """What an independent listener prints, a line for each message."""

    def __init__(self, process):
        self.process = process

    def lines(self):
        text = self.process.out.read_text()
        return [json.loads(line) for line in text[:text.rfind("\n") + 1].splitlines()]

    def heard(self, seconds, what, patience=3):
        """All that it hears from now on for a while."""
        begin = time.time()
        wait_for(lambda: (lines := self.lines()) and lines[-1]["at"] > begin + seconds, seconds=patience * seconds, what=f"what is heard {what}")
        return [line for line in self.lines() if begin <= line["at"] <= begin + seconds]

    def phase(self, name, seconds, **more):
        metronome = Metronome()
        try:
            heard = self.heard(seconds, name)
        finally:
            paused = metronome.pauses()
        return ({"name": name, "seconds": seconds, "heard": heard, "paused": paused}
                | {topic: rhythm(heard, topic) for topic in ("odom", "scan")} | more)


class Stopped:
    """A workbench that is stopped for a while, as by Ctrl+Z."""

    def __init__(self, workbench):
        self.group = workbench.pid

    def __enter__(self):
        os.killpg(self.group, signal.SIGSTOP)

    def __exit__(self, *_):
        os.killpg(self.group, signal.SIGCONT)


def guards_of(workbench):
    """The processes of the guards of one workbench."""
    return {guard for pid in [workbench.pid, *below(workbench.pid)] for guard in _guards(pid)}


def ended(guards):
    """Whether no process of these is left."""
    return not guards & _guards()


def _guards(*guarded):
    return set(processes_of("java", "org.robotui.guard.internal.process.GuardMain", *guarded))


def shows(workbench, port, least):
    """The port's newest line, if it is live."""
    line = last_of(workbench, port)
    return line if line and line["rate_hz"] > least and line["age_s"] is not None and line["age_s"] < 1 else None


def comes_back(workbench, port, least):
    """Waits until a workbench that was stopped says again that a port is live."""
    before = len(json_lines(workbench))
    wait_for(lambda: len(json_lines(workbench)) > before and shows(workbench, port, least), seconds=60, what="its return")


def closed(workbench):
    end(workbench, how=signal.SIGTERM, patience=20)
