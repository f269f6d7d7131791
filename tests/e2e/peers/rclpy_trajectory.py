#!/usr/bin/env python3
"""A client of FollowJointTrajectory, by rclpy's own library: rclpy_trajectory.py ACTION. Prints what came of its goals as JSON."""
import json
import sys
import threading
import time

import rclpy
from action_msgs.msg import GoalStatus
from builtin_interfaces.msg import Duration
from control_msgs.action import FollowJointTrajectory
from control_msgs.msg import JointTolerance
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

NAMES = {GoalStatus.STATUS_SUCCEEDED: "SUCCEEDED", GoalStatus.STATUS_CANCELED: "CANCELED", GoalStatus.STATUS_ABORTED: "ABORTED"}
PATIENCE = 60
YAW, PITCH = "shoulder_yaw", "elbow_pitch"


def awaited(future):
    end = time.monotonic() + PATIENCE
    while not future.done():
        if time.monotonic() > end:
            sys.exit("no answer")
        time.sleep(0.01)
    return future.result()


def goal_of(joints, *points, path=0.0):
    """Points are pairs of a time and positions."""
    points = [JointTrajectoryPoint(positions=positions, time_from_start=Duration(sec=int(at), nanosec=int(at % 1 * 1e9))) for at, positions in points]
    return FollowJointTrajectory.Goal(trajectory=JointTrajectory(joint_names=joints, points=points),
                                      path_tolerance=[JointTolerance(name=joint, position=path) for joint in joints if path])


class Sent:
    def __init__(self, client, goal):
        self.feedback = []
        self.handle = awaited(client.send_goal_async(goal, feedback_callback=lambda message: self.feedback.append(message.feedback)))

    def ended(self):
        if not self.handle.accepted:
            return ["REJECTED", 0, ""]
        answer = awaited(self.handle.get_result_async())
        return [NAMES.get(answer.status, answer.status), answer.result.error_code, answer.result.error_string]

    def moving(self):
        end = time.monotonic() + PATIENCE
        while not any(abs(each.desired.velocities[0]) > 0 for each in list(self.feedback)):
            if time.monotonic() > end:
                sys.exit("it never moved")
            time.sleep(0.01)
        return self


def main():
    rclpy.init()
    node = rclpy.create_node("planner")
    client = ActionClient(node, FollowJointTrajectory, sys.argv[1])
    threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
    if not client.wait_for_server(180):
        sys.exit("no server")
    done = Sent(client, goal_of([YAW, PITCH], (0.4, [0.2, 0.2]), (0.8, [0.4, 0.3])))
    said = {"done": done.ended()}
    last = done.feedback[-1]
    said["feedback"] = {"joints": list(last.joint_names), "desired": list(last.desired.positions), "actual": list(last.actual.positions),
                        "error": list(last.error.positions), "count": len(done.feedback)}
    said["unknown"] = Sent(client, goal_of(["tail"], (1, [0.1]))).ended()
    said["beyond"] = Sent(client, goal_of([YAW], (1, [99.0]))).ended()
    cancelled = Sent(client, goal_of([YAW], (60, [1.5]))).moving()
    awaited(cancelled.handle.cancel_goal_async())
    said["cancelled"] = cancelled.ended()
    # The hardware of this simulation follows a cycle later: nothing is that near.
    said["path"] = Sent(client, goal_of([YAW], (1, [0.0]), path=1e-9)).ended()
    print(json.dumps(said), flush=True)


if __name__ == "__main__":
    try:
        main()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
