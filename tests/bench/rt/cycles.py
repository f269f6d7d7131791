"""What a cycle costs, from sensing to moving, by the numbers of joints and plugins; and into which periods it fits."""
import statistics

import robots
from control import Control
from figures import alone
from histogram import Histogram

PLUGINS = (1, 8, 32)
PERIODS_US = (1000, 250)
WARM = 0.5


def seconds(bench):
    return max(1, bench.window / 4)


def measure(bench):
    all_robots = [robots.demo("arm", False), robots.demo("humanoid", True), robots.chain(60, bench.folder)]
    rounds = {(len(robot.joints), plugins): [] for robot in all_robots for plugins in PLUGINS}
    for number in range(bench.rounds):
        for robot in all_robots if number % 2 == 0 else reversed(all_robots):
            for plugins in PLUGINS:
                config = robots.configuration(bench.folder, robot, plugins, bench.core)
                with Control(bench.folder, config, robots.plugin_names(plugins), seconds(bench)) as control:
                    control.ask(f"window {WARM}")
                    told = control.ask(f"window {seconds(bench)}")
                result = percentiles(told)
                rounds[len(robot.joints), plugins].append(result)
                bench.say(f"  {number + 1}/{bench.rounds} {len(robot.joints)} joints, {plugins} plugins: cycle p50 {result['p50']:.1f}, "
                          f"p99 {result['p99']:.1f} us, thread of the plugins p50 {result['thread']:.1f} us, {told['missed']} missed")
    return [figure for (joints, plugins), results in rounds.items() for figure in figures(joints, plugins, results)]


def percentiles(told):
    busy = Histogram(told["busy"])
    return {"p50": busy.percentile(0.5) / 1e3, "p99": busy.percentile(0.99) / 1e3, "thread": Histogram(told["threads"][0]).percentile(0.5) / 1e3}


def fitting(p99):
    """The periods within whose deadline such a cycle ends: behind it commands do not count."""
    there = [f"{period} us" for period in PERIODS_US if p99 <= robots.DEADLINE * period]
    return "fits into " + " and ".join(there) if there else "fits into neither period"


def figures(joints, plugins, results):
    of = f"{joints} joints, {plugins} plugin{'s' if plugins > 1 else ''}"
    worst = [result["p99"] for result in results]
    yield alone(f"cycle p50, {of}, us", [result["p50"] for result in results])
    yield alone(f"cycle p99, {of}, us: {fitting(statistics.median(worst))}", worst)
    yield alone(f"thread of the plugins p50, {of}, us", [result["thread"] for result in results])
