"""Two machines with a bad network between them: see peers/relay.py."""
import pathlib
import re
import shutil
import socket

import pytest

from conftest import ROOT, Robot, free_port, java, wait_for

RELAY = pathlib.Path(__file__).parent / "peers" / "relay.py"
ADDRESSES = ("10.77.0.1", "10.77.0.2")
TOOLS = ("unshare", "nsenter", "ip")


class Inside:
    """Starts programs in the namespace of one side."""

    def __init__(self, processes, process_id):
        self.processes = processes
        self.folder = processes.folder
        self.prefix = ["nsenter", "--preserve-credentials", "-U", "-n", "-t", str(process_id)]

    def start(self, arguments, name, environment):
        return self.processes.start([*self.prefix, *arguments], name, environment)


class Machine(Robot):
    """One side, with the stock tools in it."""

    def __init__(self, processes, process_id, address, uri, environment):
        super().__init__(Inside(processes, process_id), uri, environment)
        self.address = address
        self.environment["ROS_IP"] = address

    def tool(self, *arguments, seconds=60):
        return super().tool(*self.processes.prefix, *arguments, seconds=seconds)

    def knows(self, uri):
        """Points it at a master."""
        self.uri = self.environment["ROS_MASTER_URI"] = uri


class Network:
    """The way between two machines, which can be made worse."""

    def __init__(self, processes, environment):
        self.path = processes.folder / "relay.socket"
        self.relay = processes.start(["unshare", "--map-root-user", "--net", "/usr/bin/python3", RELAY, self.path], "relay", environment)
        ids = wait_for(self._sides, what="the network")
        self.robot, self.workbench = (Machine(processes, process, address, "", environment)
                                      for process, address in zip(ids, ADDRESSES))

    def _sides(self):
        if self.relay.poll() is not None:
            pytest.skip("this machine gives us no network of our own: " + self.relay.err.read_text().strip().splitlines()[-1])
        found = re.search(r"^sides (\d+) (\d+)$", self.relay.out.read_text(), re.MULTILINE)
        return found.groups() if found else None

    def _order(self, text):
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as orders:
            orders.sendto(text.encode(), str(self.path))

    def impair(self, delay, loss):
        """Seconds each way, and the part of all packets that is lost."""
        self._order(f"impair {delay} {loss}")

    def outage(self, seconds):
        self._order(f"outage {seconds}")

    def cut(self):
        """Loses all until it is mended; answers since when, by this machine's clock."""
        return self._answer("cut")[0]

    def mend(self):
        """Ends a cut; answers when that was."""
        return self._answer("mend")[0]

    def counts(self):
        """How many packets were carried and lost so far."""
        return tuple(map(int, self._answer("count")[1:]))

    def _answer(self, order):
        before = len(self._answers(order))
        self._order(order)
        wait_for(lambda: len(self._answers(order)) > before, what=f"the relay's answer to {order}")
        return self._answers(order)[-1]

    def _answers(self, order):
        found = re.findall(rf"^{order}: at (\S+) carried (\d+) lost (\d+)\n", self.relay.out.read_text(), re.MULTILINE)
        return [tuple(map(float, figures)) for figures in found]


@pytest.fixture
def network(processes, environment):
    missing = [tool for tool in TOOLS if shutil.which(tool) is None]
    if missing:
        pytest.skip(f"{missing} are not installed")
    made = Network(processes, environment)
    return made


def start_robot(network, environment):
    """A real roscore, and the demo's robot at it, on the robot's machine; both machines know the master."""
    port = free_port()
    uri = f"http://{ADDRESSES[0]}:{port}"
    network.robot.knows(uri)
    network.workbench.knows(uri)
    network.robot.start_tool("roscore", "-p", str(port), name="roscore")
    plugins = ROOT / "product/target/products/org.robotui.headless.product/linux/gtk/x86_64/plugins"
    jars = [str(next(plugins.glob(f"{bundle}_*.jar"))) for bundle in ("org.robotui.sim", "org.robotui.ros", "org.robotui.message", "org.robotui.net", "org.robotui.geometry", "slf4j.api")]
    simulator = network.robot.start_tool(java(), "-cp", ":".join(jars), "org.robotui.sim.Main", "--real-master", uri, name="simulator")
    wait_for(lambda: "ROS_MASTER_URI=" in simulator.out.read_text(), what="the robot")
