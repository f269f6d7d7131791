"""What a guard does for a ROS robot: registrations end with a workbench that is killed or stopped, and nobody waits for it.

Each case is recorded; the record stays in target/side-effects-CASE.json.
"""
import signal
import time

import pytest

from conftest import end, last_of, needs_long, wait_for
from network import network    # noqa: F401 (a fixture)
from ros_graph import RATE, headless, make_far_graph, make_graph, unharmed
from side_effects import Stopped, closed, comes_back, ended, guards_of, keep, longest_gap

STOPPED = 8
HELD_UP = 1.0


def workbench(graph, guard, machine=None):
    config = graph.ros.processes.folder / f"ros-{guard}.yaml"
    config.write_text(f"ruics:\n  Robot:\n    type: mobilebase\n    rfics:\n      base: {{type: ros, guard: {str(guard).lower()}}}\n")
    return headless(graph, config=str(config), machine=machine)


def test_a_guard_changes_nothing_and_says_farewell_for_a_workbench_that_is_killed(roscore):
    graph = make_graph(roscore)
    phases = [graph.phase("without")]
    started = workbench(graph, True)
    guards = guards_of(started)
    assert len(guards) == 1
    phases.append(graph.phase("with"))
    end(started, how=signal.SIGKILL)
    wait_for(lambda: not graph.ours(), seconds=10, what="the farewells")
    phases.append(graph.phase("after the kill"))
    assert ended(guards), "a guard is left"
    keep("killed-guarded", phases)
    unharmed(phases)
    assert phases[-1]["state"] == phases[0]["state"]


def test_a_stopped_workbench_with_a_guard_is_not_registered_and_comes_back(roscore):
    graph = make_graph(roscore)
    phases = [graph.phase("without")]
    started = workbench(graph, True)
    guards = guards_of(started)
    with Stopped(started):
        wait_for(lambda: not graph.ours(), seconds=20, what="the farewells")
        phases.append(graph.phase("while it is stopped"))
        assert phases[-1]["state"] == phases[0]["state"]
    comes_back(started, "odom", RATE / 2)
    wait_for(graph.ours, what="its registrations")
    phases.append(graph.phase("after its return"))
    closed(started)
    wait_for(lambda: not graph.ours(), seconds=10, what="the end of our registrations")
    phases.append(graph.phase("after"))
    assert ended(guards), "a guard is left"
    keep("stopped-guarded", phases)
    unharmed(phases)


@pytest.mark.parametrize("guard", [pytest.param(False, marks=needs_long), True])
def test_a_stopped_workbench_holds_up_a_rospy_robot_without_queues_unless_it_has_a_guard(roscore, guard):
    graph = make_graph(roscore, "--no-queues")
    phases = [graph.phase("without")]
    started = workbench(graph, guard)
    wait_for(lambda: (line := last_of(started, "image")) and line["rate_hz"] > RATE / 2, seconds=60, what="pictures in the workbench")
    begin = time.time()
    with Stopped(started):
        time.sleep(STOPPED)                     # nothing tells when a robot goes on not to be heard
    comes_back(started, "odom", RATE / 2)
    phases.append(graph.phase("after its return"))
    held_up = longest_gap(graph.witness, begin)
    phases.append({"name": "while it is stopped", "heard": [], "longest": held_up})
    closed(started)
    keep(f"no-queues-stopped-{'guarded' if guard else 'plain'}", phases)
    assert held_up < HELD_UP if guard else held_up > HELD_UP, held_up


@needs_long
@pytest.mark.parametrize("guard", [False, True])
def test_a_bad_link_to_the_workbench_changes_nothing(network, ros_tools, guard):      # noqa: F811
    graph = make_far_graph(network)
    phases = [graph.phase("without")]
    started = workbench(graph, guard, network.workbench)
    guards = guards_of(started)
    assert len(guards) == guard
    phases.append(graph.phase("with"))
    network.impair(0.05, 0.02)
    carried, lost = network.counts()
    phases.append(graph.phase("on a bad link"))
    network.outage(3)
    phases.append(graph.phase("through an outage"))
    network.impair(0, 0)
    now_carried, now_lost = network.counts()
    assert now_carried > carried and now_lost > lost, "nothing went over the bad link"
    comes_back(started, "odom", RATE / 2)
    phases.append(graph.phase("after the bad link"))
    closed(started)
    wait_for(lambda: not graph.ours(), seconds=10, what="the end of our registrations")
    phases.append(graph.phase("after"))
    assert ended(guards), "a guard is left"
    keep(f"link-{'guarded' if guard else 'plain'}", phases)
    unharmed(phases)
    assert phases[-1]["state"] == phases[0]["state"]
