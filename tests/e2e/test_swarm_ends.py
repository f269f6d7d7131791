"""A window looked at a swarm of fifty robots: what their master, a real one, knows of it after it was closed, and after it was killed."""
import xmlrpc.client

import pytest

from conftest import ROOT, Robot, kill_all_of, start_robotui, start_simulator, wait_for
from desktop import Window, missing

ROBOTS = 50
STREAMS = ("scan", "odom")


class Master:
    def __init__(self, uri):
        self._proxy = xmlrpc.client.ServerProxy(uri)

    def state(self):
        """What each node of the workbench is registered for."""
        _, _, kinds = self._proxy.getSystemState("/test")
        found = {}
        for kind in kinds:
            for topic, nodes in kind:
                for node in nodes:
                    if node.startswith("/robotui_"):
                        found.setdefault(node, []).append(topic)
        return found

    def looked_at(self):
        topics = [topic for of_node in self.state().values() for topic in of_node]
        return [topic for topic in topics if topic.rsplit("/", 1)[-1] in STREAMS]


@pytest.fixture
def swarm(roscore, processes, environment):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    start_simulator(processes, environment, 0, "swarm", "--swarm", ROBOTS, "--real-master", roscore.uri)
    return roscore


def configuration(folder):
    """The one that is shipped; its simulator runs already."""
    lines = (ROOT / "configs/swarm.yaml").read_text().splitlines()
    file = folder / "swarm.yaml"
    file.write_text("\n".join(line for line in lines if not line.startswith("simulator:")))
    return file


def look(swarm, master, file):
    window = Window.open(swarm, file)
    wait_for(lambda: len(master.looked_at()) >= ROBOTS * len(STREAMS), seconds=90, what="a look at all robots")
    return window


def test_a_closed_window_leaves_nothing_of_fifty_nodes(swarm, tmp_path):
    master = Master(swarm.uri)
    window = look(swarm, master, configuration(tmp_path))
    window.close()
    assert window.process.wait(90) == 0
    wait_for(lambda: master.state() == {}, what="the master to have taken all that was told to it")
    assert "not ended in time" not in window.process.err.read_text() + window.process.out.read_text()


def test_the_next_start_removes_what_a_killed_window_left(swarm, processes, tmp_path):
    master = Master(swarm.uri)
    file = configuration(tmp_path)
    window = look(swarm, master, file)
    left = set(master.state())
    kill_all_of(window.process)
    assert left <= set(master.state())
    same_user = Robot(processes, swarm.uri, swarm.environment | {"XDG_STATE_HOME": str(tmp_path / "window-state")})
    start_robotui(same_user, "run", "--json", file, name="next")
    wait_for(lambda: left.isdisjoint(master.state()) and len(master.state()) > ROBOTS, seconds=60, what="the end of what was left")
