"""A client of FollowJointTrajectory, by actionlib's own library: follow_trajectory.py ACTION once|all. Prints what came of it as JSON.

No package of Debian has control_msgs: its classes are made from the definitions of this repository, as rosbag makes those of a bag.
"""
import json
import pathlib
import sys

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from genpy.dynamic import generate_dynamic

DEFINITIONS = pathlib.Path(__file__).parents[3] / "bundles/org.robotui.message/src/org/robotui/message/definitions"
ACTION = "control_msgs/FollowJointTrajectoryAction"
NESTED = (*(f"control_msgs/FollowJointTrajectory{part}" for part in ("ActionGoal", "ActionResult", "ActionFeedback", "Goal", "Result", "Feedback")),
          "control_msgs/JointTolerance", "trajectory_msgs/JointTrajectory", "trajectory_msgs/JointTrajectoryPoint",
          "actionlib_msgs/GoalID", "actionlib_msgs/GoalStatus", "std_msgs/Header")


def text_of(message):
    return (DEFINITIONS / f"{message}.msg").read_text()


TYPES = generate_dynamic(ACTION, text_of(ACTION) + "".join(f"{'=' * 80}\nMSG: {each}\n{text_of(each)}" for each in NESTED))
Goal, Point, Tolerance = (TYPES["control_msgs/FollowJointTrajectoryGoal"], TYPES["trajectory_msgs/JointTrajectoryPoint"],
                          TYPES["control_msgs/JointTolerance"])


def goal_of(joints, *points, **tolerances):
    """Points are pairs of a time and positions; tolerances `path` and `goal` are of all joints."""
    goal = Goal()
    goal.trajectory.joint_names = joints
    goal.trajectory.points = [Point(positions=positions, time_from_start=rospy.Duration(time)) for time, positions in points]
    for name, position in tolerances.items():
        setattr(goal, f"{name}_tolerance", [Tolerance(name=joint, position=position) for joint in joints])
    return goal


class Client:
    def __init__(self, action):
        self.client = actionlib.SimpleActionClient(action, TYPES[ACTION])
        if not self.client.wait_for_server(rospy.Duration(30)):
            sys.exit("no server")
        self.feedback = []

    def send(self, goal):
        self.feedback = []
        self.client.send_goal(goal, feedback_cb=self.feedback.append)
        return self

    def acknowledged(self):
        """Until the server has said that it knows the goal: a client that cancels earlier takes it for lost."""
        end = rospy.get_time() + 30
        while self.client.gh.get_comm_state() == actionlib.CommState.WAITING_FOR_GOAL_ACK:
            if rospy.get_time() > end:
                sys.exit("the goal was never acknowledged")
            rospy.sleep(0.02)

    def ended(self):
        if not self.client.wait_for_result(rospy.Duration(60)):
            sys.exit("no result")
        result = self.client.get_result()
        return {"state": GoalStatus.to_string(self.client.get_state()), "code": result.error_code, "text": result.error_string}

    def await_position(self, joint, beyond):
        """Until the joint was seen beyond it on its way."""
        end = rospy.get_time() + 30
        while rospy.get_time() < end:
            if any(each.actual.positions[each.joint_names.index(joint)] > beyond for each in list(self.feedback)):
                return
            rospy.sleep(0.02)
        sys.exit(f"{joint} was never seen beyond {beyond}: {self.feedback[-1:]}")


def main():
    rospy.init_node("planner", anonymous=True)
    action = sys.argv[1]
    arm = Client(action)
    yaw, pitch = "shoulder_yaw", "elbow_pitch"
    if sys.argv[2] == "once":
        print(json.dumps(arm.send(goal_of([yaw], (1, [0.1]))).ended()))
        return
    said = {}

    said["done"] = arm.send(goal_of([yaw, pitch], (0.4, [0.2, 0.2]), (0.8, [0.4, 0.3]))).ended()
    last = arm.feedback[-1]
    said["feedback"] = {"joints": last.joint_names, "desired": last.desired.positions, "actual": last.actual.positions,
                        "error": last.error.positions, "count": len(arm.feedback), "time": last.desired.time_from_start.to_sec()}

    said["unknown"] = arm.send(goal_of(["tail"], (1, [0.1]))).ended()
    said["beyond"] = arm.send(goal_of([yaw], (1, [99]))).ended()
    said["fast"] = arm.send(goal_of([yaw], (0.01, [0]))).ended()
    old = goal_of([yaw], (1, [0]))
    old.trajectory.header.stamp = rospy.Time.now() - rospy.Duration(10)
    said["old"] = arm.send(old).ended()

    # Another client's goal takes over, one that is refused does not. Those that are ended early would take a minute.
    other = Client(action)
    arm.send(goal_of([yaw, pitch], (60, [1.2, 0.3]))).await_position(yaw, 0.402)
    said["left out"] = other.send(goal_of([pitch], (1, [0.5]))).ended()
    other.send(goal_of([yaw, pitch], (1.5, [0.6, 0.5])))
    said["preempted"] = arm.ended()
    said["taken over"] = other.ended()

    arm.send(goal_of([yaw], (60, [1.5]))).await_position(yaw, 0.602)
    arm.client.cancel_goal()
    said["cancelled"] = arm.ended()

    later = goal_of([yaw], (1, [0]))
    later.trajectory.header.stamp = rospy.Time.now() + rospy.Duration(30)
    arm.send(later).acknowledged()
    arm.client.cancel_goal()
    said["recalled"] = arm.ended()

    # The hardware of this simulation follows a cycle later: nothing is that near.
    said["path"] = arm.send(goal_of([yaw], (1, [0]), path=1e-9)).ended()
    print(json.dumps(said))


main()
