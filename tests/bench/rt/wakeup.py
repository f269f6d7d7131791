"""How late the HAL's thread wakes, beside cyclictest on the same processor with the same policy and priority, and beside itself without real time."""
import contextlib

import robots
from control import Control
from figures import beside
from histogram import Histogram
from peers import cyclictest, cyclictest_version, stress

OURS, PEER, NRT = "robotui-rt", "cyclictest", "--nrt"
PERCENTILES = {"p50": 0.5, "p99": 0.99, "p99.9": 0.999}
BOUND = 1.3                                                         # of p99
LOADS = ("idle", "stress")
WARM = 0.5                                                          # seconds before a window
BETWEEN = 6                                                         # seconds that starts and ends take, generously


def measure(bench):
    robot = robots.demo("arm", False)
    config = robots.configuration(bench.folder, robot, 1, bench.core)
    results = {load: {name: [] for name in (OURS, PEER, NRT)} for load in LOADS}
    for number in range(bench.rounds):
        for load in LOADS:
            with loaded(bench, load):
                # There and back again: what changes with time meets all alike.
                for name in (OURS, PEER, NRT) if number % 2 == 0 else (NRT, PEER, OURS):
                    late = window(bench, config, name)
                    results[load][name].append(late)
                    bench.say(f"  {number + 1}/{bench.rounds} {load:7}{name:11}" + ", ".join(f"{key} {value:.1f}" for key, value in late.items()) + " us")
    return [figure for load in LOADS for figure in figures(load, results[load])]


def loaded(bench, load):
    return contextlib.nullcontext() if load == "idle" else stress(bench.folder, 3 * (bench.window + BETWEEN) + 60)


def window(bench, config, name):
    if name == PEER:
        histogram = cyclictest(bench.folder, bench.core, bench.window)
    else:
        options = ["--nrt"] if name == NRT else []
        with Control(bench.folder, config, robots.plugin_names(1), bench.window, options) as control:
            control.ask(f"window {WARM}")
            histogram = Histogram(control.ask(f"window {bench.window}")["wake_up"])
    return {**{key: histogram.percentile(share) / 1e3 for key, share in PERCENTILES.items()}, "max": histogram.longest() / 1e3}


def figures(load, results):
    peer_name = f"cyclictest {cyclictest_version()}"
    for name in (OURS, NRT):
        of = "wake-up" if name == OURS else "wake-up with --nrt"
        for key in (*PERCENTILES, "max"):
            bound = BOUND if name == OURS and key == "p99" else None
            yield beside(f"{of}, {load}: {key}, us", [late[key] for late in results[name]], [late[key] for late in results[PEER]], peer_name, bound)
