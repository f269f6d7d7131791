"""Simulates time that starts at 100 s, and at 10 s again after a line on the standard input: clock.py."""
import sys
import threading

import rospy
from rosgraph_msgs.msg import Clock

start = [100.0]


def restart():
    sys.stdin.readline()
    start[0] = 10.0


rospy.set_param("/use_sim_time", True)
rospy.init_node("clock", disable_rostime=True)
publisher = rospy.Publisher("/clock", Clock, queue_size=10)
threading.Thread(target=restart, daemon=True).start()
print("ready", flush=True)
while not rospy.is_shutdown():
    publisher.publish(Clock(rospy.Time.from_sec(start[0])))
    start[0] += 0.01
    rospy.rostime.wallsleep(0.01)
