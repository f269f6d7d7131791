"""Compiles publisher and subscribers against the ROS of this machine and the product's jars."""
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "shared"))

import building  # noqa: E402
from building import SYSTEM_PYTHON, CannotMeasure  # noqa: E402,F401

TARGET = HERE / "target"
PACKAGES = ("g++ pkg-config libroscpp-dev libstd-msgs-dev libsensor-msgs-dev python3-roslaunch python3-rospy "
            "python3-std-msgs python3-sensor-msgs")
ROS_MODULES = ("roscpp", "std_msgs", "sensor_msgs")
OUR_JARS = ("org.robotui.ros", "org.robotui.message", "org.robotui.net", "org.robotui.geometry", "slf4j.api")


def check_machine():
    building.check_machine(ROS_MODULES, PACKAGES)


def roscpp_version():
    return subprocess.run(["pkg-config", "--modversion", "roscpp"], capture_output=True, text=True, check=True).stdout.strip()


def cpp_program(name):
    return building.cpp_program(HERE / f"{name}.cpp", [HERE / "probe.hpp"], TARGET, ROS_MODULES)


def java_program():
    java = pathlib.Path(variable("JAVA_HOME"), "bin")
    path = os.pathsep.join(str(jar(name)) for name in OUR_JARS)
    classes = TARGET / "classes"
    classes.mkdir(parents=True, exist_ok=True)
    building.command(java / "javac", "--release", "21", "-cp", path, "-d", classes, *sorted(HERE.glob("*.java")))
    return [java / "java", "-cp", os.pathsep.join([str(classes), path]), "BenchSubscriber"]


def jar(name):
    found = sorted(pathlib.Path(variable("ROBOTUI_PLUGINS")).glob(f"{name}_*.jar"))
    if not found:
        raise CannotMeasure(f"there is no {name}_*.jar in ROBOTUI_PLUGINS")
    return found[-1]


def variable(name):
    return building.variable(name, "ros")
