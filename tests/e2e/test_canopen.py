"""A bus of drives beside the library canopen: our control leads drives that are made with it, and it leads a simulated drive of ours."""
import os
import pathlib
import subprocess

import pytest
import yaml

from conftest import RT_BIN, needs_rt, wait_for
from realtime import ARM, Control

PEERS = pathlib.Path(__file__).parent / "peers"
PYTHON = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "")) / "canopen/bin/python"
PERIOD_US = 20_000                      # drives in Python need their time

pytestmark = [needs_rt, pytest.mark.skipif(not PYTHON.exists(), reason="needs canopen and python-can from PyPI: ./robotui test fetches them")]


def patient_arm(folder, bus):
    """As it is shipped, but slow and patient: machines that run tests are late now and then."""
    config = yaml.safe_load((ARM / "rt-canopen.yaml").read_text())
    config["XBotInterface"] = {key: str(ARM / file) for key, file in config["XBotInterface"].items()}
    config["HALInterface"] |= {"misses_before_safe": 100, "period_us": PERIOD_US}
    config["HALInterface"]["params"] |= {"interface": f"unix:{bus}", "missed_pdos": 1000, "heartbeat_timeout_ms": 20_000, "modes": ["position"],
                                         "enable_timeout_ms": 20_000, "sdo_timeout_ms": 5000}
    config["xbotcore_threads"] = {"rt_main": {"period": PERIOD_US / 1e6}, "rt_slow": {"period": PERIOD_US / 1e6, "host": "models"}}
    config["xbotcore_plugins"]["Homing"]["params"]["speed"] = 1
    file = folder / "rt.yaml"
    file.write_text(yaml.safe_dump(config, sort_keys=False))
    return file


def test_drives_of_the_library_canopen_are_led_home(processes, environment, tmp_path):
    bus = tmp_path / "can"
    faults = tmp_path / "faults"
    os.mkfifo(faults)
    drives = processes.start(["bash", "-c", f"exec {PYTHON} {PEERS}/canopen_drives.py {bus} 7 <>{faults}"], "drives", environment)
    wait_for(lambda: "drives 7" in drives.out.read_text(), what="the drives")
    control = Control(processes, environment, tmp_path, patient_arm(tmp_path, bus))
    running = control.start()
    wait_for(control.is_up, seconds=60, what="the control")

    def said(words):
        return words in running.err.read_text() + running.out.read_text()

    wait_for(lambda: all(said(f"(node {node}) is enabled") for node in range(1, 8)), seconds=60, what="enabled drives")
    assert "runs" in control.ctl("switch", "Homing", "1")
    wait_for(lambda: control.ctl("status", "Homing").strip() == "running: at home", seconds=60, what="the arm at home")

    faults.write_text("2 3210\n")
    wait_for(lambda: said("(node 2) reports the error 0x3210 (DC link over-voltage)"), what="the emergency in words")
    wait_for(lambda: control.state("Homing") == "stopped", what="a plugin that fell")
    wait_for(lambda: {joint.control for joint in control.joints().values()} == {"safe"}, what="joints in their safe state")
    assert "asked" in control.ctl("recover")
    wait_for(lambda: said("(node 2) is asked to be enabled again"), seconds=60, what="the drive that is brought back")
    wait_for(lambda: (running.err.read_text() + running.out.read_text()).count("(node 2) is enabled") == 2, seconds=60, what="the drive again")

    def phases():
        return {line.split("\t")[0] for line in control.ctl("drives").splitlines()}

    control.ctl("disable")
    wait_for(lambda: phases() == {"disabled"}, seconds=60, what="disabled drives")
    control.ctl("enable")
    wait_for(lambda: phases() == {"enabled"}, seconds=60, what="drives that are enabled again")
    assert "runs" in control.ctl("switch", "Homing", "1")


def test_the_library_canopen_leads_a_simulated_drive(processes, environment, tmp_path):
    bus = tmp_path / "can"
    drives = processes.start([RT_BIN / "robotui-rt-drives", "-C", ARM / "rt-canopen.yaml", "--interface", f"unix:{bus}"], "drives", environment)
    wait_for(lambda: "drives 7" in drives.out.read_text(), what="the drives")
    seen = subprocess.run([PYTHON, PEERS / "canopen_visitor.py", bus, "3"], env=environment, capture_output=True, text=True, timeout=180, check=False)
    assert seen.stdout.splitlines() == ["type 0x20192", "heartbeat PRE-OPERATIONAL", "refused 0x6010002", "state OPERATION ENABLED",
                                        "position 4321", "emergency 0x8130 state FAULT"], seen.stderr
