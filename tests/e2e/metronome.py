"""How long the machine itself lets nobody run: what a process that only sleeps finds out."""
import subprocess
import sys

BEAT = 0.01
LEAST = 0.02
BEATS = f"""
import time
while True:
    before = time.monotonic()
    time.sleep({BEAT})
    late = time.monotonic() - before - {BEAT}
    if late > {LEAST}:
        print(late, flush=True)
"""


class Metronome:
    """Beats from its making on. Whoever is paused less than it was may have been paused by the machine alone."""

    def __init__(self):
        self._beats = subprocess.Popen([sys.executable, "-c", BEATS], stdout=subprocess.PIPE, text=True)

    def pauses(self):
        """Ends it, and tells the longest pause and the sum of all of them, in seconds."""
        self._beats.terminate()
        late = [float(line) for line in self._beats.communicate()[0].splitlines()]
        return {"longest": max(late, default=0.0), "sum": sum(late)}
