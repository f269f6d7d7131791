"""That the workbench changes nothing at robots that speak LCM, by multicast and by LCM's own server, which writes to its clients one after the other.

Each case is recorded without, with and after the workbench; the record stays in target/side-effects-lcm-CASE.json.
"""
import pathlib
import random
import signal
import time

import pytest

from conftest import Robot, end, free_port, java, needs_long, start_robotui, wait_for
from network import network    # noqa: F401 (a fixture)
from side_effects import SPEED, Stopped, Witness, closed, comes_back, ended, guards_of, keep, longest_gap, same_rhythm, same_steps, shows

PEER = str(pathlib.Path(__file__).parent / "peers" / "lcm_robot.py")
JAR = pathlib.Path("/usr/share/java/lcm.jar")
needs_lcm = pytest.mark.skipif(not JAR.exists(), reason="LCM's server is not installed (liblcm-java)")
PERIOD = 0.05
SECONDS = 5
STOPPED = 8
HELD_UP = 1.0
OUTAGE = "through an outage"
FAST = 100_000      # bytes of a scan, twenty times a second


class Bus:
    """A robot that another program drives, and somebody who listens to all."""

    def __init__(self, machine, url, scan_bytes=3000):
        self.machine, self.url = machine, url
        self.robot = self._start("robot", "--scan-bytes", str(scan_bytes))
        self._start("driver", "--drive")
        self.witness = Witness(self._start("witness", "--hear"))
        wait_for(lambda: any(line.get("linear") == SPEED for line in self.witness.lines()), what="the robot to be driven")

    def _start(self, name, *arguments):
        return self.machine.start_tool("/usr/bin/python3", PEER, self.url, *arguments, name=name)

    def phase(self, name, seconds=SECONDS):
        phase = self.witness.phase(name, seconds)
        return phase | {"channels": sorted({line["channel"] for line in phase["heard"]})}


def multicast(processes, environment):
    return Bus(Robot(processes, "", environment), f"udpm://239.255.76.67:{random.randint(20000, 30000)}?ttl=0")


def start_server(machine, host="127.0.0.1"):
    """LCM's own server. It listens on all addresses, so it has a network of its own."""
    port = free_port()
    machine.start_tool(java(), "-cp", str(JAR), "lcm.lcm.TCPService", str(port), name="server")
    wait_for(lambda: reached(machine, host, port), what="LCM's server")
    return f"tcpq://{host}:{port}"


def reached(machine, host, port):
    try:
        machine.tool("/usr/bin/python3", "-c", f"import socket; socket.create_connection(('{host}', {port}))")
    except AssertionError:
        return False
    return True


def workbench(bus, guard=None, machine=None):
    machine = machine or bus.machine
    config = machine.processes.folder / "lcm-side.yaml"
    config.write_text("ruics:\n  Robot:\n    type: mobilebase\n    rfics:\n"
                      f"      base: {{type: lcm, url: \"{bus.url}\"{'' if guard is None else f', guard: {str(guard).lower()}'}}}\n")
    started = start_robotui(machine, "run", "--json", str(config))
    for port in ("POSE", "SCAN"):
        wait_for(lambda: shows(started, port, 10), seconds=90, what=f"{port} in the workbench")
    return started


def unharmed(phases):
    for phase in phases:
        same_rhythm(phase, phases[0])
        same_steps(phase, SPEED * PERIOD)
        assert phase["channels"] == ["DRIVE", "POSE", "SCAN"], "somebody else spoke"


def test_nothing_changes_by_multicast(processes, environment):
    bus = multicast(processes, environment)
    phases = [bus.phase("without")]
    started = workbench(bus)
    phases.append(bus.phase("with"))
    with Stopped(started):
        phases.append(bus.phase("while it is stopped", STOPPED))
    comes_back(started, "POSE", 10)
    closed(started)
    phases.append(bus.phase("after"))
    end(workbench(bus), how=signal.SIGKILL)
    phases.append(bus.phase("after a kill"))
    keep("lcm-multicast", phases)
    unharmed(phases)


@needs_lcm
@needs_long
@pytest.mark.parametrize("guard", [False, True])
def test_nothing_changes_at_a_server_nor_on_a_bad_link_to_it(network, guard):      # noqa: F811
    url = start_server(network.robot, network.robot.address)
    bus = Bus(network.robot, url)
    phases = [bus.phase("without")]
    started = workbench(bus, guard, network.workbench)
    phases.append(bus.phase("with"))
    network.impair(0.05, 0.02)
    phases.append(bus.phase("on a bad link"))
    network.outage(2)
    phases.append(bus.phase(OUTAGE))
    network.impair(0, 0)
    closed(started)
    phases.append(bus.phase("after"))
    again = workbench(bus, guard, network.workbench)
    guards = guards_of(again)
    assert len(guards) == guard
    end(again, how=signal.SIGKILL)
    phases.append(bus.phase("after a kill"))
    wait_for(lambda: ended(guards), seconds=10, what="the end of the guard")
    keep(f"lcm-server-{'guarded' if guard else 'plain'}", phases)
    # LCM's server waits for its clients, and so for the network between: no guard on our side of it can help. That is measured alone.
    unharmed([phase for phase in phases if phase["name"] != OUTAGE])
    for phase in phases:
        same_steps(phase, SPEED * PERIOD)


@needs_lcm
@pytest.mark.parametrize("guard", [pytest.param(False, marks=needs_long), True])
def test_a_stopped_workbench_holds_a_server_up_unless_it_has_a_guard(network, guard):      # noqa: F811
    url = start_server(network.robot, network.robot.address)
    bus = Bus(network.robot, url, FAST)
    phases = [bus.phase("without")]
    started = workbench(bus, guard, network.workbench)
    begin = time.time()
    with Stopped(started):
        time.sleep(STOPPED)                     # nothing tells when a robot goes on not to be heard
    comes_back(started, "POSE", 10)
    phases.append(bus.phase("after its return"))
    held_up = longest_gap(bus.witness, begin)
    phases.append({"name": "while it is stopped", "heard": [], "longest": held_up})
    closed(started)
    keep(f"lcm-stopped-{'guarded' if guard else 'plain'}", phases)
    assert held_up < HELD_UP if guard else held_up > HELD_UP, held_up
