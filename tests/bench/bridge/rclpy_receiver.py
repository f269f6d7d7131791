"""Receives as a node of ROS 2."""
import sys
import threading

import rclpy
from arrivals import Arrivals, serve
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image
from std_msgs.msg import String

RELIABLE = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE)

rclpy.init()
node = rclpy.create_node("bench_receiver")
threading.Thread(target=rclpy.spin, args=[node], daemon=True).start()
serve(Arrivals(sys.argv[1]), lambda image, topic, hear: node.create_subscription(
    Image if image else String, topic, lambda m: hear(m.header.frame_id if image else m.data), RELIABLE))
