"""cyclictest of rt-tests, which is the peer, and stress-ng, which is the load."""
import contextlib
import json
import os
import shutil
import signal
import subprocess
import time

from building import CannotMeasure
from control import limited
from histogram import Histogram
from robots import PERIOD_US, PRIORITY

PACKAGES = "rt-tests stress-ng libbenchmark-dev"
FINEST = 1_000_000                                                  # buckets of a nanosecond, the most that cyclictest has
SETTLE = 1                                                          # seconds until the load is what it is to be


def check():
    missing = [tool for tool in ("cyclictest", "stress-ng") if not shutil.which(tool)]
    if missing:
        raise CannotMeasure(f"there is no {' and no '.join(missing)}. Please run: sudo apt-get install --no-install-recommends {PACKAGES}")
    if subprocess.run(["chrt", "--fifo", str(PRIORITY), "true"], capture_output=True).returncode != 0:
        raise CannotMeasure(f"this user may not run in real time with priority {PRIORITY}: ./robotui rt CONFIG says how that is allowed")


def cyclictest_version():
    said = subprocess.run(["cyclictest", "--help"], capture_output=True, text=True).stdout
    return said.splitlines()[0].removeprefix("cyclictest V ").strip() if said else "?"


def cyclictest(folder, core, seconds):
    """How late one thread of cyclictest wakes: same processor, policy, priority and period as the HAL; counted by the nanosecond."""
    told = folder / "cyclictest.json"
    command = ["cyclictest", "--quiet", "--mlockall", "--nsecs", f"--affinity={core}", "--threads=1", "--policy=fifo", f"--priority={PRIORITY}",
               f"--interval={PERIOD_US}", f"--duration={max(1, round(seconds))}", f"--histogram={FINEST}", f"--json={told}"]
    done = subprocess.run(limited(seconds + 20, command), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise CannotMeasure(f"cyclictest failed: {done.stderr[-1000:]}")
    thread = json.loads(told.read_text())["thread"]["0"]
    counted = [(int(ns), count) for ns, count in thread["histogram"].items()]
    beyond = thread["cycles"] - sum(count for _, count in counted)  # of the last bucket: all of them as the longest
    return Histogram.of(counted + ([(thread["max"], beyond)] if beyond > 0 else []))


@contextlib.contextmanager
def stress(folder, seconds):
    """Keeps all processors busy with computing, memory, sockets and switches; ends by itself after SECONDS."""
    command = ["stress-ng", "--quiet", "--cpu", os.cpu_count(), "--vm", 1, "--vm-bytes", "64m", "--sock", 1, "--switch", 1,
               "--timeout", f"{seconds:.0f}s", "--temp-path", folder]
    process = subprocess.Popen([str(word) for word in command], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               start_new_session=True)
    try:
        time.sleep(SETTLE)
        if process.poll() is not None:
            raise CannotMeasure(f"stress-ng ended with {process.returncode}")
        yield
    finally:
        for sign in (signal.SIGTERM, signal.SIGKILL):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, sign)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(10)
                break
