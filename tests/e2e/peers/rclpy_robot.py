#!/usr/bin/env python3
"""A robot of rclpy: laser, odometry, map, battery, log and a parameter; it drives as it is told, until it is killed.

It says on standard output what it hears, and once a second which nodes it sees. With --numbers it sends 100 poses a second, reliably, whose stamps are 0.01 s
apart, whenever it sends them.
"""
import contextlib
import math
import sys

import rclpy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.executors import ExternalShutdownException
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import BatteryState, LaserScan
from std_msgs.msg import String
from std_srvs.srv import SetBool

PERIOD = 0.1
# A base stops by itself when it is told nothing any more.
PATIENCE = 0.5
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def say(*words):
    print(*words, flush=True)


class Base:

    def __init__(self):
        self.node = rclpy.create_node("base")
        self.scans = self.node.create_publisher(LaserScan, "scan", qos_profile_sensor_data)
        self.odometries = self.node.create_publisher(Odometry, "odom", 10)
        self.batteries = self.node.create_publisher(BatteryState, "battery_state", qos_profile_sensor_data)
        self.maps = self.node.create_publisher(OccupancyGrid, "map", LATCHED)
        self.descriptions = self.node.create_publisher(String, "robot_description", LATCHED)
        self.node.declare_parameter("speed", 0.5, ParameterDescriptor(
            description="m/s", floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0, step=0.0)]))
        self.node.create_subscription(Twist, "cmd_vel", self.drive, 1)
        self.node.create_subscription(PoseStamped, "goal_pose", self.go, 1)
        self.node.create_subscription(PoseWithCovarianceStamped, "initialpose", lambda pose: say("estimate"), 1)
        self.node.create_service(SetBool, "motors", self.motors)
        self.x = self.y = self.yaw = self.linear = self.angular = 0.0
        self.told = -math.inf
        self.ticks = 0
        self.maps.publish(self.map())
        self.descriptions.publish(String(data="<robot name='base'><link name='base_link'/></robot>"))
        self.node.create_timer(PERIOD, self.tick)
        if "--numbers" in sys.argv:
            self.numbers = self.node.create_publisher(PoseStamped, "numbers", QoSProfile(depth=1000))
            self.count = 0
            self.node.create_timer(0.01, self.number)

    def now(self):
        return self.node.get_clock().now()

    def drive(self, twist):
        self.linear, self.angular = twist.linear.x, twist.angular.z
        self.told = self.now().nanoseconds * 1e-9
        say("drive", self.linear, self.angular)

    @staticmethod
    def go(goal):
        say("goal", goal.header.frame_id, goal.pose.position.x, goal.pose.position.y)

    @staticmethod
    def motors(request, response):
        response.success = request.data
        response.message = "motors"
        return response

    def tick(self):
        if self.now().nanoseconds * 1e-9 - self.told > PATIENCE:
            self.linear = self.angular = 0.0
        self.yaw += self.angular * PERIOD
        self.x += self.linear * PERIOD * math.cos(self.yaw)
        self.y += self.linear * PERIOD * math.sin(self.yaw)
        self.scans.publish(self.stamped(LaserScan(angle_min=-1.5, angle_max=1.5, angle_increment=0.1, range_min=0.1,
                                                  range_max=10.0, ranges=[2.0] * 31), "odom"))
        self.odometries.publish(self.odometry())
        self.batteries.publish(self.stamped(BatteryState(voltage=24.0, percentage=0.5, present=True), ""))
        self.ticks += 1
        if self.ticks % 10 == 0:
            self.node.get_logger().warning(f"at {self.x:.2f}")
            say("nodes", *sorted(self.node.get_node_names()))

    def number(self):
        self.count += 1
        pose = PoseStamped()
        pose.header.stamp.sec, pose.header.stamp.nanosec = self.count // 100, self.count % 100 * 10_000_000
        self.numbers.publish(pose)

    def stamped(self, message, frame):
        message.header.stamp = self.now().to_msg()
        message.header.frame_id = frame
        return message

    def odometry(self):
        message = self.stamped(Odometry(child_frame_id="base_link"), "odom")
        message.pose.pose.position.x = self.x
        message.pose.pose.position.y = self.y
        message.pose.pose.orientation.z = math.sin(self.yaw / 2)
        message.pose.pose.orientation.w = math.cos(self.yaw / 2)
        message.twist.twist.linear.x = self.linear
        message.twist.twist.angular.z = self.angular
        return message

    def map(self):
        message = self.stamped(OccupancyGrid(data=[0] * 10_000), "odom")
        message.info.resolution = 0.1
        message.info.width = message.info.height = 100
        message.info.origin.position.x = message.info.origin.position.y = -5.0
        message.info.origin.orientation.w = 1.0
        return message


def main():
    rclpy.init()
    base = Base()
    say("ready")
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(base.node)


if __name__ == "__main__":
    main()
