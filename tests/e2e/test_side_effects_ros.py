"""That the workbench changes nothing at a ROS robot: what an independent listener hears, how the robot moves, what the master knows.

Each case is recorded without, with and after the workbench; the record stays in target/side-effects-CASE.json.
"""
import os
import signal

import pytest

from conftest import end, last_of, start_robotui, wait_for
from desktop import Window, missing
from ros_graph import RATE, headless, make_graph, unharmed
from side_effects import keep


@pytest.fixture
def graph(roscore):
    return make_graph(roscore)


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
    workbench.wait(60)
    wait_for(lambda: not graph.ours(), seconds=10, what="the end of our registrations")
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
    wait_for(lambda: not graph.ours(), seconds=10, what="the end of our registrations")
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
    wait_for(lambda: not graph.ours(), seconds=10, what="the end of our registrations")
    phases.append(graph.phase("after"))

    keep("stopped", phases)
    unharmed(phases)
    assert phases[-1]["state"] == phases[0]["state"]
