"""Publishes "<node> <number>" 20 times a second: talker.py NODE TOPIC."""
import sys

import rospy
from std_msgs.msg import String

rospy.init_node(sys.argv[1], disable_signals=False)
publisher = rospy.Publisher(sys.argv[2], String, queue_size=10)
rate = rospy.Rate(20)
number = 0
print("ready", flush=True)
while not rospy.is_shutdown():
    publisher.publish("%s %d" % (sys.argv[1], number))
    number += 1
    rate.sleep()
