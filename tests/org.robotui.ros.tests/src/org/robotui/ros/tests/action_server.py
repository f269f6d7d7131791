"""Serves actionlib/TestAction: action_server.py NODE ACTION.

A negative goal is rejected, zero is aborted, one above 1000 stays pending; any other counts up to itself at 20 Hz.
A line on the standard input makes the server silent without ending its process.
"""
import os
import signal
import sys
import threading

import actionlib
import rospy
from actionlib.msg import TestAction, TestFeedback, TestResult

cancelled = set()


def count(handle, goal):
    rate = rospy.Rate(20)
    for i in range(goal):
        if handle.get_goal_id().id in cancelled:
            handle.set_canceled(TestResult(i), "stopped at %d" % i)
            return
        handle.publish_feedback(TestFeedback(i))
        rate.sleep()
    handle.set_succeeded(TestResult(goal), "counted")


def on_goal(handle):
    goal = handle.get_goal().goal
    print("goal", goal, handle.get_goal_id().id, flush=True)
    if goal < 0:
        handle.set_rejected(TestResult(), "no negative goals")
    elif goal == 0:
        handle.set_accepted("")
        handle.set_aborted(TestResult(7), "nothing to count")
    elif goal <= 1000:
        handle.set_accepted("counting")
        threading.Thread(target=count, args=(handle, goal), daemon=True).start()


def on_cancel(handle):
    print("cancel", handle.get_goal_id().id, flush=True)
    if handle.get_goal().goal > 1000:
        handle.set_canceled(TestResult(), "never begun")
    else:
        cancelled.add(handle.get_goal_id().id)


def freeze():
    sys.stdin.readline()
    os.kill(os.getpid(), signal.SIGSTOP)


rospy.init_node(sys.argv[1])
server = actionlib.ActionServer(sys.argv[2], TestAction, on_goal, on_cancel, auto_start=False)
server.start()
threading.Thread(target=freeze, daemon=True).start()
print("ready", flush=True)
rospy.spin()
