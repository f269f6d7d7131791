"""A node of ROS 2 for tests: a topic in, a topic out, as told on standard input; says on standard output what it hears.

Arguments: reliability (reliable, best_effort), durability (volatile, transient_local), history (a depth, or all; with :DEADLINE:LEASE
in milliseconds, liveliness is by topic, and it prints "late" and "alive COUNT" of the writers that it hears), domain, the topic
that it hears, and the one that it writes.
    meet WRITERS READERS        waits until it hears so many writers, and so many readers hear it, and prints "met"
    write COUNT SIZE PERIOD     writes so many strings of so many characters, one in each period (seconds)
    end                         ends in order
It prints "sent COUNT SLOWEST" when it has written, SLOWEST being the longest time that a write took, in seconds.
"""
import sys
import threading
import time

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String


SAYING = threading.Lock()


def say(*words):
    with SAYING:
        print(*words, flush=True)


WATCHING = SubscriptionEventCallbacks(deadline=lambda event: say("late"), liveliness=lambda event: say("alive", event.alive_count))


def quality(reliability, durability, history):
    history, *times = history.split(":")
    keeps_all = history == "all"
    deadline, lease = (Duration(nanoseconds=int(time) * 1_000_000) for time in times) if times else (Duration(), Duration())
    return QoSProfile(
        reliability=ReliabilityPolicy[reliability.upper()], durability=DurabilityPolicy[durability.upper()],
        history=HistoryPolicy.KEEP_ALL if keeps_all else HistoryPolicy.KEEP_LAST, depth=0 if keeps_all else int(history),
        deadline=deadline, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC if times else LivelinessPolicy.SYSTEM_DEFAULT,
        liveliness_lease_duration=lease)


def write(publisher, count, size, period):
    slowest = 0.0
    due = time.monotonic()
    for number in range(1, count + 1):
        time.sleep(max(0.0, due - time.monotonic()))
        due += period
        begin = time.monotonic()
        try:
            publisher.publish(String(data=f"p{number} " + "x" * size))
        except Exception as fault:  # the middleware's own class differs
            say("failed", number, str(fault).splitlines()[0])
        slowest = max(slowest, time.monotonic() - begin)
    say("sent", count, f"{slowest:.4f}")


def meet(writers, readers, writers_met, readers_met):
    while writers_met() < writers or readers_met() < readers:
        time.sleep(0.005)
    say("met")


def main():
    rclpy.init()
    node = rclpy.create_node("peer", enable_rosout=False, start_parameter_services=False)
    qos = quality(*sys.argv[1:4])
    subscription = node.create_subscription(String, sys.argv[5], lambda message: say("heard", message.data.split(" ")[0], len(message.data)), qos,
                                            event_callbacks=WATCHING if ":" in sys.argv[3] else None)
    publisher = node.create_publisher(String, sys.argv[6], qos)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    threading.Thread(target=executor.spin, daemon=True).start()
    say("ready")
    for line in sys.stdin:
        order, *figures = line.split()
        if order == "end":
            break
        if order == "meet":
            meet(int(figures[0]), int(figures[1]), subscription.get_publisher_count, publisher.get_subscription_count)
            continue
        write(publisher, int(figures[0]), int(figures[1]), float(figures[2]))
    executor.shutdown()
    node.destroy_node()
    rclpy.shutdown()


main()
