#!/usr/bin/env python3
"""Serves move_base by actionlib's own server, and has goals of an action of another robot carried out by actionlib's own client:
rospy_actions.py ACTION. A goal at x < 0 is rejected, one beyond 100 goes on until it is cancelled. Prints how each goal ended as JSON."""
import json
import pathlib
import sys
import threading

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from genpy.dynamic import generate_dynamic

DEFINITIONS = pathlib.Path(__file__).parents[3] / "bundles/org.robotui.message/src/org/robotui/message/definitions"
ACTION = "move_base_msgs/MoveBaseAction"
NESTED = (*(f"move_base_msgs/MoveBase{part}" for part in ("ActionGoal", "ActionResult", "ActionFeedback", "Goal", "Result", "Feedback")),
          "actionlib_msgs/GoalID", "actionlib_msgs/GoalStatus", "std_msgs/Header",
          *(f"geometry_msgs/{part}" for part in ("PoseStamped", "Pose", "Point", "Quaternion")))


def text_of(message):
    return (DEFINITIONS / f"{message}.msg").read_text() + "\n"         # a result may be empty


TYPES = generate_dynamic(ACTION, text_of(ACTION) + "".join(f"{'=' * 80}\nMSG: {each}\n{text_of(each)}" for each in NESTED))
Goal, Feedback, Result = (TYPES[f"move_base_msgs/MoveBase{part}"] for part in ("Goal", "Feedback", "Result"))


class Server:
    def __init__(self):
        self.cancelled = {}
        self.server = actionlib.ActionServer("move_base", TYPES[ACTION], self.take, self.cancel, auto_start=False)
        self.server.start()

    def take(self, goal):
        if goal.get_goal().target_pose.pose.position.x < 0:
            goal.set_rejected(Result(), "it lies behind")
            return
        goal.set_accepted()
        self.cancelled[goal.get_goal_id().id] = threading.Event()
        threading.Thread(target=self.work, args=[goal], daemon=True).start()

    def cancel(self, goal):
        self.cancelled[goal.get_goal_id().id].set()

    def work(self, goal):
        target, end = goal.get_goal().target_pose, self.cancelled[goal.get_goal_id().id]
        for _ in range(5):
            goal.publish_feedback(Feedback(base_position=target))
            rospy.sleep(0.1)
        if target.pose.position.x > 100:
            end.wait()
            goal.set_canceled(Result(), "as asked")
        else:
            goal.set_succeeded(Result(), "there")


def ended(client, x, cancel=False):
    feedback, goal = [], Goal()
    goal.target_pose.header.frame_id, goal.target_pose.pose.position.x = "map", x
    client.send_goal(goal, feedback_cb=feedback.append)
    while cancel and not feedback:
        rospy.sleep(0.02)
    if cancel:
        client.cancel_goal()
    if not client.wait_for_result(rospy.Duration(60)):
        sys.exit("no result")
    seen = sorted({(each.base_position.header.frame_id, each.base_position.pose.position.x) for each in feedback})
    return [GoalStatus.to_string(client.get_state()), client.get_goal_status_text(), seen]


def main():
    rospy.init_node("actions")
    server = Server()
    client = actionlib.SimpleActionClient(sys.argv[1], TYPES[ACTION])
    if not client.wait_for_server(rospy.Duration(180)):
        sys.exit("no server")
    print(json.dumps({"reached": ended(client, 2.0), "cancelled": ended(client, 1000.0, True), "rejected": ended(client, -1.0)}), flush=True)
    rospy.spin()
    del server


if __name__ == "__main__":
    main()
