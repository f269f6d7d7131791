"""The half of a bridge of few lines that hears ROS 1: the types of both generations have the same names, so that no program can load both."""
import struct
import sys

import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import String


def forward(image, message):
    text, data = (message.header.frame_id, message.data) if image else (message.data, b"")
    sys.stdout.buffer.write(struct.pack("<?II", image, len(text), len(data)) + text.encode())
    sys.stdout.buffer.write(data)
    sys.stdout.buffer.flush()


rospy.init_node("bench_half")
for kind, name in ((False, "small"), (True, "image")):
    rospy.Subscriber(f"/bench/python/{name}", Image if kind else String, lambda m, image=kind: forward(image, m), buff_size=4 << 20, tcp_nodelay=True)
rospy.spin()
