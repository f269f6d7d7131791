"""Simulated robots of different frameworks, started by ./robotui from a configuration, and stock tools beside them."""
import re
import shutil
import subprocess

import pytest

from conftest import NO_DISPLAY, ROOT, end, json_lines, wait_for

NATALIE = {"scan": 10, "odom": 10, "sonar": 5, "camera/image_raw": 4}
KEIRA = {"laser:0": 5, "position2d:0": 10, "power:0": 0.2, "bumper:0": 5, "localize:0": 2}


def start(processes, environment, *arguments, name="robotui"):
    surroundings = {key: value for key, value in environment.items() if key not in NO_DISPLAY}
    return processes.start([ROOT / "robotui", *arguments], name, surroundings)


def live(process, ruic, port, least):
    """The newest line about a port, if it is fast enough."""
    lines = [line for line in json_lines(process) if line["ruic"] == ruic and line["port"].split(".", 1)[1] == port]
    return lines[-1] if lines and lines[-1]["rate_hz"] >= least and lines[-1]["link"] == "connected" else None


def test_three_robots_of_different_frameworks_are_live_in_one_workbench(processes, environment):
    robotui = start(processes, environment, "run", "--json", "natalie-keira")

    for ruic, ports in (("Natalie", NATALIE), ("Keira", KEIRA), ("Nora", NATALIE)):
        for port, least in ports.items():
            line = wait_for(lambda: live(robotui, ruic, port, least), seconds=90, what=f"{port} of {ruic} at {least} Hz")
            assert line["dropped"] == 0
    said = robotui.err.read_text()
    assert re.search(r"export ROS_DOMAIN_ID=\d+ ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST", said)
    assert re.search(r"export ROS_MASTER_URI=http://127\.0\.0\.1:\d+ ROS_IP=127\.0\.0\.1", said)
    assert re.search(r"export PLAYER_HOST=127\.0\.0\.1 PLAYER_PORT=\d+", said)


@pytest.mark.skipif(shutil.which("lcm-logger") is None, reason="lcm-logger is not installed (liblcm-bin)")
def test_the_stock_logger_records_a_robot_that_a_configuration_starts(processes, environment, tmp_path):
    config = tmp_path / "keira.yaml"
    config.write_text("simulator:\n  - {robot: keira, speaks: [player, lcm]}   # two faces\n" + "ruics:\n  Keira:\n    type: mobilebase\n"
                      "    rfics:\n      base: player\n")
    robotui = start(processes, environment, "run", "--json", str(config))
    wait_for(lambda: live(robotui, "Keira", "position2d:0", 5), seconds=90, what="the robot")
    url = re.search(r"export LCM_DEFAULT_URL='([^']+)'", robotui.err.read_text()).group(1)
    assert url.startswith("udpm://239.") and url.endswith("?ttl=0")

    logger = processes.start(["lcm-logger", f"--lcm-url={url}", str(tmp_path / "log")], "logger", environment)
    data = wait_for(lambda: recorded(tmp_path / "log", (b"LASER", b"ODOMETRY", b"CAMERA", b"BUMPER", b"MAP")), what="all channels")
    end(logger)
    assert b"SONAR" not in data


def recorded(log, channels):
    data = log.read_bytes() if log.exists() else b""
    return data if all(channel in data for channel in channels) else None


@pytest.mark.parametrize("wrong", ["roomba", "{robot: otto}", "{robot: keira, speaks: corba}", "{robot: keira, speaks: player, domain: 3}", "[mobile-base, {robot keira}]"])
def test_a_wrong_simulator_is_named(environment, tmp_path, wrong):
    config = tmp_path / "wrong.yaml"
    config.write_text(f"simulator: {wrong}\nruics: {{}}\n")
    result = subprocess.run([ROOT / "robotui", "run", "--json", str(config)], env=environment, capture_output=True, text=True, timeout=60, check=False)
    assert result.returncode == 2
    assert "wrong.yaml: 'simulator' has" in result.stderr and "{robot: natalie or keira, speaks: ros, ros2, player, lcm, carmen, yarp, smartsoft, roblets or roboframe}" in result.stderr
