"""That the workbench changes nothing at a robot behind a Player server, also at one that writes to its clients one after the other.

Each case is recorded without, with and after the workbench; the record stays in target/side-effects-player-CASE.json.
"""
import json
import os
import pathlib
import signal
import time

import pytest

from conftest import Robot, end, needs_long, start_robotui, wait_for
from network import network    # noqa: F401 (a fixture)
from side_effects import SPEED, Stopped, Witness, closed, comes_back, ended, guards_of, keep, longest_gap, same_rhythm, same_steps, shows

PEERS = pathlib.Path(__file__).parent / "peers"
PERIOD = 0.05
SECONDS = 5
STOPPED = 8
HELD_UP = 1.0
OURS = 3            # the robot's third client, after its driver and the witness


class Server:
    """A robot behind a server that does everything in one loop, its driver, and somebody who listens."""

    def __init__(self, robot, host="127.0.0.1"):
        self.robot, self.host = robot, host
        self.process = robot.start_tool("/usr/bin/python3", str(PEERS / "player_robot.py"), "--host", host, name="robot")
        self.port = wait_for(lambda: self.events("port"), what="the robot's port")[0]["port"]
        client = ("/usr/bin/python3", str(PEERS / "player_client.py"), host, str(self.port))
        robot.start_tool(*client, "--drive", name="driver")
        wait_for(lambda: self.events("command"), what="the robot to be driven")
        self.witness = Witness(robot.start_tool(*client, name="witness"))
        wait_for(lambda: any(line.get("linear") == SPEED for line in self.witness.lines()), what="the witness")

    def events(self, kind):
        lines = self.process.out.read_text().splitlines(keepends=True)
        return [event for event in map(json.loads, (line for line in lines if line.endswith("\n"))) if event["event"] == kind]

    def phase(self, name, seconds=SECONDS):
        return self.witness.phase(name, seconds, open=self.opened())

    def opened(self):
        """What each client has open, and who is there."""
        gone = {event["client"] for event in self.events("gone")}
        return sorted([event["client"], event["device"]] for event in self.events("open") if event["client"] not in gone)

    def commanded_by_others_alone(self):
        assert {event["client"] for event in self.events("command")} == {1}


@pytest.fixture
def server(processes, environment):
    made = Server(Robot(processes, "", environment))
    return made


def workbench(server, guard, machine=None, devices=("position2d:0", "laser:0", "camera:0")):
    machine = machine or server.robot
    config = machine.processes.folder / f"player-{guard}.yaml"
    config.write_text("ruics:\n  Robot:\n    type: mobilebase\n    rfics:\n"
                      f"      base: {{type: player, host: {server.host}, port: {server.port}, guard: {str(guard).lower()}, "
                      f"devices: {json.dumps(devices)}}}\n")
    started = start_robotui(machine, "run", "--json", str(config))
    for port in devices:
        wait_for(lambda: shows(started, port, 4), seconds=90, what=f"{port} in the workbench")
    return started


def unharmed(server, phases):
    for phase in phases:
        same_rhythm(phase, phases[0])
        same_steps(phase, SPEED * PERIOD)
    server.commanded_by_others_alone()


def ours(server):
    return [entry for entry in server.opened() if entry[0] >= OURS]


@pytest.mark.parametrize("guard", [False, True])
def test_nothing_changes_while_the_workbench_runs_nor_when_it_is_closed(server, guard):
    phases = [server.phase("without")]
    started = workbench(server, guard)
    phases.append(server.phase("with"))
    assert ours(server)
    guards = guards_of(started)
    assert len(guards) == guard

    closed(started)
    wait_for(lambda: not ours(server), seconds=10, what="the end of our connection")
    phases.append(server.phase("after"))
    assert ended(guards), "a guard is left"
    keep(f"player-closed-{'guarded' if guard else 'plain'}", phases)
    unharmed(server, phases)
    assert phases[-1]["open"] == phases[0]["open"]


@pytest.mark.parametrize("guard", [False, True])
def test_a_killed_workbench_is_gone_at_once(server, guard):
    phases = [server.phase("without")]
    started = workbench(server, guard)
    guards = guards_of(started)
    end(started, how=signal.SIGKILL)
    wait_for(lambda: not ours(server), seconds=10, what="the end of our connection")
    phases.append(server.phase("after the kill"))
    assert ended(guards), "a guard is left"
    keep(f"player-killed-{'guarded' if guard else 'plain'}", phases)
    unharmed(server, phases)


def test_a_stopped_workbench_with_a_guard_holds_nobody_up(server):
    phases = [server.phase("without")]
    started = workbench(server, True)
    with Stopped(started):
        phases.append(server.phase("while it is stopped", STOPPED))
        assert not ours(server), "the guard closed our connection"
    comes_back(started, "position2d:0", 10)
    phases.append(server.phase("after its return"))
    closed(started)
    keep("player-stopped-guarded", phases)
    unharmed(server, phases)


@needs_long
def test_without_a_guard_a_stopped_workbench_holds_up_a_server_that_waits_for_it(server):
    """What the guard is for: this is measured, and stands in docs/side-effects.md."""
    phases = [server.phase("without")]
    started = workbench(server, False)
    begin = time.time()
    with Stopped(started):
        time.sleep(STOPPED)                     # nothing tells when a robot goes on not to move
    phases.append(server.phase("after its return"))
    phases.append({"name": "while it is stopped", "heard": [], "longest": longest_gap(server.witness, begin)})
    closed(started)
    keep("player-stopped-plain", phases)
    assert phases[-1]["longest"] > HELD_UP
    server.commanded_by_others_alone()


def test_a_killed_guard_costs_one_connection(server):
    phases = [server.phase("without")]
    started = workbench(server, True)
    first, = guards_of(started)
    os.kill(first, signal.SIGKILL)
    second, = wait_for(lambda: guards_of(started) - {first}, what="the next guard")
    comes_back(started, "position2d:0", 10)
    phases.append(server.phase("with the next guard"))
    closed(started)
    wait_for(lambda: ended({second}), what="the end of the guard")
    keep("player-guard-killed", phases)
    unharmed(server, phases)


@needs_long
@pytest.mark.parametrize("guard", [False, True])
def test_a_bad_link_to_the_workbench_changes_nothing_where_little_is_sent(network, guard):      # noqa: F811
    """The odometry alone: what a laser scanner sends in an outage and until TCP tries again fills the buffer of the server's kernel."""
    server = Server(network.robot, host=network.robot.address)
    phases = [server.phase("without")]
    started = workbench(server, guard, network.workbench, devices=("position2d:0",))
    network.impair(0.05, 0.02)
    phases.append(server.phase("on a bad link"))
    network.outage(3)
    phases.append(server.phase("through an outage"))
    closed(started)
    keep(f"player-link-{'guarded' if guard else 'plain'}", phases)
    unharmed(server, phases)
