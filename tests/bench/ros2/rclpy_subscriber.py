"""The subscriber of rclpy, told as subscriber.c is."""
import sys
import time

import rclpy
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image
from std_msgs.msg import String
from tally import Tally

RELIABLE = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE)


def measure(node, kind, topic):
    tally = Tally()
    image = kind == "image"
    name = topic.removeprefix("rt")
    subscription = node.create_subscription(Image if image else String, name,
                                            (lambda m: tally.add(m.header.frame_id)) if image else (lambda m: tally.add(m.data)), RELIABLE)
    while not tally.done.is_set():
        rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_subscription(subscription)
    return tally.json()


def discover(count):
    """With a context of its own, and so a participant of its own."""
    start = time.monotonic()
    context = rclpy.Context()
    context.init()
    node = rclpy.create_node("bench_discover", context=context, enable_rosout=False, start_parameter_services=False)
    while sum(name.startswith("/endpoint_") for name, _ in node.get_topic_names_and_types()) < count:
        time.sleep(0.0005)
    seconds = time.monotonic() - start
    node.destroy_node()
    context.shutdown()
    return f'{{"seconds": {seconds:.6f}}}'


def main():
    node = None
    for line in sys.stdin:
        words = line.split()
        if words[0] == "discover":
            if node:
                node.destroy_node()
                rclpy.shutdown()
                node = None
            print(discover(int(words[1])), flush=True)
        else:
            if not node:
                rclpy.init()
                node = rclpy.create_node("bench_rclpy")
            print(measure(node, *words), flush=True)


main()
