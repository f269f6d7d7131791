#!/usr/bin/env python3
"""Sends a map five times a second until it is ended: the one of the kind that a file names. Also says where odometry and laser are in it."""
import pathlib
import sys

import rospy
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid
from tf2_msgs.msg import TFMessage

SIZE = 100
# The length of a cell and the place of the first one, metres.
KINDS = {"good": (0.1, -5.0), "coarse": (1e30, -5.0), "far": (0.1, 1e300), "nowhere": (0.1, float("nan"))}


def main():
    rospy.init_node("rospy_map")
    maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
    transforms = rospy.Publisher("tf_static", TFMessage, queue_size=1, latch=True)
    transforms.publish(TFMessage([same("map", "odom"), same("odom", "base_link")]))
    wanted = pathlib.Path(sys.argv[1])
    messages = {kind: grid(*numbers) for kind, numbers in KINDS.items()}
    rate = rospy.Rate(5)
    while not rospy.is_shutdown():
        maps.publish(messages[wanted.read_text()])
        rate.sleep()


def grid(resolution, first):
    """A room: free, with a wall to the left and one to the right."""
    message = OccupancyGrid()
    message.header.frame_id = "map"
    message.info.resolution = resolution
    message.info.width = message.info.height = SIZE
    message.info.origin.position.x = first
    message.info.origin.position.y = -5.0
    message.info.origin.orientation.w = 1.0
    message.data = [0 if 10 < i % SIZE < 90 else 100 for i in range(SIZE * SIZE)]
    return message


def same(parent, child):
    """Two frames that lie on each other."""
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.transform.rotation.w = 1.0
    return message


if __name__ == "__main__":
    main()
