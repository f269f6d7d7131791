#!/usr/bin/env python3
"""An arm of rospy that shows a plan as MoveIt does, and executes it with a lag. The types are made from their definitions, of which the parts that
are read are kept, as their Python packages are seldom installed."""
import math

import genpy.dynamic
import rospy
from sensor_msgs.msg import JointState

URDF = """<robot name="arm">
  <link name="base"><visual><origin xyz="0 0 0.1"/><geometry><cylinder radius="0.3" length="0.2"/></geometry></visual></link>
  <link name="beam"><visual><origin xyz="0.4 0 0.3"/><geometry><box size="0.8 0.1 0.1"/></geometry></visual></link>
  <link name="tool"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="beam"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="lift" type="prismatic"><parent link="beam"/><child link="tool"/><origin xyz="0.8 0 0.3"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/></joint>
</robot>"""
LINE = "\n" + 80 * "=" + "\n"
DEFINITION = LINE.join(("""string model_id
moveit_msgs/RobotTrajectory[] trajectory
moveit_msgs/RobotState trajectory_start
""", """MSG: moveit_msgs/RobotTrajectory
trajectory_msgs/JointTrajectory joint_trajectory
""", """MSG: trajectory_msgs/JointTrajectory
Header header
string[] joint_names
trajectory_msgs/JointTrajectoryPoint[] points
""", """MSG: trajectory_msgs/JointTrajectoryPoint
float64[] positions
float64[] velocities
float64[] accelerations
float64[] effort
duration time_from_start
""", """MSG: moveit_msgs/RobotState
sensor_msgs/JointState joint_state
bool is_diff
""", """MSG: sensor_msgs/JointState
Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
""", """MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
"""))
SECONDS = 2.0
LAG = 0.4


def plan():
    types = genpy.dynamic.generate_dynamic("moveit_msgs/DisplayTrajectory", DEFINITION)
    points = []
    for i in range(11):
        share = i / 10
        points.append(types["trajectory_msgs/JointTrajectoryPoint"](
            positions=[1.5 * share, 0.6 * share], time_from_start=rospy.Duration(SECONDS * share)))
    shown = types["moveit_msgs/DisplayTrajectory"](model_id="arm")
    part = types["moveit_msgs/RobotTrajectory"]()
    part.joint_trajectory.joint_names = ["turn", "lift"]
    part.joint_trajectory.points = points
    shown.trajectory = [part]
    return types["moveit_msgs/DisplayTrajectory"], shown


def main():
    rospy.init_node("planning_robot")
    rospy.set_param("robot_description", URDF)
    kind, shown = plan()
    plans = rospy.Publisher("move_group/display_planned_path", kind, queue_size=1, latch=True)
    joints = rospy.Publisher("joint_states", JointState, queue_size=1)
    plans.publish(shown)
    rate = rospy.Rate(20)
    while not rospy.is_shutdown():
        # to and fro, and the lift comes late: it is off the plan
        phase = math.sin(rospy.get_time() / SECONDS)
        message = JointState(name=["turn", "lift"], position=[0.75 + 0.75 * phase, max(0, 0.3 + 0.3 * phase - LAG)])
        message.header.stamp = rospy.Time.now()
        joints.publish(message)
        rate.sleep()


if __name__ == "__main__":
    main()
