#!/usr/bin/env python3
"""An independent listener: one JSON line per message of the topics named, with when it came and what it said of the robot."""
import json
import sys
import threading
import time

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

TYPES = {"odom": Odometry, "scan": LaserScan, "cmd_vel": Twist}
ALONE = threading.Lock()


def hear(topic):
    def heard(message):
        line = {"topic": topic, "at": time.time(), "from": message._connection_header["callerid"]}
        if topic == "odom":
            place = message.pose.pose.position
            line.update(seq=message.header.seq, x=place.x, y=place.y, linear=message.twist.twist.linear.x)
        elif topic == "scan":
            line.update(seq=message.header.seq)
        with ALONE:                                 # each topic has a thread of its own
            print(json.dumps(line), flush=True)
    rospy.Subscriber(topic, TYPES[topic], heard, tcp_nodelay=True)


def main():
    rospy.init_node("witness", anonymous=True)
    for topic in sys.argv[1:]:
        hear(topic)
    rospy.spin()


if __name__ == "__main__":
    main()
