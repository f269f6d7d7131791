"""A simulated robot of each framework that has no stock tools here, started by ./robotui from its configuration."""
import re

import pytest

from conftest import NO_DISPLAY, ROOT, json_lines, wait_for

DEMOS = {
    "boat": ({"gps/position": 3, "compass/heading": 5, "log/motion": 10, "helm/order": 5, "body": 2}, r"export ROBLETS_BRAIN=127\.0\.0\.1:\d+"),
    "carmen-demo": ({"base_odometry": 10, "robot_frontlaser": 10, "base_sonar": 5, "localize_globalpos": 2}, r"export CENTRALHOST=127\.0\.0\.1:\d+"),
    "roboframe-demo": ({"odometry": 10, "laser/scan": 10, "localisation/pose": 5}, r"export ROBOFRAME_ADDR=127\.0\.0\.1:\d+"),
    "smartsoft-demo": ({"base/baseState": 10, "laser/laserScan": 10, "base/baseState/pose": 10}, r"export SMART_NS_ADDR=127\.0\.0\.1:\d+"),
    "yarp-demo": ({"odo/odometry": 10, "laser": 10, "imu/measures": 10, "localization/streaming": 5}, r"yarp conf 127\.0\.0\.1 \d+"),
}


def live(process, port, least):
    """The newest line about a port, if it is fast enough."""
    lines = [line for line in json_lines(process) if line["port"].split(".", 1)[1] == port]
    return lines[-1] if lines and lines[-1]["rate_hz"] >= least and lines[-1]["link"] == "connected" else None


@pytest.mark.parametrize("demo", DEMOS)
def test_the_demo_is_live_and_says_where(processes, environment, demo):
    ports, address = DEMOS[demo]
    surroundings = {key: value for key, value in environment.items() if key not in NO_DISPLAY}
    robotui = processes.start([ROOT / "robotui", "run", "--json", demo], "robotui", surroundings)

    for port, least in ports.items():
        line = wait_for(lambda: live(robotui, port, least), seconds=90, what=f"{port} at {least} Hz")
        assert line["dropped"] == 0
    assert re.search(address, robotui.err.read_text())


# Turning moves nobody away; a robot that is slow to begin is told again, as a stick would do it.
TEAM = """
use("Team");
const names = ["natalie", "keira", "ruth", "lena", "carl", "yuki", "sam"];
const port = (kind, type, name) => ports().filter(p => p.kind === kind && p.type === type).map(p => p.name).find(p => p.startsWith(name + "."));
const found = () => names.map(n => ({odometry: port("stream", "Odometry", n), velocity: port("command", "VelocityCommand", n)}));
const all = waitFor(() => { const f = found(); return f.every(r => r.odometry && r.velocity) ? f : null; }, 120);
robots().filter(r => r.ui === "Team").forEach(r => takeControl(r.name));
const obeys = (robot, seconds) => { try { send(robot.velocity, {angular: {z: 0.5}}, seconds); return true; } catch (e) { return false; } };
const speed = robot => { try { return Math.abs(value(robot.odometry).angular.z); } catch (e) { return NaN; } };
waitFor(() => { all.forEach(r => obeys(r, 2)); return all.every(r => speed(r) > 0.2); }, 120);
print("all turn");
stop();
waitFor(() => all.every(r => speed(r) < 0.01), 60);
print("all stand");
print("commands taken: " + all.filter(r => obeys(r, 0.5)).length);
"""


def test_one_stop_halts_a_team_of_seven_frameworks(processes, environment, tmp_path):
    script = tmp_path / "team.js"
    script.write_text(TEAM, encoding="ascii")
    surroundings = {key: value for key, value in environment.items() if key not in NO_DISPLAY}
    robotui = processes.start([ROOT / "robotui", "run", "--text", "frameworks", "--script", script], "robotui", surroundings)

    robotui.wait(400)

    assert robotui.out.read_text().splitlines() == ["all turn", "all stand", "commands taken: 0"], robotui.err.read_text()
    assert robotui.returncode == 0


# A joint that is told a velocity again and again until it moves; parts sway by themselves, so that only speeds count that are not theirs.
HUMANOID = """
use("Humanoid");
const joint = name => value("body.joints").joints.find(j => j.name === name);
const parts = ["neck_yaw", "left_elbow", "right_elbow", "torso_yaw", "left_hip_yaw", "right_hip_yaw"];
waitFor(() => { try { return value("body.joints").joints.length === 31; } catch (e) { return false; } }, 90);
robots().forEach(r => takeControl(r.name));
const command = velocity => ({joints: parts.map(name => ({name: name, reference: {velocity: velocity}, modes: ["VELOCITY"]}))});
waitFor(() => { send("body.joint_command", command(0.05), 2); return parts.every(name => Math.abs(joint(name).velocity - 0.05) < 0.01); }, 60);
print("all parts move");
stop();
waitFor(() => parts.every(name => joint(name).velocity === 0), 30);
print("all parts stand");
try { send("body.joint_command", command(0.05)); print("a command was taken"); } catch (e) { print("no command is taken"); }
"""


def test_one_stop_halts_all_parts_of_a_humanoid_over_yarp(processes, environment, tmp_path):
    script = tmp_path / "humanoid.js"
    script.write_text(HUMANOID, encoding="ascii")
    surroundings = {key: value for key, value in environment.items() if key not in NO_DISPLAY}
    robotui = processes.start([ROOT / "robotui", "run", "--text", "yarp-humanoid", "--script", script], "robotui", surroundings)

    robotui.wait(120)

    assert robotui.out.read_text().splitlines() == ["all parts move", "all parts stand", "no command is taken"], robotui.err.read_text()
    assert robotui.returncode == 0
