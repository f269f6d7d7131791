"""./robotui record writes what robots of several frameworks send, and stock readers decode it; also where it is killed."""
import json
import os
import pathlib
import signal
import subprocess

import pytest

from conftest import ROOT, await_end, json_lines, kill_all_of, tell, wait_for

PYTHON = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "none")) / "recordings/bin/python"
DECODER = ROOT / "tests/e2e/peers/recording_decoder.py"

pytestmark = pytest.mark.skipif(not PYTHON.exists(), reason="there are no readers of recordings from PyPI (ROBOTUI_ROS2_PEERS)")

ROBOTS = """
simulator: [{robot: natalie, speaks: ros2}, {robot: keira, speaks: player}, {robot: natalie, speaks: lcm}]
ruics:
  Natalie:
    type: mobilebase
    rfics: {base: {type: ros2}}
  Keira:
    type: mobilebase
    rfics: {base: {type: player}}
  Nora:
    type: mobilebase
    rfics:
      base:
        type: lcm
        url: "${LCM_DEFAULT_URL:-udpm://239.255.76.67:7667?ttl=0}"
        types: %s
        channels: {ODOMETRY: {as: odometry, type: robotui.odometry_t}, TRANSFORMS: {as: transforms, type: robotui.transforms_t}}
"""


def test_robots_of_three_frameworks_are_in_one_file(processes, environment, tmp_path):
    config = tmp_path / "robots.yaml"
    config.write_text(ROBOTS % (ROOT / "configs/lcm/types"), encoding="utf-8")
    file = tmp_path / "run.mcap"

    recording = record(processes, environment, config, file)
    wait_for(lambda: last(recording).get("messages", 0) > 2500 and last(recording)["channels"] > 30, what="three robots")
    tell(recording, signal.SIGINT)
    await_end(recording)

    assert recording.returncode == 130, recording.err.read_text()
    ended = last(recording)
    assert (ended["ended"], ended["problem"], ended["dropped"]) == (1, "", 0)
    decoded = decode(file)
    topics = decoded["topics"]
    assert sum(topic["count"] for topic in topics.values()) == ended["messages"]
    assert (topics["/odom"]["type"], topics["/odom"]["encoding"]) == ("nav_msgs/msg/Odometry", "cdr")
    assert topics["/odom"]["metadata"]["robotui.ui"] == "Natalie" and topics["/odom"]["metadata"]["robotui.framework"] == "ros2"
    assert topics["/tf"]["type"] == topics["/tf_static"]["type"] == "tf2_msgs/msg/TFMessage"
    for name in "/odom", "/scan", "/imu/data", "/tf":         # nothing is lost between the first and the last one
        assert topics[name]["missing"] <= 0.02 * topics[name]["count"], (name, topics[name])
    assert topics["position2d:0"]["encoding"] == "player" and topics["position2d:0"]["metadata"]["robotui.ui"] == "Keira"
    assert topics["ODOMETRY"]["encoding"] == "lcm" and decoded["schemas"]["robotui.odometry_t"] == "lcm"
    links = {event["ui"] for event in topics["/robotui/events"]["values"] if event["event"] == "link" and event["value"] == "connected"}
    assert links == {"Natalie", "Keira", "Nora"}
    assert decoded["attachments"] == ["robots.yaml"]


def test_a_recording_that_is_killed_becomes_whole(processes, environment, tmp_path):
    file, whole = tmp_path / "killed.mcap", tmp_path / "whole.mcap"
    recording = record(processes, environment, "ros2-demo", file, "--ports", "odom", "--ports", "scan", "--ports", "tf")
    wait_for(lambda: last(recording).get("channels", 0) >= 5, what="all topics, and what RobotUI says itself")
    begun = last(recording)["seconds"]
    wait_for(lambda: last(recording)["messages"] > 200 and last(recording)["seconds"] > begun + 2, what="more than may be lost of each")
    told = [line for line in json_lines(recording)]
    kill_all_of(recording)

    log("check", file, code=1)
    log("repair", file, whole)
    log("check", whole)
    topics = decode(whole)["topics"]
    assert {"/odom", "/scan", "/tf", "/tf_static", "/robotui/events"} == set(topics)
    a_second_before = told[-2]["messages"] if len(told) > 1 else 0
    assert sum(topic["count"] for topic in topics.values()) >= a_second_before


def test_a_place_that_cannot_be_written_is_told_at_once(environment, tmp_path):
    answer = subprocess.run([ROOT / "robotui", "record", "ros2", "--out", tmp_path / "no/run.mcap"], capture_output=True, text=True, timeout=60,
                            env=environment, check=False)

    assert answer.returncode == 6, answer.stdout + answer.stderr
    assert f"the folder {tmp_path}/no is not there; make it, or choose another one" in answer.stderr


def record(processes, environment, config, file, *options):
    return processes.start([ROOT / "robotui", "record", config, "--out", file, "--json", *options], "record", environment)


def last(recording):
    lines = json_lines(recording)
    return lines[-1] if lines else {}


def decode(file):
    answer = subprocess.run([PYTHON, DECODER, file], capture_output=True, text=True, timeout=60, check=False)
    assert answer.returncode == 0, answer.stderr
    return json.loads(answer.stdout)


def log(*arguments, code=0):
    answer = subprocess.run([ROOT / "robotui", "log", *map(str, arguments)], capture_output=True, text=True, timeout=60, check=False)
    assert answer.returncode == code, answer.stdout + answer.stderr
