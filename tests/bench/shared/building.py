"""What benchmarks have in common: what they need, and programs compiled against the ROS of this machine."""
import os
import pathlib
import shutil
import subprocess

SYSTEM_PYTHON = "/usr/bin/python3"


class CannotMeasure(Exception):
    """Something that the measurement needs is not there."""


def check_machine(ros_modules, packages):
    tools = all(shutil.which(tool) for tool in ("g++", "pkg-config", "rosmaster", SYSTEM_PYTHON))
    if not (tools and succeeds("pkg-config", "--exists", *ros_modules)
            and succeeds(SYSTEM_PYTHON, "-c", "import rospy, std_msgs.msg, sensor_msgs.msg")):
        raise CannotMeasure(f"ROS 1 is missing. Please run: sudo apt-get install --no-install-recommends {packages}")


def succeeds(*command):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0


def cpp_program(source, headers, target, ros_modules):
    """The program of SOURCE in the folder TARGET, compiled again only when a source is newer."""
    program, sources = target / source.stem, [source, *headers]
    if not program.exists() or program.stat().st_mtime < max(each.stat().st_mtime for each in sources):
        target.mkdir(exist_ok=True)
        flags = subprocess.run(["pkg-config", "--cflags", "--libs", *ros_modules], capture_output=True, text=True, check=True)
        command("g++", "-std=c++17", "-O2", "-Wall", "-o", program, source, *flags.stdout.split(), "-pthread")
    return [program]


def variable(name, bench):
    if not os.environ.get(name):
        raise CannotMeasure(f"{name} is not set: start this with ./robotui bench {bench}")
    return os.environ[name]


def command(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise CannotMeasure(f"{pathlib.Path(words[0]).name} failed:\n{done.stdout[-3000:]}")


def jar(name, bench):
    """The newest jar of a bundle of ours, or of a library."""
    found = sorted(pathlib.Path(variable("ROBOTUI_PLUGINS", bench)).glob(f"{name}_*.jar"))
    if not found:
        raise CannotMeasure(f"there is no {name}_*.jar in ROBOTUI_PLUGINS")
    return str(found[-1])
