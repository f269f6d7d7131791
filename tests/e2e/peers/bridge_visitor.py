#!/usr/bin/env python3
"""A program of ROS 2 on the far side of a bridge: it hears a scan that comes from elsewhere, says a text that is kept,
offers a service and calls one, and drives (--drive). Every half second a line of JSON says what it has heard."""
import json
import sys
import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def reset(_, response):
    response.success, response.message = True, "reset by ROS 2"
    return response


def main():
    rclpy.init()
    node = rclpy.create_node("visitor")
    heard = {"scans": 0, "gaps": 0, "youngest": 1e9}
    last = {"number": None}

    def take(scan):
        stamp = scan.header.stamp.sec + scan.header.stamp.nanosec * 1e-9
        number = scan.intensities[0]                # as the robot counts them
        heard["scans"] += 1
        heard["gaps"] += last["number"] is not None and number > last["number"] + 1
        heard["youngest"] = min(heard["youngest"], round(time.time() - stamp, 3))
        heard.update(frame=scan.header.frame_id, rays=len(scan.ranges), first=round(scan.angle_min, 3))
        last["number"] = number
    node.create_subscription(LaserScan, "natalie/scan", take, 100)
    node.create_publisher(String, "greeting", LATCHED).publish(String(data="hello from ROS 2"))
    node.create_service(Trigger, "reset", reset)
    lights = node.create_client(SetBool, "lights")
    asked = None
    drive = node.create_publisher(Twist, "drive", 10)
    command = Twist()
    command.linear.x = 5.0
    told = time.monotonic()
    driving = "--drive" in sys.argv
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.02)
        if driving:
            drive.publish(command)
        if asked is None and lights.service_is_ready():
            asked = lights.call_async(SetBool.Request(data=True))
        elif asked and asked.done():
            heard["lights"] = [asked.result().success, asked.result().message]
        if time.monotonic() - told > 0.5:
            told = time.monotonic()
            heard["nodes"] = sorted(node.get_node_names())
            print(json.dumps(heard), flush=True)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
