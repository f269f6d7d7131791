#!/usr/bin/env python3
"""A program of ROS 2 on the far side of a bridge: it hears a scan that comes from elsewhere, says a text that is kept, and
drives (--drive). Every half second a line of JSON says what it has heard."""
import json
import sys
import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def main():
    rclpy.init()
    node = rclpy.create_node("visitor")
    heard = {"scans": 0, "gaps": 0}
    last = {"stamp": None}

    def take(scan):
        stamp = scan.header.stamp.sec + scan.header.stamp.nanosec * 1e-9
        heard["scans"] += 1
        heard["gaps"] += last["stamp"] is not None and stamp - last["stamp"] > 0.18
        heard.update(frame=scan.header.frame_id, rays=len(scan.ranges), first=round(scan.angle_min, 3), age=round(time.time() - stamp, 3))
        last["stamp"] = stamp
    node.create_subscription(LaserScan, "natalie/scan", take, 10)
    node.create_publisher(String, "greeting", LATCHED).publish(String(data="hello from ROS 2"))
    drive = node.create_publisher(Twist, "drive", 10)
    command = Twist()
    command.linear.x = 5.0
    told = time.monotonic()
    driving = "--drive" in sys.argv
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.02)
        if driving:
            drive.publish(command)
        if time.monotonic() - told > 0.5:
            told = time.monotonic()
            print(json.dumps(heard), flush=True)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
