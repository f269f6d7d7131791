"""The half of a bridge of few lines that speaks ROS 2."""
import array
import struct
import sys

import rclpy
from rclpy.qos import QoSProfile
from sensor_msgs.msg import Image
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("bench_half")
publishers = {False: node.create_publisher(String, "/bench/python/small_out", QoSProfile(depth=100)),
              True: node.create_publisher(Image, "/bench/python/image_out", QoSProfile(depth=100))}
while head := sys.stdin.buffer.read(9):
    image, length, size = struct.unpack("<?II", head)
    text, data = sys.stdin.buffer.read(length).decode(), sys.stdin.buffer.read(size)
    message = Image(height=1024, width=1024, step=1024, encoding="mono8", data=array.array("B", data)) if image else String(data=text)
    if image:
        message.header.frame_id = text
    publishers[image].publish(message)
