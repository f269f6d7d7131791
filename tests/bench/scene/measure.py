"""From a scene to its figures."""
import statistics
import subprocess

from figures import alone, frames, memory
from stage import DRAGGED, OURS, RESTED, RVIZ, Stage


def rviz_version():
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "rviz"], capture_output=True, text=True)
    return f"rviz {asked.stdout.partition('+')[0]}".strip()


def measured(bench, scene):
    """The figures of a scene, each as soon as it is known."""
    bench.say(f"{scene.name}:")
    peer = rviz_version()
    with Stage(bench, scene) as stage:
        for variant in scene.feeds:
            rates, sizes = stage.frames(variant)
            yield frames(variant[0], rates[OURS], rates[RVIZ], peer)
            yield memory(variant[0], sizes[OURS], sizes[RVIZ], peer)
        if scene.thinned:
            yield from thinned(scene, *stage.thinned())


def thinned(scene, rates, latencies):
    for variant, values in rates.items():
        yield alone(f"{variant}, thinned while turned, frames/s", values, 20, True)
    for pause, what in ((DRAGGED, "while turning"), (RESTED, "after a rest")):
        medians = [statistics.median(found) * 1e3 for found in latencies[pause]]
        yield alone(f"{scene.feeds[-1][0]}, input latency {what}, ms", medians, 50, False)
