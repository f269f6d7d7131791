"""What it costs that plugins have processes of their own: the same plugins in the HAL's thread, in one host, and in several."""
import json
import subprocess

import robots
from building import CannotMeasure
from control import Control, built, limited
from figures import alone, beside
from histogram import Histogram

PLUGINS = 8
INSIDE = "in the HAL's thread"
HOSTS = {"in one host": 1, "in four hosts": 4}
WARM = 0.5
PERCENTILES = {"p50": 0.5, "p99": 0.99}


def measure(bench):
    robot = robots.demo("humanoid", True)
    seconds = bench.window / 2
    rounds = {name: [] for name in (INSIDE, *HOSTS)}
    for number in range(bench.rounds):
        for name in rounds if number % 2 == 0 else reversed(rounds):
            hosts = HOSTS.get(name)
            config = robots.configuration(bench.folder, robot, PLUGINS, bench.core, hosts or 1)
            result = apart(bench, config, seconds) if hosts else inside(bench, config, seconds)
            rounds[name].append(result)
            bench.say(f"  {number + 1}/{bench.rounds} {name:20}" + ", ".join(f"{key} {value:.1f}" for key, value in result.items()) + " us")
    return [figure for name in rounds for figure in figures(name, rounds, len(robot.joints))]


def inside(bench, config, seconds):
    """The code has no such mode, on purpose: a program of this benchmark runs the HAL's own cycle with the plugins called in it."""
    command = limited(seconds + 30, [built("rt_inprocess"), config, WARM, seconds])
    environment = {"ROBOTUI_RT_PLUGINS": str(built(".", "lib")), "PATH": "/usr/bin:/bin"}
    done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise CannotMeasure(f"rt_inprocess failed: {done.stdout[-1000:]}{done.stderr[-1000:]}")
    told = json.loads(done.stdout)
    return times(Histogram(told["busy"]), Histogram(told["answers"]))


def apart(bench, config, seconds):
    with Control(bench.folder, config, robots.plugin_names(PLUGINS), 2 * seconds) as control:
        control.ask(f"window {WARM}")
        busy = Histogram(control.ask(f"window {seconds}")["busy"])
        answers = control.ask(f"answers {seconds / 2}")             # afterwards: who looks on wakes often
    if not answers:
        raise CannotMeasure("no cycle was answered by all hosts in time")
    return times(busy, Histogram.of((ns, 1) for ns in answers))


def times(busy, answers):
    return {f"{what} {key}": histogram.percentile(share) / 1e3
            for what, histogram in (("cycle", busy), ("answer", answers)) for key, share in PERCENTILES.items()}


def figures(name, rounds, joints):
    for key in rounds[name][0]:
        values = [result[key] for result in rounds[name]]
        figure = f"{key}, {joints} joints, {PLUGINS} plugins {name}, us"
        yield alone(figure, values) if name == INSIDE else beside(figure, values, [result[key] for result in rounds[INSIDE]], INSIDE)
