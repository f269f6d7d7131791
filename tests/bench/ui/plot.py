"""Panning and zooming a plot of a million samples: the program beside the plot's tests, run on the product's jars."""
import json
import os
import pathlib
import subprocess

from building import CannotMeasure, command, variable

HERE = pathlib.Path(__file__).resolve().parent
TESTS = "bundles/org.robotui.uic.plot/src_test"
PAINTS = 120
PATIENCE = 300


def program():
    java = pathlib.Path(variable("JAVA_HOME", "ui"), "bin")
    plugins = pathlib.Path(variable("ROBOTUI_WINDOW_PRODUCT", "ui"), "plugins")
    path = os.pathsep.join(str(jar) for name in ("org.robotui.*", "org.eclipse.swt*", "slf4j.api*") for jar in sorted(plugins.glob(f"{name}.jar")))
    classes = HERE / "target" / "plot"
    classes.mkdir(parents=True, exist_ok=True)
    tests = pathlib.Path(variable("ROBOTUI_ROOT", "ui"), TESTS)
    command(java / "javac", "--release", "21", "-cp", path, "-sourcepath", tests, "-d", classes,
            tests / "org/robotui/uic/plot/internal/PlotBench.java")
    return [str(java / "java"), "--enable-native-access=ALL-UNNAMED", "-Xmx2g", "-cp", os.pathsep.join([str(classes), path]),
            "org.robotui.uic.plot.internal.PlotBench", str(PAINTS)]


def plot_round(display):
    """The 95th percentile of a paint, milliseconds, by number of traces: the worse of panning and zooming, smooth or noisy."""
    done = subprocess.run(program(), env=display.environment, capture_output=True, text=True, timeout=PATIENCE)
    cases = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    if not cases:
        raise CannotMeasure(f"the plot did not paint\n{done.stderr[-2000:]}")
    worst = {}
    for case in cases:
        traces = int(case["case"].split()[0])
        worst[traces] = max(worst.get(traces, 0), case["p95_ms"])
    return worst
