"""What reaches a receiver: counted in memory that the sender sees, and told when it is asked for."""
import json
import mmap
import struct
import sys
import time


class Arrivals:
    def __init__(self, path):
        with open(path, "r+b") as file:
            self.credit = mmap.mmap(file.fileno(), 8)
        self.clear()

    def clear(self):
        self.latencies, self.first, self.last, self.highest = [], 0, 0, -1

    def add(self, tag):
        now = time.clock_gettime_ns(time.CLOCK_MONOTONIC)
        self.first = self.first or now
        self.last = now
        self.highest = max(self.highest, int(tag[1:17], 16))
        self.latencies.append(now - int(tag[17:33], 16))
        struct.pack_into("<Q", self.credit, 0, len(self.latencies))

    def json(self):
        ordered, count = sorted(self.latencies), len(self.latencies)
        return json.dumps({"count": count, "seconds": (self.last - self.first) / 1e9, "p50": ordered[count // 2], "p99": ordered[int(0.99 * (count - 1))]}
                          if count > 1 else {"count": count, "seconds": 1, "p50": 0, "p99": 0})


def serve(arrivals, subscribe):
    """Each line "KIND TOPIC" begins to count what comes on a topic, and "report" tells it."""
    known, current = set(), [None]
    for line in sys.stdin:
        words = line.split()
        if words == ["report"]:
            current[0] = None
            print(arrivals.json(), flush=True)
            continue
        arrivals.clear()
        current[0] = words[1]
        if words[1] not in known:
            known.add(words[1])
            subscribe(words[0] == "image", words[1], lambda tag, topic=words[1]: arrivals.add(tag) if current[0] == topic else None)
        print("ok", flush=True)
