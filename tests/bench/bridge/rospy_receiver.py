"""Receives as a node of ROS 1."""
import sys

import rospy
from arrivals import Arrivals, serve
from sensor_msgs.msg import Image
from std_msgs.msg import String


def subscribe(image, topic, hear):
    rospy.Subscriber(topic, Image if image else String, lambda m: hear(m.header.frame_id if image else m.data), buff_size=4 << 20, tcp_nodelay=True)


rospy.init_node("bench_receiver", disable_signals=True)
serve(Arrivals(sys.argv[1]), subscribe)
