#!/usr/bin/env python3
"""Hears what a robot is commanded: one JSON line per message, with the time of this machine's clock."""
import json
import time

import rospy
from geometry_msgs.msg import Twist


def heard(message):
    print(json.dumps({"at": time.time(), "linear": message.linear.x, "angular": message.angular.z}), flush=True)


def main():
    rospy.init_node("commands", anonymous=True)
    rospy.Subscriber("/cmd_vel", Twist, heard, tcp_nodelay=True)
    print(json.dumps({"ready": True}), flush=True)
    rospy.spin()


if __name__ == "__main__":
    main()
