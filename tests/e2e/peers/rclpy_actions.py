#!/usr/bin/env python3
"""Serves navigate_to_pose by rclpy's own server, and has goals of an action of another robot carried out by rclpy's own client:
rclpy_actions.py ACTION. A goal at x < 0 is rejected, one beyond 100 goes on until it is cancelled. Prints how each goal ended as JSON."""
import json
import sys
import threading
import time

import rclpy
from action_msgs.msg import GoalStatus
from nav2_msgs.action import NavigateToPose
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor

NAMES = {GoalStatus.STATUS_SUCCEEDED: "SUCCEEDED", GoalStatus.STATUS_CANCELED: "CANCELED", GoalStatus.STATUS_ABORTED: "ABORTED"}


def taken(goal):
    return GoalResponse.REJECT if goal.pose.pose.position.x < 0 else GoalResponse.ACCEPT


def work(goal):
    target, count = goal.request.pose, 0
    while count < 5 or target.pose.position.x > 100 and not goal.is_cancel_requested:
        goal.publish_feedback(NavigateToPose.Feedback(current_pose=target))
        time.sleep(0.1)
        count += 1
    if goal.is_cancel_requested:
        goal.canceled()
    else:
        goal.succeed()
    return NavigateToPose.Result()


def awaited(future):
    end = time.monotonic() + 60
    while not future.done():
        if time.monotonic() > end:
            sys.exit("no answer")
        time.sleep(0.01)
    return future.result()


def ended(client, x, cancel=False):
    feedback, goal = [], NavigateToPose.Goal()
    goal.pose.header.frame_id, goal.pose.pose.position.x = "map", x
    handle = awaited(client.send_goal_async(goal, feedback_callback=lambda message: feedback.append(message.feedback.current_pose)))
    if not handle.accepted:
        return ["REJECTED", []]
    while cancel and not feedback:
        time.sleep(0.02)
    if cancel:
        awaited(handle.cancel_goal_async())
    state = awaited(handle.get_result_async()).status
    return [NAMES.get(state, state), sorted({(pose.header.frame_id, pose.pose.position.x) for pose in feedback})]


def main():
    rclpy.init()
    node = rclpy.create_node("actions")
    group = ReentrantCallbackGroup()
    ActionServer(node, NavigateToPose, "navigate_to_pose", work, callback_group=group, goal_callback=taken,
                 cancel_callback=lambda _: CancelResponse.ACCEPT)
    client = ActionClient(node, NavigateToPose, sys.argv[1], callback_group=group)
    executor = MultiThreadedExecutor(4)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin, daemon=True)
    spinning.start()
    if not client.wait_for_server(180):
        sys.exit("no server")
    print(json.dumps({"reached": ended(client, 2.0), "cancelled": ended(client, 1000.0, True), "rejected": ended(client, -1.0)}), flush=True)
    spinning.join()


if __name__ == "__main__":
    try:
        main()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
