"""Sends as a node of ROS 2, told and answering as sender.cpp does: what the receiver of ROS 2 takes without a bridge."""
import array
import mmap
import struct
import sys
import time

import rclpy
from rclpy.qos import QoSProfile
from sensor_msgs.msg import Image
from std_msgs.msg import String

GIVEN_UP, PATIENCE = 0.5, 30


class Sender:
    def __init__(self, node, credit, image, topic):
        self.credit, self.window = credit, 4 if image else 32
        self.message = Image(height=1024, width=1024, step=1024, encoding="mono8", data=array.array("B", bytes([7]) * (1 << 20))) if image else String()
        self.image = image
        self.publisher = node.create_publisher(type(self.message), topic, QoSProfile(depth=100))

    def arrived(self):
        return struct.unpack_from("<Q", self.credit, 0)[0]

    def send(self, number):
        tag = f"m{number:016x}{time.clock_gettime_ns(time.CLOCK_MONOTONIC):016x}"
        if self.image:
            self.message.header.frame_id = tag
        else:
            self.message.data = tag + "." * (96 - len(tag))
        self.publisher.publish(self.message)

    def touch(self):
        struct.pack_into("<Q", self.credit, 0, 0)
        end = time.monotonic() + PATIENCE
        while not self.arrived():
            if time.monotonic() > end:
                raise RuntimeError("nothing arrives")
            self.send(0)
            time.sleep(0.05)
        return 1

    def run(self, rate, seconds):
        struct.pack_into("<Q", self.credit, 0, 0)
        start, number, given_up = time.monotonic(), 0, 0
        while time.monotonic() < start + seconds:
            if rate:
                time.sleep(max(0, start + number / rate - time.monotonic()))
            patience = time.monotonic() + GIVEN_UP
            while not rate and number - given_up >= self.arrived() + self.window:
                if time.monotonic() > patience:
                    given_up = number - self.arrived()
                time.sleep(20e-6)
            self.send(number)
            number += 1
        return number


def main():
    with open(sys.argv[1], "r+b") as file:
        credit = mmap.mmap(file.fileno(), 8)
    rclpy.init()
    node, senders = rclpy.create_node("bench_sender"), {}
    for line in sys.stdin:
        kind, topic, rate, *seconds = line.split()
        try:
            sender = senders.get(topic) or Sender(node, credit, kind == "image", topic)
            senders[topic] = sender
            print(sender.touch() if rate == "touch" else sender.run(float(rate), float(seconds[0])), flush=True)
        except RuntimeError as e:
            print(f"error: {e}", flush=True)


main()
