"""Hears texts: listener.py TOPIC. Prints each."""
import sys

import rospy
from std_msgs.msg import String

rospy.init_node("listener", anonymous=True)
rospy.Subscriber(sys.argv[1], String, lambda message: print(message.data, flush=True))
rospy.spin()
