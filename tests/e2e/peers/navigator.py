#!/usr/bin/env python3
"""A node that drives robots which it knows by topics alone: navigator.py ros1|ros2 NAME... With rospy or rclpy it hears NAME/odom and NAME/scan, chooses a goal
where the scan sees most room, and publishes NAME/cmd_vel until the odometry says that the robot is there. Then it prints a line of JSON for each."""
import json
import math
import sys
import time

FAR, NEAR, ROOM = 0.6, 0.1, 0.5
PERIOD = 0.1


class Driver:
    """One robot: what was heard of it last, and what it is told."""

    def __init__(self, name):
        self.name, self.place, self.scan, self.goal, self.start = name, None, None, None, None
        self.scans, self.reached = 0, False

    def odometry(self, message):
        pose = message.pose.pose
        self.place = (pose.position.x, pose.position.y, 2 * math.atan2(pose.orientation.z, pose.orientation.w))

    def take(self, scan):
        self.scan = scan
        self.scans += 1

    def free(self, angle):
        """How far it can see within 20 degrees of a direction."""
        return min((distance for number, distance in enumerate(self.scan.ranges)
                    if abs(self.scan.angle_min + number * self.scan.angle_increment - angle) < math.radians(20) and distance > self.scan.range_min), default=0)

    def choose(self):
        angles = [math.radians(each) for each in range(-60, 61, 10)]
        angle = max(angles, key=self.free)
        distance = min(FAR, self.free(angle) - ROOM)
        if distance > 2 * NEAR:
            x, y, heading = self.start = self.place
            self.goal = (x + distance * math.cos(heading + angle), y + distance * math.sin(heading + angle))

    def command(self):
        """Forward and turning speed now."""
        if self.place is None or self.scan is None or self.reached:
            return 0.0, 0.0
        if self.goal is None:
            self.choose()
            return 0.0, 0.0
        x, y, heading = self.place
        left = math.hypot(self.goal[0] - x, self.goal[1] - y)
        if left < NEAR:
            self.reached = True
            print(json.dumps({"robot": self.name, "moved": round(math.dist(self.start[:2], (x, y)), 2), "left": round(left, 3), "scans": self.scans}), flush=True)
            return 0.0, 0.0
        off = math.remainder(math.atan2(self.goal[1] - y, self.goal[0] - x) - heading, 2 * math.pi)
        return (min(0.25, left) if abs(off) < 0.4 else 0.0), max(-0.6, min(0.6, 1.2 * off))


class Ros1:
    def __init__(self, drivers):
        import rospy
        from geometry_msgs.msg import Twist
        from nav_msgs.msg import Odometry
        from sensor_msgs.msg import LaserScan
        rospy.init_node("navigator")
        self.rospy, self.twist = rospy, Twist
        for each in drivers:
            rospy.Subscriber(f"{each.name}/odom", Odometry, each.odometry)
            rospy.Subscriber(f"{each.name}/scan", LaserScan, each.take)
        self.commands = {each.name: rospy.Publisher(f"{each.name}/cmd_vel", Twist, queue_size=1) for each in drivers}

    def goes_on(self):
        time.sleep(PERIOD)
        return not self.rospy.is_shutdown()


class Ros2:
    def __init__(self, drivers):
        import rclpy
        from geometry_msgs.msg import Twist
        from nav_msgs.msg import Odometry
        from sensor_msgs.msg import LaserScan
        rclpy.init()
        self.rclpy, self.twist, self.node = rclpy, Twist, rclpy.create_node("navigator")
        for each in drivers:
            self.node.create_subscription(Odometry, f"{each.name}/odom", each.odometry, 10)
            self.node.create_subscription(LaserScan, f"{each.name}/scan", each.take, 10)
        self.commands = {each.name: self.node.create_publisher(Twist, f"{each.name}/cmd_vel", 10) for each in drivers}

    def goes_on(self):
        end = time.monotonic() + PERIOD
        while self.rclpy.ok() and time.monotonic() < end:
            self.rclpy.spin_once(self.node, timeout_sec=max(0.0, end - time.monotonic()))
        return self.rclpy.ok()


def main():
    drivers = [Driver(name) for name in sys.argv[2:]]
    node = {"ros1": Ros1, "ros2": Ros2}[sys.argv[1]](drivers)
    while node.goes_on():
        for each in drivers:
            told = each.reached
            speed, turn = each.command()
            if not told:                                # the last one that it is told is to stand
                command = node.twist()
                command.linear.x, command.angular.z = speed, turn
                node.commands[each.name].publish(command)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
