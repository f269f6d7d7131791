"""Tells a master of many topics, as a large robot's nodes do: many_topics.py TOPICS NODES. Registers only, but for one text that is said."""
import os
import sys
import xmlrpc.client

import rospy
from std_msgs.msg import String

topics, nodes = int(sys.argv[1]), int(sys.argv[2])
rospy.init_node("speaker")
speaker = rospy.Publisher("/sought/words", String, queue_size=1)
master = xmlrpc.client.ServerProxy(os.environ["ROS_MASTER_URI"])
# All of them are said to be where the speaker is, which knows none of their topics and says so when it is asked.
api = rospy.get_node_uri()
for number in range(topics):
    node = f"/part{number % nodes:03}"
    code, words, _ = master.registerPublisher(node, f"/part{number % nodes:03}/value{number // nodes:02}", "std_msgs/Float64", api)
    if code != 1:
        sys.exit(words)
print("registered", flush=True)
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    speaker.publish("here")
    rate.sleep()
