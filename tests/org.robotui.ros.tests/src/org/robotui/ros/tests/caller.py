"""Calls std_srvs/SetBool with true twice and false once over one connection: caller.py NODE SERVICE."""
import sys

import rospy
from std_srvs.srv import SetBool

rospy.init_node(sys.argv[1])
rospy.wait_for_service(sys.argv[2], timeout=10)
call = rospy.ServiceProxy(sys.argv[2], SetBool, persistent=True)
for data in (True, True, False):
    try:
        answer = call(data)
        print("answer", answer.success, answer.message, flush=True)
    except rospy.ServiceException as e:
        print("refused", e, flush=True)
print("done", flush=True)
