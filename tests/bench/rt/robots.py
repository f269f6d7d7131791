"""What is run: the robots of the demo and chains of any number of joints, with plugins that do nothing but look and hold."""
import json
import os
import pathlib
import re
from dataclasses import dataclass

PLUGIN = "BenchPlugin"
PERIOD_US = 1000
PRIORITY = 90                                                       # of the HAL, and of cyclictest
DEADLINE = 0.8                                                      # of the period: commands must be there by then
PATIENT = 1000                                                      # misses: what is measured goes on where the machine is late


@dataclass(frozen=True)
class Robot:
    files: dict                                                     # for XBotInterface
    floating: bool
    joints: list


def demo(name, floating):
    folder = pathlib.Path(os.environ["ROBOTUI_ROOT"], "configs", name)
    joints = re.findall(r"^\s+\d+:\s*(\w+)", (folder / "joint_map.yaml").read_text(), re.MULTILINE)
    files = {"urdf_path": folder / f"{name}.urdf", "srdf_path": folder / f"{name}.srdf", "joint_map_path": folder / "joint_map.yaml"}
    return Robot(files, floating, joints)


def chain(count, folder):
    """A robot whose joints lie one behind the other."""
    joints = [f"joint_{i}" for i in range(1, count + 1)]
    parts = ["<link name='link_0'/>"]
    for i, joint in enumerate(joints):
        parts.append(f"<link name='link_{i + 1}'><inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/>"
                     f"</inertial></link><joint name='{joint}' type='revolute'><parent link='link_{i}'/><child link='link_{i + 1}'/>"
                     "<origin xyz='0 0 0.1'/><axis xyz='0 1 0'/><limit lower='-2' upper='2' velocity='2' effort='50'/></joint>")
    urdf, joint_map = folder / f"chain-{count}.urdf", folder / f"chain-{count}.yaml"
    urdf.write_text(f"<?xml version='1.0'?><robot name='chain'>{''.join(parts)}</robot>")
    joint_map.write_text("joint_map:\n" + "".join(f"  {i + 1}: {joint}\n" for i, joint in enumerate(joints)))
    return Robot({"urdf_path": urdf, "joint_map_path": joint_map}, False, joints)


def plugin_names(count):
    return [f"p{i}" for i in range(count)]


def configuration(folder, robot, plugins, core, hosts=1):
    """Writes it: PLUGINS plugins that share the joints, in HOSTS processes with one thread each. The HAL alone is pinned."""
    period = PERIOD_US / 1e6
    threads = {f"t{i}": {"sched": "fifo", "prio": 60, "period": period, "host": f"h{i}"} for i in range(hosts)}
    config = {
        "XBotInterface": {key: str(path) for key, path in robot.files.items()},
        "ModelInterface": {"model_type": "KDL", "is_model_floating_base": robot.floating},
        "HALInterface": {"type": "dummy", "period_us": PERIOD_US, "prio": PRIORITY, "core_id": core, "deadline": DEADLINE,
                         "misses_before_safe": PATIENT, "safe_law": "damping"},
        "xbotcore_threads": threads,
        "xbotcore_plugins": {name: {"thread": f"t{i % hosts}", "type": PLUGIN, "params": {"joints": robot.joints[i::plugins]}}
                             for i, name in enumerate(plugin_names(plugins))},
    }
    file = folder / "rt.yaml"
    file.write_text(json.dumps(config, indent=1))                   # which is YAML, too
    return file
