#!/usr/bin/env python3
"""A robot of rospy whose every step can be accounted for: it moves only as it is commanded, and publishes where it is.

Odometry and a scan come ten times a second, with the number of the step in their headers, and in the intensities of a scan. A second node (--driver) makes
it drive in a figure of eight, and is the only one that commands it. With --no-queues it also sends pictures, and waits for all its
subscribers; with --lights it offers a service.
"""
import math
import sys

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Image, LaserScan
from std_srvs.srv import SetBool, SetBoolResponse

RATE = 10.0
TIME_OUT = 0.5


class Robot:
    """Unicycle; the time step is fixed, so that the place depends on the commands alone."""

    def __init__(self):
        self.x = self.y = self.heading = 0.0
        self.command = Twist()
        self.since = rospy.Time()
        rospy.Subscriber("cmd_vel", Twist, self.take, tcp_nodelay=True)

    def take(self, command):
        self.command, self.since = command, rospy.Time.now()

    def step(self):
        if (rospy.Time.now() - self.since).to_sec() > TIME_OUT:
            self.command = Twist()
        self.heading += self.command.angular.z / RATE
        self.x += self.command.linear.x * math.cos(self.heading) / RATE
        self.y += self.command.linear.x * math.sin(self.heading) / RATE

    def odometry(self):
        message = Odometry(child_frame_id="base_link")
        message.header.stamp = rospy.Time.now()
        message.header.frame_id = "odom"
        message.pose.pose.position.x, message.pose.pose.position.y = self.x, self.y
        message.pose.pose.orientation.z, message.pose.pose.orientation.w = math.sin(self.heading / 2), math.cos(self.heading / 2)
        message.twist.twist.linear.x, message.twist.twist.angular.z = self.command.linear.x, self.command.angular.z
        return message


def scan(number):
    message = LaserScan(angle_min=-1.5, angle_max=1.5, angle_increment=0.01, range_min=0.1, range_max=10.0, ranges=[2.0] * 301,
                        intensities=[float(number)] * 301)
    message.header.stamp = rospy.Time.now()
    message.header.frame_id = "base_link"
    return message


def image():
    message = Image(width=320, height=240, encoding="rgb8", step=960, data=bytes(960 * 240))
    message.header.stamp = rospy.Time.now()
    message.header.frame_id = "camera"
    return message


def live():
    rospy.init_node("accountable_robot")
    if "--lights" in sys.argv:
        rospy.Service("set_lights", SetBool, lambda request: SetBoolResponse(True, f"lights are {request.data}"))
    queue = None if "--no-queues" in sys.argv else 1        # without one, whoever publishes waits for all subscribers
    odometries = rospy.Publisher("odom", Odometry, queue_size=queue)
    scans = rospy.Publisher("scan", LaserScan, queue_size=queue)
    images = rospy.Publisher("image", Image, queue_size=None) if queue is None else None
    robot, rate, step = Robot(), rospy.Rate(RATE), 0
    while not rospy.is_shutdown():
        robot.step()
        odometries.publish(robot.odometry())
        scans.publish(scan(step))
        if images:
            images.publish(image())
        step += 1
        rate.sleep()


def drive():
    rospy.init_node("driver")
    commands = rospy.Publisher("cmd_vel", Twist, queue_size=1)
    rate, step = rospy.Rate(RATE), 0
    while not rospy.is_shutdown():
        command = Twist()
        command.linear.x, command.angular.z = 0.2, 0.6 if step // 100 % 2 == 0 else -0.6
        commands.publish(command)
        step += 1
        rate.sleep()


if __name__ == "__main__":
    drive() if "--driver" in sys.argv else live()
