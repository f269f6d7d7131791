"""A robot interface is exchanged while the product runs: by its file, which is watched."""
import time

import pytest

from conftest import busy, free_port, json_lines, start_robotui, start_simulator, wait_for

CONFIG = """\
ruics:
  Natalie:
    rfics:
      base: {{type: {type}, master: "{master}"}}
    uics:
      text:
"""


@pytest.fixture
def second(processes, environment, ros_tools):
    return start_simulator(processes, environment, 0, "second")


@pytest.fixture
def watched(simulator, tmp_path):
    """The product on the first robot, with a file that is watched."""
    file = tmp_path / "natalie.yaml"
    file.write_text(CONFIG.format(type="ros", master=simulator.uri))
    process = start_robotui(simulator, "run", "--json", "--watch", file)
    process.file = file
    wait_for(lambda: is_live(process), seconds=60, what="the first robot")
    return process


def is_live(process):
    return any(line["port"] == "base.odom" and line["rate_hz"] > 5 for line in json_lines(process)[-60:])


def write(process, **words):
    process.file.write_text(CONFIG.format(**words))


def test_another_master_takes_the_place_while_it_runs(watched, simulator, second):
    write(watched, type="ros", master=second.uri)
    at = time.monotonic()

    wait_for(lambda: "Natalie.base as ros: exchanged" in watched.err.read_text(), what="the exchange")

    assert time.monotonic() - at < 15 * busy()
    wait_for(lambda: any("robotui" in node for node in second.nodes()), what="our node at the second master")
    wait_for(lambda: not any("robotui" in node for node in simulator.nodes()), what="our node to leave the first master")
    wait_for(lambda: is_live(watched), what="the second robot")
    assert len({line["ruic"] for line in json_lines(watched)}) == 1


def test_a_robot_that_does_not_answer_is_said_and_the_running_one_goes_on(watched, simulator):
    before = len(json_lines(watched))
    write(watched, type="ros", master=f"http://127.0.0.1:{free_port()}")

    wait_for(lambda: "what runs goes on as it was" in watched.err.read_text(), seconds=90, what="the refusal")

    assert "not exchanged: base is not connected yet" in watched.err.read_text()
    assert any("robotui" in node for node in simulator.nodes())
    wait_for(lambda: len(json_lines(watched)) > before + 30 and is_live(watched), what="the first robot to go on")


def test_mistakes_are_said_with_their_place_within_two_seconds(watched):
    write(watched, type="rso", master="http://127.0.0.1:1")
    at = time.monotonic()

    wait_for(lambda: "natalie.yaml:4:" in watched.err.read_text(), what="the mistake")

    assert time.monotonic() - at < 2.5 * busy()
    watched.file.write_text("ruics: [")
    wait_for(lambda: "this is no YAML" in watched.err.read_text(), what="the broken file")
    wait_for(lambda: is_live(watched), what="the robot to go on")
