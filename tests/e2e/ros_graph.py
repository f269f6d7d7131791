"""A ROS graph of others, what its master knows, and what is demanded of a workbench beside it."""
import json
import pathlib
import re
import xmlrpc.client

from conftest import free_port, last_of, start_robotui, wait_for
from side_effects import SPEED, Witness, same_rhythm, same_steps

PEERS = pathlib.Path(__file__).parent / "peers"
RATE = 10.0
SECONDS = 8
OURS = re.compile(r"/robotui_\w+")


class MasterThere:
    """A master that only those on its own machine reach."""

    ASK = "import json, sys, xmlrpc.client as x; print(json.dumps(getattr(x.ServerProxy(sys.argv[1]), sys.argv[2])(*sys.argv[3:])))"

    def __init__(self, machine):
        self.machine = machine

    def __getattr__(self, method):
        return lambda *arguments: json.loads(self.machine.tool("/usr/bin/python3", "-c", self.ASK, self.machine.uri, method, *arguments))


class Graph:
    """A roscore, a robot that another node drives, and somebody who listens."""

    def __init__(self, roscore, *options, master=None):
        self.ros = roscore
        self.master = master or xmlrpc.client.ServerProxy(roscore.uri)
        robot = str(PEERS / "accountable_robot.py")
        self._start("robot", robot, *options)
        self._start("driver", robot, "--driver")
        self.witness = Witness(self._start("witness", str(PEERS / "witness.py"), "odom", "scan", "cmd_vel"))
        wait_for(lambda: any(line.get("linear") == SPEED for line in self.witness.lines()), what="the robot to be driven")

    def _start(self, name, *arguments):
        return self.ros.start_tool("/usr/bin/python3", *arguments, name=name)

    def _ask(self, method, *arguments):
        code, status, value = getattr(self.master, method)("/side_effects", *arguments)
        assert code == 1, status
        return value

    def state(self):
        """All that the master knows, in an order of its own."""
        kinds = ("publishers", "subscribers", "services")
        state = {kind: sorted([name, sorted(nodes)] for name, nodes in entries)
                 for kind, entries in zip(kinds, self._ask("getSystemState"))}
        return state | {"types": sorted(self._ask("getTopicTypes")), "parameters": self._ask("getParam", "/")}

    def ours(self):
        return sorted(set(OURS.findall(json.dumps(self.state()))))

    def phase(self, name):
        """Listens for a while."""
        return self.witness.phase(name, SECONDS, state=self.state())


def without_ours(state):
    """What the master knows apart from the workbench's nodes."""
    kept = {kind: [[name, [node for node in nodes if not OURS.match(node)]] for name, nodes in state[kind]]
            for kind in ("publishers", "subscribers", "services")}
    return state | {kind: [entry for entry in entries if entry[1]] for kind, entries in kept.items()}


def same_motion(phase):
    """Commanded by its driver alone, and every step as long as the driver wants it."""
    assert {line["from"] for line in phase["heard"] if line["topic"] == "cmd_vel"} == {"/driver"}
    same_steps(phase, SPEED / RATE)


def unharmed(phases):
    for phase in phases:
        same_rhythm(phase, phases[0])
        same_motion(phase)
        assert without_ours(phase["state"]) == phases[0]["state"], phase["name"]


def make_graph(roscore, *options, master=None):
    made = Graph(roscore, *options, master=master)
    wait_for(lambda: len(made.state()["services"]) == 8, what="all nodes")      # two of each: rosout, robot, driver, witness
    return made


def make_far_graph(network):
    """On a machine that the workbench's reaches through a network alone."""
    uri = f"http://{network.robot.address}:{free_port()}"
    network.robot.knows(uri)
    network.workbench.knows(uri)
    network.robot.start_tool("roscore", "-p", uri.rsplit(":", 1)[1], name="roscore")
    master = MasterThere(network.robot)
    wait_for(lambda: answers(master), what="roscore")
    return make_graph(network.robot, master=master)


def answers(master):
    try:
        return master.getPid("/side_effects")
    except AssertionError:
        return None


def headless(graph, name="robotui", config="ros", machine=None):
    started = start_robotui(machine or graph.ros, "run", "--json", config, name=name)
    wait_for(lambda: (line := last_of(started, "odom")) and line["rate_hz"] > RATE / 2, seconds=60, what="the odometry in the workbench")
    return started
