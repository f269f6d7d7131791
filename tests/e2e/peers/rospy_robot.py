#!/usr/bin/env python3
"""A robot of rospy: a laser and odometry, ten times a second, until it is ended."""
import rospy
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan


def main():
    rospy.init_node("rospy_robot", disable_signals=False)
    scans = rospy.Publisher("scan", LaserScan, queue_size=1)
    odometries = rospy.Publisher("odom", Odometry, queue_size=1)
    rate = rospy.Rate(10)
    while not rospy.is_shutdown():
        now = rospy.Time.now()
        scans.publish(scan(now))
        odometries.publish(odometry(now))
        rate.sleep()


def scan(now):
    message = LaserScan(angle_min=-1.5, angle_max=1.5, angle_increment=0.1, range_min=0.1, range_max=10.0, ranges=[2.0] * 31)
    message.header.stamp = now
    message.header.frame_id = "base_link"
    return message


def odometry(now):
    message = Odometry(child_frame_id="base_link")
    message.header.stamp = now
    message.header.frame_id = "odom"
    message.pose.pose.orientation.w = 1.0
    return message


if __name__ == "__main__":
    main()
