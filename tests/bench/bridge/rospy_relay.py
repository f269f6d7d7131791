"""A relay of few lines from ROS 1 to ROS 1."""
import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import String

rospy.init_node("bench_relay")
for kind, name in ((String, "small"), (Image, "image")):
    publisher = rospy.Publisher(f"/bench/rospy/{name}_out", kind, queue_size=100, tcp_nodelay=True)
    rospy.Subscriber(f"/bench/rospy/{name}", kind, publisher.publish, buff_size=4 << 20, tcp_nodelay=True)
rospy.spin()
