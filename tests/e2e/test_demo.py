"""The demo robot, as users of ROS tools and of the text view meet it."""
import os
import signal
import subprocess

from conftest import ROOT, end, json_lines, last_of, listening, start_robotui, start_simulator, wait_for

LIVE = {"scan": 10, "odom": 10, "sonar": 5, "camera/image_raw": 5, "battery_state": 0.2, "imu/data": 10}


def test_all_that_the_robot_offers_is_live(simulator):
    robotui = start_robotui(simulator, "run", "--json", "ros")

    for port, least in LIVE.items():
        line = wait_for(lambda: fast_enough(robotui, port, least), what=f"{port} at {least} Hz")
        assert line["age_s"] < 3
        assert line["dropped"] == 0
        assert line["link"] == "connected"


def fast_enough(robotui, port, least):
    line = last_of(robotui, port)
    return line if line and line["rate_hz"] >= least else None


def test_stock_tools_drive_it_and_it_stops_half_a_second_after_the_last_command(simulator):
    before = simulator.odometry()
    driver = simulator.start_tool("rostopic", "pub", "-r", "10", "/cmd_vel", "geometry_msgs/Twist",
                                  "{linear: {x: 0.3}, angular: {z: 0.4}}", name="driver")

    wait_for(lambda: simulator.odometry()[2] > 0.2, what="motion")
    end(driver)
    wait_for(lambda: abs(simulator.odometry()[2]) < 0.02, what="standstill")
    after = simulator.odometry()
    assert (after[0] - before[0]) ** 2 + (after[1] - before[1]) ** 2 > 0.01


def test_stock_tools_find_everything_at_the_embedded_master(simulator, tmp_path):
    assert "/scan" in simulator.tool("rostopic", "list").split()
    assert simulator.tool("rostopic", "type", "/scan").strip() == "sensor_msgs/LaserScan"
    assert "Publishers" in simulator.tool("rostopic", "info", "/scan")
    assert "xmlrpc reply" in simulator.tool("rosnode", "ping", "-c", "1", simulator.nodes()[0])
    assert "/stop" in simulator.tool("rosservice", "list").split()
    assert "success: True" in simulator.tool("rosservice", "call", "/motors", "true")
    simulator.tool("rosparam", "set", "/lab/name", "Building 4")
    assert simulator.tool("rosparam", "get", "/lab/name").strip().strip("'") == "Building 4"
    bag = tmp_path / "recorded.bag"
    simulator.tool("rosbag", "record", "-O", str(bag), "-l", "20", "/scan")
    assert "sensor_msgs/LaserScan" in simulator.tool("rosbag", "info", str(bag))


def test_it_is_taken_up_again_when_it_was_killed_and_started_anew(processes, environment, simulator):
    robotui = start_robotui(simulator, "run", "--json", "ros")
    wait_for(lambda: fast_enough(robotui, "scan", 10), what="the scan")

    end(simulator.core, how=signal.SIGKILL)
    lost = wait_for(lambda: (line := last_of(robotui, "scan")) and line["link"] != "connected" and line, what="the loss")
    assert lost["age_s"] > 0
    start_simulator(processes, environment, simulator.port, "simulator2")
    wait_for(lambda: (line := fast_enough(robotui, "scan", 10)) and line["link"] == "connected", what="its return")


def test_closing_leaves_the_graph_as_it_was(simulator):
    before = sorted(simulator.nodes())
    robotui = start_robotui(simulator, "run", "--json", "ros")
    wait_for(lambda: fast_enough(robotui, "odom", 10), what="the odometry")
    assert sorted(simulator.nodes()) != before

    os.kill(robotui.pid, signal.SIGTERM)
    robotui.wait(60)

    wait_for(lambda: sorted(simulator.nodes()) == before, what="the former graph")


def test_the_robot_ends_with_robotui_unless_asked_to_stay(processes, environment, simulator):
    robotui = start_robotui(simulator, "run", "--json")
    wait_for(lambda: json_lines(robotui), what="the first line")
    uri = next(line.split("=", 1)[1].split()[0] for line in robotui.err.read_text().splitlines() if "export ROS_MASTER_URI=" in line)
    assert uri != simulator.uri

    os.kill(robotui.pid, signal.SIGKILL)
    robotui.wait(60)

    port = int(uri.rstrip("/").rsplit(":", 1)[1])
    wait_for(lambda: not listening(port), what="the end of the simulator")


def test_the_text_view_shows_what_json_shows(simulator):
    robotui = start_robotui(simulator, "run", "--text", "ros")

    wait_for(lambda: "scan" in robotui.out.read_text() and "odom" in robotui.out.read_text(), what="the text view")


def test_check_says_what_becomes_of_every_connection(tmp_path):
    fine = subprocess.run([ROOT / "robotui", "check", "demo"], text=True, capture_output=True, timeout=60, check=False)
    assert fine.returncode == 0, fine.stdout + fine.stderr
    assert "cmd_vel" in fine.stdout

    live = subprocess.run([ROOT / "robotui", "check", "demo", "--live"], text=True, capture_output=True, timeout=60, check=False)
    assert live.returncode == 0, live.stdout + live.stderr
    lines = {line.split()[1]: line.split()[0] for line in live.stdout.splitlines() if line.startswith("  ")}
    assert lines["map.scan"] == lines["teleop.cmd_vel"] == lines["camera.image"] == "connected", live.stdout

    broken = tmp_path / "broken.yaml"
    broken.write_text("ruics:\n  Robot:\n    type: mobilebase\n    rfics:\n      base: {type: ros, mastr: here}\n")
    result = subprocess.run([ROOT / "robotui", "check", broken], text=True, capture_output=True, timeout=60, check=False)
    assert result.returncode == 1, result.stdout + result.stderr
    assert "broken.yaml:5:25: error: unknown setting 'mastr'; did you mean 'master'?" in result.stdout + result.stderr
