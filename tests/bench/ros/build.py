"""Compiles publisher and subscribers against the ROS of this machine and the product's jars."""
import os
import pathlib
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
TARGET = HERE / "target"
PACKAGES = ("g++ pkg-config libroscpp-dev libstd-msgs-dev libsensor-msgs-dev python3-roslaunch python3-rospy "
            "python3-std-msgs python3-sensor-msgs")
ROS_MODULES = ("roscpp", "std_msgs", "sensor_msgs")
OUR_JARS = ("org.robotui.ros", "org.robotui.geometry", "slf4j.api")
SYSTEM_PYTHON = "/usr/bin/python3"


class CannotMeasure(Exception):
    """Something that the measurement needs is not there."""


def check_machine():
    tools = all(shutil.which(tool) for tool in ("g++", "pkg-config", "rosmaster", SYSTEM_PYTHON))
    if not (tools and succeeds("pkg-config", "--exists", *ROS_MODULES)
            and succeeds(SYSTEM_PYTHON, "-c", "import rospy, std_msgs.msg, sensor_msgs.msg")):
        raise CannotMeasure(f"ROS 1 is missing. Please run: sudo apt-get install --no-install-recommends {PACKAGES}")


def succeeds(*command):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0


def roscpp_version():
    return subprocess.run(["pkg-config", "--modversion", "roscpp"], capture_output=True, text=True, check=True).stdout.strip()


def cpp_program(name):
    """The program of NAME.cpp, compiled again only when a source is newer."""
    program, sources = TARGET / name, [HERE / f"{name}.cpp", HERE / "probe.hpp"]
    if not program.exists() or program.stat().st_mtime < max(source.stat().st_mtime for source in sources):
        TARGET.mkdir(exist_ok=True)
        flags = subprocess.run(["pkg-config", "--cflags", "--libs", *ROS_MODULES], capture_output=True, text=True, check=True)
        command("g++", "-std=c++17", "-O2", "-Wall", "-o", program, sources[0], *flags.stdout.split(), "-pthread")
    return [program]


def java_program():
    java = pathlib.Path(variable("JAVA_HOME"), "bin")
    path = os.pathsep.join(str(jar(name)) for name in OUR_JARS)
    classes = TARGET / "classes"
    classes.mkdir(parents=True, exist_ok=True)
    command(java / "javac", "--release", "21", "-cp", path, "-d", classes, *sorted(HERE.glob("*.java")))
    return [java / "java", "-cp", os.pathsep.join([str(classes), path]), "BenchSubscriber"]


def jar(name):
    found = sorted(pathlib.Path(variable("ROBOTUI_PLUGINS")).glob(f"{name}_*.jar"))
    if not found:
        raise CannotMeasure(f"there is no {name}_*.jar in ROBOTUI_PLUGINS")
    return found[-1]


def variable(name):
    if not os.environ.get(name):
        raise CannotMeasure(f"{name} is not set: start this with ./robotui bench ros")
    return os.environ[name]


def command(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise CannotMeasure(f"{pathlib.Path(words[0]).name} failed:\n{done.stdout[-3000:]}")
