"""A robot behind a bad network: 50 ms each way, two packets of a hundred lost, and outages."""
import contextlib
import json
import math
import pathlib
import time

import pytest

from conftest import json_lines, last_of, start_robotui, wait_for
from desktop import Keys, Motion, Window, missing
from network import network, start_robot    # noqa: F401 (a fixture)

HEAR = pathlib.Path(__file__).parent / "peers" / "commands.py"
DELAY, LOSS = 0.05, 0.02
# What is on its way when an outage begins cannot be called back: packets of one command, eight where one of them was just lost and is
# waited for, and one packet full of them (1448 bytes of 52 each, with the parts of two more at its ends) where they had to wait for
# their turn. Without a bound it would be all of a long outage: twenty a second, eighty and more.
ON_ITS_WAY = 8 + 1448 // 52 + 2
SHORT, LONG = 1.0, 4.0
OLD = 0.5
HOLDS = 0.5         # the robot obeys a command for so long
DELIVERED = 0.5     # a packet, lost once and sent again, and its answer
PATIENCE = 90       # for what only a machine that does much else makes slow


@pytest.fixture
def robot(network, environment):                          # noqa: F811
    start_robot(network, environment)
    return network.robot


# ---- without a window -------------------------------------------------------------------------------------------------


def line_of(robotui, port, least):
    line = last_of(robotui, port)
    return line if line and line["rate_hz"] >= least and line["age_s"] < 0.5 and line["link"] == "connected" else None


def comes(robotui, ports=(("odom", 20), ("scan", 8), ("imu/data", 10)), seconds=PATIENCE):
    for port, least in ports:
        wait_for(lambda: line_of(robotui, port, least), seconds=seconds, what=f"{port} at {least} Hz")


def lines_since(robotui, number, port):
    return [line for line in json_lines(robotui)[number:] if line["port"] == f"base.{port}"]


def shown_outage(robotui, network, seconds):              # noqa: F811
    """What is said of the odometry from the beginning of an outage until it is there again."""
    before = len(json_lines(robotui))

    def shown():
        """A line comes each second: a short outage may lie between two of them, and then there is another one."""
        network.outage(seconds)
        with contextlib.suppress(AssertionError):
            return wait_for(lambda: any(line["age_s"] > 0.5 for line in lines_since(robotui, before, "odom")), seconds=seconds + 5)
        return False
    wait_for(shown, what="the outage to be shown")
    comes(robotui)
    return lines_since(robotui, before, "odom")


def test_a_robot_behind_a_bad_network_is_followed_through_its_outages(network, robot):      # noqa: F811
    robotui = start_robotui(network.workbench, "run", "--json", "ros")
    comes(robotui)
    network.impair(DELAY, LOSS)
    before = len(json_lines(robotui))
    wait_for(lambda: len(lines_since(robotui, before, "odom")) > 5, what="some seconds on the bad network")
    assert {line["link"] for line in json_lines(robotui)[before:]} == {"connected"}
    comes(robotui)

    for _ in range(3):
        lines = shown_outage(robotui, network, 1.0)
        assert {line["link"] for line in lines} == {"connected"}, f"a second's outage costs no link: {robotui.err.read_text()[-600:]}"

    # The second answer of the master that does not come is said: by 8 s, and for a second at least.
    lines = shown_outage(robotui, network, 12.0)
    assert "degraded" in {line["link"] for line in lines}, "a long outage is said of the link"
    assert lines[-1]["link"] == "connected"
    carried, lost = network.counts()
    assert lost > 0.01 * carried, (carried, lost)
    assert all(line["dropped"] == 0 for line in json_lines(robotui)), "nothing is dropped on our side"


# ---- driving ----------------------------------------------------------------------------------------------------------


def hear(machine, name):
    process = machine.start_tool("/usr/bin/python3", str(HEAR), name=name)
    wait_for(lambda: "ready" in process.out.read_text(), what=name)
    return process


def heard_by(process):
    lines = process.out.read_text().splitlines(keepends=True)
    return [message for message in map(json.loads, (line for line in lines if line.endswith("\n"))) if "at" in message]


def moves(message):
    return message["linear"] != 0 or message["angular"] != 0


def same(one, other):
    return one["linear"] == other["linear"] and one["angular"] == other["angular"]


def changes(messages):
    """The commands that move, each once where it was said several times: with the time when it was said last."""
    found = []
    for message in filter(moves, messages):
        if found and same(found[-1], message):
            found.pop()
        found.append(message)
    return found


def pairs(heard, sent):
    """When each command that moves was sent and heard: what is heard is what was sent, in its order, with gaps but nothing twice."""
    found, start, again = [], 0, 0
    sent = changes(sent)
    for message in changes(heard):
        match = next((i for i in range(start, len(sent)) if same(sent[i], message)), None)
        if match is not None:
            start = match + 1
            found.append((sent[match]["at"], message["at"]))
        else:
            # One that our own listener was too slow for is no command played again.
            again += any(same(earlier, message) for earlier in sent[:start])
    # Two commands may be alike by chance.
    assert again <= 2, f"{again} commands were heard again after others"
    assert len(found) > len(changes(heard)) / 2, "what was heard is not what was sent"
    return found


def sweep(window, middle, enough, what):
    """Moves the stick so that hardly two commands are alike, until it is enough."""
    end = time.monotonic() + PATIENCE
    while not enough():
        now = time.monotonic()
        assert now < end, f"waited {PATIENCE} s for {what}"
        window.move((middle[0] + int(50 * math.sin(now * 1.3)), middle[1] - int(25 + 25 * math.cos(now * 1.7))))
        time.sleep(0.03)                # a hand's pace


def passed(seconds):
    end = time.monotonic() + seconds
    return lambda: time.monotonic() > end


@pytest.mark.skipif(bool(missing()), reason=f"tests in a window need {missing()}")
def test_commands_of_an_outage_are_not_played_again_after_it(network, robot):      # noqa: F811
    heard, sent = hear(robot, "heard"), hear(network.workbench, "sent")
    motion = Motion(robot)
    window = Window(start_robotui(network.workbench, "run", "ros", name="window", display=True))
    wait_for(window.is_live, seconds=PATIENCE, what="a live robot")
    middle = wait_for(window.stick, seconds=PATIENCE, what="the stick")
    window.click(middle)
    network.impair(DELAY, LOSS)
    hand = Keys()
    hand.grip()
    try:
        sweep(window, middle, lambda: not motion.stands(5), "motion")
        sweep(window, middle, passed(2), "commands before the outage")
        network.cut()
        sweep(window, middle, passed(SHORT), "the outage")
        first = network.mend()
        sweep(window, middle, lambda: any(m["at"] > first and moves(m) for m in heard_by(heard)), "commands after an outage")
        sweep(window, middle, lambda: not motion.stands(5), "motion after an outage")

        network.cut()
        sweep(window, middle, passed(LONG), "the long outage")
    finally:
        hand.let_go()
    wait_for(lambda: not moves(heard_by(sent)[-1]), seconds=PATIENCE, what="the stop to be sent")
    second = network.mend()
    wait_for(lambda: any(m["at"] > second and not moves(m) for m in heard_by(heard)), seconds=PATIENCE, what="the stop after the outage")
    wait_for(motion.stands, seconds=PATIENCE, what="standstill")

    times = pairs(heard_by(heard), heard_by(sent))
    for end in (first, second):
        old = [round(end - said, 2) for said, came in times if said < end - OLD and came > end]
        assert len(old) <= ON_ITS_WAY, f"commands played again after an outage: sent {old} s before its end"
    fastest = max(abs(m["linear"]) for m in heard_by(sent))
    assert way(motion, second) < fastest * (HOLDS + DELIVERED), "what was late moved it for longer than a packet and its answer take"
    assert not moves(heard_by(heard)[-1])


def way(motion, since):
    """How far it went from a moment on."""
    places = [(x, y) for stamp, x, y, _, _ in motion.rows() if stamp * 1e-9 > since]
    return sum(math.dist(a, b) for a, b in zip(places, places[1:]))
