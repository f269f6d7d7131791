"""A robot of ROS 2 for tests: topics, services, parameters and a node with a life cycle.

It says on standard output what it hears; a line on standard input ends it.
"""
import sys
import threading

import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import BatteryState
from std_msgs.msg import String
from std_srvs.srv import SetBool


def say(*words):
    print(*words, flush=True)


class Robot:

    def __init__(self):
        self.node = rclpy.create_node("base", namespace="/robot")
        self.node.declare_parameter("speed", 1.0, ParameterDescriptor(
            description="m/s", floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0, step=0.5)]))
        self.node.declare_parameter("count", 3, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=10, step=1)]))
        self.node.declare_parameter("words", ["a", "b"])
        self.node.declare_parameter("flags", [True, False])
        self.node.declare_parameter("bytes", [b"\x01", b"\xff"])
        self.node.declare_parameter("fixed", "so", ParameterDescriptor(read_only=True))
        self.battery = self.node.create_publisher(BatteryState, "battery", QoSProfile(
            depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))
        late = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.node.create_publisher(String, "description", late).publish(String(data="<robot/>"))
        self.node.create_subscription(String, "/words", lambda m: say("heard", m.data), 10)
        self.node.create_service(SetBool, "switch", self.switch)
        self.client = self.node.create_client(SetBool, "/ours")
        self.asked = False
        self.number = 0
        self.node.create_timer(0.1, self.tick)

    def switch(self, request, response):
        response.success = not request.data
        response.message = "switched"
        return response

    def tick(self):
        self.number += 1
        message = BatteryState(percentage=0.5, serial_number=str(self.number))
        message.header.stamp = self.node.get_clock().now().to_msg()
        self.battery.publish(message)
        if not self.asked and self.client.service_is_ready():
            self.asked = True
            say("asking")
            future = self.client.call_async(SetBool.Request(data=True))
            future.add_done_callback(lambda done: say("answered", done.result().success, done.result().message))


def main():
    rclpy.init()
    robot = Robot()
    arm = LifecycleNode("arm", namespace="/robot")
    executor = SingleThreadedExecutor()
    executor.add_node(robot.node)
    executor.add_node(arm)
    threading.Thread(target=executor.spin, daemon=True).start()
    say("ready")
    sys.stdin.readline()
    say("nodes", *sorted(space + "/" + name for name, space in robot.node.get_node_names_and_namespaces()))
    executor.shutdown()
    rclpy.shutdown()


main()
