"""The control in real time, as the tests start it, and what it says without any workbench: robotui-rt and robotui-rt-ctl."""
import dataclasses
import re

import yaml

from conftest import ROOT, RT_BIN, Robot, processes_of

ARM = ROOT / "configs/arm"
JOINT = re.compile(r"(?P<name>\S+) +(?P<position>-?[\d.]+) +(?P<reference>-?[\d.]+) +(?P<control>\S+) +(?P<owner>\S+)(?: +(?P<cut>\d+) cut)?")


@dataclasses.dataclass
class Joint:
    position: float
    reference: float
    control: str
    owner: str
    cut: int


def patient_arm(folder, **plugins):
    """
    The demo's arm with its own plugins, and parameters for some of them. Machines that run tests are late now and then: that is not
    what is looked at here, and a joint in its safe state would not move.
    """
    config = yaml.safe_load((ARM / "rt-dummy.yaml").read_text())
    config["XBotInterface"] = {key: str(ARM / file) for key, file in config["XBotInterface"].items()}
    config["MasterCommunicationInterface"]["framework_name"] = "robotui"
    config["HALInterface"]["misses_before_safe"] = 1000
    for name, parameters in plugins.items():
        config["xbotcore_plugins"][name]["params"] |= parameters
    file = folder / "rt.yaml"
    file.write_text(yaml.safe_dump(config, sort_keys=False))
    return file


class Control:
    """A robotui-rt in a world of its own, where no other one is found."""

    def __init__(self, processes, environment, folder, config=ARM / "rt-dummy.yaml"):
        self.processes = processes
        self.config = config
        run = folder / "run"
        run.mkdir(mode=0o700)
        # No robot here speaks ROS; the address is for those that might.
        self.robot = Robot(processes, "http://127.0.0.1:9", environment | {"XDG_RUNTIME_DIR": str(run), "ROBOTUI_NATIVE_BUILT": "1"})

    def start(self, name="control"):
        return self.processes.start([RT_BIN / "robotui-rt", "-C", self.config, "--allow-non-rt"], name, self.robot.environment)

    def ctl(self, *words):
        return self.robot.tool(RT_BIN / "robotui-rt-ctl", *words)

    def is_up(self):
        """Whether all its plugins are loaded."""
        try:
            states = self.plugins().values()
        except AssertionError:
            return False
        return bool(states) and all(state == "stopped" for state, _ in states)

    def plugins(self):
        """State and error by name."""
        lines = [line.split(None, 3) for line in self.ctl("list").splitlines()]
        return {words[0]: (words[1], words[3] if len(words) > 3 else "") for words in lines}

    def state(self, plugin):
        return self.plugins()[plugin][0]

    def joints(self):
        found = {}
        for line in self.ctl("joints").splitlines():
            said = JOINT.match(line)
            if said is None:
                continue                # behind the table stands why joints are safe
            found[said["name"]] = Joint(float(said["position"]), float(said["reference"]), said["control"], said["owner"],
                                        int(said["cut"] or 0))
        return found

    def hosts(self, *words):
        return processes_of("robotui-rt-host", self.config, *words)
