"""Offers std_srvs/SetBool, and refuses to switch off: server.py NODE SERVICE."""
import sys

import rospy
from std_srvs.srv import SetBool, SetBoolResponse


def handle(request):
    if not request.data:
        raise rospy.ServiceException("it stays on")
    return SetBoolResponse(True, "on by " + request._connection_header["callerid"])


rospy.init_node(sys.argv[1])
rospy.Service(sys.argv[2], SetBool, handle)
print("ready", flush=True)
rospy.spin()
