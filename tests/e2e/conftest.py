"""What the end-to-end tests share: processes that always end, the products as users start them, real ROS peers."""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "shared"))

from ports import free_port  # noqa: E402

SHARED = pathlib.Path(os.environ.get("ROBOTUI_SHARED", ROOT.parent / "shared"))
ROS_TOOLS = ("roscore", "rostopic", "rosbag", "rosservice", "rosnode", "rosparam")
NO_DISPLAY = ("DISPLAY", "WAYLAND_DISPLAY")
RT_BIN = ROOT / "rt-native/target/release/bin"
# What tests/README.md names: it takes long and has hardly ever broken alone.
needs_long = pytest.mark.skipif(os.environ.get("ROBOTUI_LONG") != "1", reason="takes long: ./robotui test --long")
needs_rt = pytest.mark.skipif(not (RT_BIN / "robotui-rt").exists(), reason="rt-native is not built: ./robotui rt-ctl --help builds it")
WORKER = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))


def ros_domain(number):
    """The domain of ROS 2 of one test file, as tests/README.md has them: another one in each of the processes that run tests side by side."""
    return int(os.environ.get("ROBOTUI_TEST_DOMAIN", "215")) + 4 * number + WORKER


def pytest_configure(config):
    """Each of the processes that run tests side by side has a display of its own."""
    for variable, all_of_them in (("DISPLAY", "ROBOTUI_TEST_DISPLAYS"), ("DBUS_SESSION_BUS_ADDRESS", "ROBOTUI_TEST_BUSES")):
        values = os.environ.get(all_of_them, "").split()
        if values:
            os.environ[variable] = values[WORKER]


def pytest_runtest_logreport(report):
    """Says why a test is tried again, and keeps its name for the closing sum once it has passed."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        return                          # the process that collects all reports says it
    if report.outcome == "rerun":
        print(f"\n{report.nodeid} failed and is tried again:\n{report.longreprtext}", file=sys.stderr)
    elif report.passed and report.when == "call" and getattr(report, "rerun", 0):
        with (pathlib.Path(__file__).parent / "target" / "second-tries.txt").open("a") as file:
            file.write(f"{report.nodeid}\n")


def wait_for(condition, seconds=60, what="it"):
    """Waits until the condition answers something true, and answers that; what may be asked at the end."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        answer = condition()
        if answer:
            return answer
        time.sleep(0.05)
    raise AssertionError(f"waited {seconds} s for {what() if callable(what) else what}")


def busy():
    """How many times longer than alone a program takes on this machine now."""
    return max(1.0, os.getloadavg()[0] / os.cpu_count())


def processes_of(program, *words):
    """The ids of all processes of a program that have all these words among their arguments."""
    found = []
    for each in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            arguments = (each / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if arguments[0].endswith(b"/" + program.encode()) and all(str(word).encode() in arguments for word in words):
            found.append(int(each.name))
    return found


class Processes:
    """Starts programs and ends them, with all their children, at the end of the test."""

    def __init__(self, folder):
        self.folder = folder
        self.running = []

    def start(self, arguments, name, environment):
        out = (self.folder / f"{name}.out").open("w")
        err = (self.folder / f"{name}.err").open("w")
        process = subprocess.Popen([str(a) for a in arguments], env=environment, stdin=subprocess.DEVNULL, stdout=out,
                                   stderr=err, start_new_session=True)
        process.out = self.folder / f"{name}.out"
        process.err = self.folder / f"{name}.err"
        self.running.append(process)
        return process

    def end(self):
        """All at once, but for the first: what the others are connected to, such as a master, goes last."""
        for process in reversed(self.running[1:]):
            tell(process, signal.SIGINT)
        for process in reversed(self.running[1:]):
            await_end(process)
        for process in self.running[:1]:
            end(process)


def end(process, how=signal.SIGINT, patience=10):
    tell(process, how)
    await_end(process, patience)


def tell(process, sign):
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, sign)


def await_end(process, patience=10):
    """Waits for it as long as the patience lasts; then it is killed, and so is what it left behind in any case."""
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(patience)
    tell(process, signal.SIGKILL)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(patience)


def below(pid):
    """The children of a process and theirs, in whatever session they are: roscore gives its master one of its own."""
    children = pathlib.Path(f"/proc/{pid}/task/{pid}/children")
    found = [int(child) for child in children.read_text(encoding="ascii").split()] if children.exists() else []
    return found + [deeper for child in found for deeper in below(child)]


def kill_all_of(process):
    """Ends a program and all that it started at once, as the end of their machine does."""
    started = below(process.pid)
    end(process, how=signal.SIGKILL)
    for pid in started:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


class Robot:
    """A ROS graph: where its master is, and the stock tools pointed at it."""

    def __init__(self, processes, uri, environment):
        self.processes = processes
        self.uri = uri
        self.environment = environment | {"ROS_MASTER_URI": uri, "ROS_IP": "127.0.0.1"}
        self.environment.pop("ROS_HOSTNAME", None)

    def tool(self, *arguments, seconds=60):
        result = subprocess.run(arguments, env=self.environment, stdin=subprocess.DEVNULL, text=True,
                                capture_output=True, timeout=seconds, check=False)
        assert result.returncode == 0, f"{arguments}: {result.stdout}{result.stderr}"
        return result.stdout

    def start_tool(self, *arguments, name):
        return self.processes.start(arguments, name, self.environment)

    def nodes(self):
        return self.tool("rosnode", "list").split()

    def odometry(self):
        """Position x, y and forward speed, as rostopic prints the next message."""
        text = self.tool("rostopic", "echo", "-n", "1", "-p", "/odom")
        names, values = (line.split(",") for line in text.strip().splitlines()[:2])
        row = dict(zip(names, values))
        return (float(row["field.pose.pose.position.x"]), float(row["field.pose.pose.position.y"]),
                float(row["field.twist.twist.linear.x"]))


@pytest.fixture
def processes(tmp_path):
    started = Processes(tmp_path)
    yield started
    started.end()


@pytest.fixture
def environment(tmp_path):
    """The user's surroundings, with a home of its own for what ROS and RobotUI keep."""
    own = {"ROS_HOME": str(tmp_path / "ros"), "XDG_STATE_HOME": str(tmp_path / "state"), "PYTHONUNBUFFERED": "1"}
    return dict(os.environ) | own


@pytest.fixture
def ros_tools():
    missing = [tool for tool in ROS_TOOLS if shutil.which(tool) is None]
    if missing:
        pytest.skip(f"the ROS tools {missing} are not installed")


@pytest.fixture
def roscore(processes, environment, ros_tools):
    """A real roscore."""
    port = free_port()
    robot = Robot(processes, f"http://127.0.0.1:{port}", environment)
    robot.port = port
    robot.core = robot.start_tool("roscore", "-p", str(port), name="roscore")
    wait_for(lambda: listening(port), what="roscore")
    return robot


def listening(port):
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


@pytest.fixture
def simulator(processes, environment, ros_tools):
    """The demo's robot with its embedded master, in a process of its own."""
    robot = start_simulator(processes, environment, 0, "simulator")
    return robot


def start_simulator(processes, environment, port, name, *options):
    process = start_sim_program(processes, environment, name, ["org.robotui.ros"], "--port", port, *options)

    def uri():
        for line in process.out.read_text().splitlines():
            if line.startswith("ROS_MASTER_URI="):
                return line.split("=", 1)[1]
        return None

    robot = Robot(processes, wait_for(uri, seconds=90, what="the simulator"), environment)
    robot.core = process
    robot.port = int(robot.uri.rstrip("/").rsplit(":", 1)[1])
    return robot


def start_sim_program(processes, environment, name, bundles, *options):
    """The simulator with the bundles of the frameworks that it is to speak."""
    plugins = ROOT / "product/target/products/org.robotui.headless.product/linux/gtk/x86_64/plugins"
    all_bundles = ("org.robotui.sim", *bundles, "org.robotui.message", "org.robotui.net", "org.robotui.geometry", "slf4j.api")
    jars = [str(next(plugins.glob(f"{bundle}_*.jar"))) for bundle in all_bundles]
    return processes.start([java(), "-cp", ":".join(jars), "org.robotui.sim.Main", *options], name, environment)


def java():
    home = os.environ.get("JAVA_HOME")
    return f"{home}/bin/java" if home else "java"


def start_robotui(robot, *arguments, name="robotui", display=False):
    """./robotui as a user starts it, pointed at a robot."""
    surroundings = dict(robot.environment)
    if not display:
        for variable in NO_DISPLAY:
            surroundings.pop(variable, None)
    return robot.processes.start([ROOT / "robotui", *arguments], name, surroundings)


def json_lines(process):
    """What ./robotui run --json has printed so far; the last line may not be whole yet."""
    lines = process.out.read_text().splitlines(keepends=True)
    return [json.loads(line) for line in lines if line.endswith("\n")]


def last_of(process, port):
    """The newest line about a port, or none."""
    return next((line for line in reversed(json_lines(process)) if line["port"].split(".", 1)[1] == port), None)
