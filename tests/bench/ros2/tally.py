"""What came in while it was measured: from the first message of that phase to the one that ends it."""
import json
import threading
import time


class Tally:
    def __init__(self):
        self.done = threading.Event()
        self.latencies = []
        self.first = self.number = 0
        self.started = self.cpu = 0

    def add(self, tag):
        now = time.monotonic_ns()
        if tag[0] == "m":
            if not self.latencies:
                self.first, self.started, self.cpu = int(tag[1:17], 16), now, time.process_time()
            self.latencies.append(now - int(tag[17:33], 16))
        elif tag[0] == "e":
            self.cpu = time.process_time() - self.cpu
            self.seconds = (now - self.started) / 1e9
            self.number = int(tag[1:17], 16)
            self.done.set()

    def json(self):
        ordered = sorted(self.latencies)

        def quantile(q):
            return ordered[int(q * (len(ordered) - 1))] if ordered else 0
        return json.dumps({"count": len(ordered), "lost": self.number - self.first - len(ordered), "seconds": self.seconds,
                           "cpu": self.cpu, "p50": quantile(.5), "p99": quantile(.99)})
