"""Publishes one latched message: latcher.py NODE TOPIC TEXT."""
import sys

import rospy
from std_msgs.msg import String

rospy.init_node(sys.argv[1])
publisher = rospy.Publisher(sys.argv[2], String, latch=True, queue_size=1)
publisher.publish(sys.argv[3])
print("ready", flush=True)
rospy.spin()
