"""Drives with actionlib's own client: drive_to.py X Y FRAME [cancel after SECONDS]. Prints the end as JSON."""
import json
import sys

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal

rospy.init_node("driver", anonymous=True)
client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
if not client.wait_for_server(rospy.Duration(15)):
    sys.exit("no server")
goal = MoveBaseGoal()
goal.target_pose.header.frame_id = sys.argv[3]
goal.target_pose.pose.position.x = float(sys.argv[1])
goal.target_pose.pose.position.y = float(sys.argv[2])
goal.target_pose.pose.orientation.w = 1
feedback = []
client.send_goal(goal, feedback_cb=lambda message: feedback.append(message.base_position.pose.position.x))
if len(sys.argv) > 4:
    client.wait_for_result(rospy.Duration(float(sys.argv[4])))
    client.cancel_goal()
ended = client.wait_for_result(rospy.Duration(60))
print(json.dumps({"ended": ended, "state": GoalStatus.to_string(client.get_state()), "text": client.get_goal_status_text(),
                  "feedback": len(feedback)}))
