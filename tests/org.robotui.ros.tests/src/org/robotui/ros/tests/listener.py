"""Prints what it hears and from whom: listener.py NODE TOPIC."""
import sys

import rospy
from std_msgs.msg import String

rospy.init_node(sys.argv[1])
rospy.Subscriber(sys.argv[2], String, lambda m: print(m._connection_header["callerid"], m.data, flush=True))
print("ready", flush=True)
rospy.spin()
