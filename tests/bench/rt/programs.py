"""Programs on google-benchmark: the calls of the models, by back-end, and those of the link."""
import json
import os
import subprocess

from building import CannotMeasure
from control import built, limited
from figures import alone

PER_MICROSECOND = {"ns": 1e-3, "us": 1, "ms": 1e3}
MINUTES = 10                                                        # never longer


def repeated(bench, name):
    """CPU time of a call in us, by its name: one value a repetition, which alternate."""
    command = [built(name), "--benchmark_format=json", f"--benchmark_repetitions={bench.rounds}", "--benchmark_enable_random_interleaving=true",
               f"--benchmark_min_time={0.01 if bench.quick else 0.1}"]
    done = subprocess.run(limited(MINUTES * 60, command), env=os.environ, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise CannotMeasure(f"{name} failed: {done.stderr[-1000:]}")
    values = {}
    for one in json.loads(done.stdout)["benchmarks"]:
        if one["run_type"] == "iteration":
            values.setdefault(one["run_name"], []).append(one["cpu_time"] * PER_MICROSECOND[one["time_unit"]])
    return values


def models(bench):
    return [alone(f"model {name}, us", values) for name, values in sorted(repeated(bench, "model_bench").items())]
