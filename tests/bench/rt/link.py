"""What it costs to say the state in C++ and to read it in Java, and how old it is then."""
import json
import os
import pathlib
import zipfile

import building
import programs
import robots
from building import CannotMeasure
from control import NAME, Control
from figures import alone, beside
from processes import PATIENCE, Program

HERE = pathlib.Path(__file__).resolve().parent
TARGET = HERE / "target"
JOINTS = 40
JARS = ("org.robotui.xbot", "org.robotui.geometry", "slf4j.api")
LIBRARY = ("org.robotui.xbot.linux.x86_64", "lib/librobotui_rt_jni.so")
FIRST = 3                                                           # seconds that do not count: the virtual machine compiles


def each(bench):
    return max(1, bench.window / 4)


def jar(name):
    found = sorted(pathlib.Path(building.variable("ROBOTUI_PLUGINS", "rt")).glob(f"{name}_*.jar"))
    if not found:
        raise CannotMeasure(f"there is no {name}_*.jar in ROBOTUI_PLUGINS")
    return found[-1]


def java_program():
    java = pathlib.Path(building.variable("JAVA_HOME", "rt"), "bin")
    path = os.pathsep.join(str(jar(name)) for name in JARS)
    classes = TARGET / "classes"
    classes.mkdir(parents=True, exist_ok=True)
    building.command(java / "javac", "--release", "21", "-cp", path, "-d", classes, *sorted(HERE.glob("*.java")))
    fragment, library = LIBRARY
    with zipfile.ZipFile(jar(fragment)) as packed:
        packed.extract(library, TARGET)
    return [java / "java", "-cp", os.pathsep.join([str(classes), path]), f"-Djava.library.path={(TARGET / library).parent}",
            "--enable-native-access=ALL-UNNAMED", "BenchReader"]


def measure(bench):
    cpp = programs.repeated(bench, "link_bench")
    results = {"read": [], "follow": [], "look": []}
    config = robots.configuration(bench.folder, robots.chain(JOINTS, bench.folder), 1, bench.core)
    seconds = bench.rounds * len(results) * each(bench) + 60
    with Control(bench.folder, config, robots.plugin_names(1), seconds) as control:
        reader = Program("BenchReader", [*java_program(), NAME], control.environment, bench.folder)
        try:
            for kind in results:
                tell(reader, kind, FIRST)
            for number in range(bench.rounds):
                for kind in results if number % 2 == 0 else reversed(results):
                    results[kind].append(tell(reader, kind, each(bench)))
                    bench.say(f"  {number + 1}/{bench.rounds} {kind:7}{results[kind][-1]}")
        finally:
            reader.end()
    return list(figures(cpp, results))


def tell(reader, kind, seconds):
    reader.tell(f"{kind} {seconds}")
    return json.loads(reader.answer(seconds + PATIENCE))


def figures(cpp, results):
    state = f"a {JOINTS}-joint state"
    yield alone(f"publishing {state} in C++, us", cpp[f"publish/{JOINTS}"])
    yield alone(f"publishing {state} and waking its readers in C++, us", cpp[f"publish_and_ring/{JOINTS}"])
    yield alone(f"writing {JOINTS} commands in C++, us", cpp[f"command/{JOINTS}"])
    yield beside(f"reading {state} in Java, us", [result["read"] for result in results["read"]], cpp[f"read/{JOINTS}"], "in C++")
    yield alone(f"bytes allocated per reading of {state} in Java", [result["allocated"] for result in results["read"]])
    for kind, who in (("follow", "one that follows every cycle"), ("look", "one that looks now and then")):
        for key in ("p50", "p99"):
            yield alone(f"age {key} of {state} in Java, for {who}, us", [result[key] for result in results[kind]])
