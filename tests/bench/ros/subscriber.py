"""The rospy subscriber. Reads lines "KIND TOPIC" and answers each with what it saw, as one JSON object."""
import json
import mmap
import os
import struct
import sys
import threading
import time

import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import String

READ_BUFFER = 4 << 20       # with rospy's default of 64 KiB, a queue bound drops large messages


class Tally:
    """What came in while it was measured: from the first message of that phase to the one that ends it."""

    def __init__(self, credit):
        self.credit = credit
        self.done = threading.Event()
        self.latencies = []
        self.first = self.expected = self.start = self.seconds = self.cpu = None

    def add(self, tag):
        now = time.clock_gettime_ns(time.CLOCK_MONOTONIC)
        number = int(tag[1:17], 16)
        if tag[0] == "m":
            if self.first is None:
                self.first, self.start, self.cpu = number, now, time.process_time()
            self.latencies.append(now - int(tag[17:33], 16))
        elif tag[0] == "e":
            self.seconds = (now - self.start) / 1e9
            self.cpu = time.process_time() - self.cpu
            self.expected = number - self.first
        struct.pack_into("<Q", self.credit, 0, number + 1)
        if tag[0] == "e":
            self.done.set()

    def result(self):
        ordered = sorted(self.latencies)
        count = len(ordered)
        return {"count": count, "lost": self.expected - count, "seconds": self.seconds, "cpu": self.cpu,
                "p50": ordered[count // 2], "p99": ordered[int(0.99 * (count - 1))]}


def measure(kind, topic, credit):
    tally = Tally(credit)
    if kind == "image":
        subscriber = rospy.Subscriber(topic, Image, lambda m: tally.add(m.header.frame_id), queue_size=16,
                                      buff_size=READ_BUFFER, tcp_nodelay=True)
    else:
        subscriber = rospy.Subscriber(topic, String, lambda m: tally.add(m.data), queue_size=10000,
                                      buff_size=READ_BUFFER, tcp_nodelay=True)
    tally.done.wait()
    subscriber.unregister()
    return tally.result()


def main():
    file = os.open(sys.argv[1], os.O_RDWR)
    credit = mmap.mmap(file, 8)
    rospy.init_node("bench_rospy", disable_rosout=True, disable_signals=True)
    for line in sys.stdin:
        print(json.dumps(measure(*line.split(), credit)), flush=True)


if __name__ == "__main__":
    main()
