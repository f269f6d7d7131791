"""A program of ROS 2 that visits the simulated robot, as users and other nodes do. Prints what it found as one line of JSON.

Usage: ros2_visitor.py TASK [NUMBER...]
"""
import json
import sys
import time

import rclpy
from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from nav_msgs.srv import GetMap
from rcl_interfaces.msg import Log, Parameter, ParameterEvent, ParameterType, ParameterValue
from rcl_interfaces.srv import DescribeParameters, ListParameters, SetParameters
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import BatteryState, CompressedImage, Image, JointState, LaserScan, PointCloud2, Range
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
STEADY = 10


class Visitor:

    def __init__(self):
        self.node = rclpy.create_node("visitor")
        self.heard = {}
        self.began = time.monotonic()

    def hear(self, kind, topic, qos):
        """Counts the messages of a topic, and keeps the last one and when the first one came."""
        def take(message):
            first = self.heard.get(topic, {"at": round(time.monotonic() - self.began, 3), "count": 0})
            self.heard[topic] = {"at": first["at"], "count": first["count"] + 1, "last": message}
        self.node.create_subscription(kind, topic, take, qos)

    def last(self, topic):
        return self.heard[topic]["last"]

    def until(self, condition, what, seconds=30):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise SystemExit(f"did not happen within {seconds} s: {what}; heard {sorted(self.heard)}")
            rclpy.spin_once(self.node, timeout_sec=0.02)

    def call(self, kind, name, request):
        client = self.node.create_client(kind, name)
        self.until(client.service_is_ready, name)
        future = client.call_async(request)
        self.until(future.done, f"an answer of {name}")
        return future.result()

    # What there is.

    def graph(self):
        self.until(lambda: ("robot", "/") in self.node.get_node_names_and_namespaces(), "the robot's node")
        named = time.monotonic() - self.began
        services = lambda: dict(self.node.get_service_names_and_types_by_node("robot", "/"))
        self.until(lambda: "/robot/set_parameters" in services() and "/stop" in services(), "its services")
        return {"named": named, "topics": dict(self.node.get_topic_names_and_types()),
                "services": services(),
                "qos": {topic: [end.qos_profile.reliability.name, end.qos_profile.durability.name]
                        for topic in ("/scan", "/odom", "/map", "/tf", "/tf_static", "/robot_description", "/rosout", "/camera/image_raw")
                        for end in self.node.get_publishers_info_by_topic(topic)[:1]}}

    def sensors(self):
        wanted = [(LaserScan, "scan"), (Range, "sonar"), (CompressedImage, "camera/image_raw/compressed"), (Image, "camera/image_raw"),
                  (Image, "camera/depth/image_raw"), (PointCloud2, "lidar/points")]
        for kind, topic in wanted:
            self.hear(kind, topic, qos_profile_sensor_data)
        steady = [(Odometry, "odom"), (BatteryState, "battery_state"), (JointState, "joint_states")]
        for kind, topic in steady:
            self.hear(kind, topic, STEADY)
        kept = [(OccupancyGrid, "map"), (String, "robot_description"), (PoseWithCovarianceStamped, "amcl_pose")]
        for kind, topic in kept:
            self.hear(kind, topic, LATCHED)
        self.until(lambda: all(topic in self.heard for _, topic in wanted + steady + kept), "a message of each")
        self.until(lambda: self.last("scan").header.frame_id == "laser", "a scan")
        return {"at": {topic: heard["at"] for topic, heard in self.heard.items()}, "rays": len(self.last("scan").ranges),
                "map": [self.last("map").info.width * self.last("map").info.height, len(self.last("map").data)],
                "urdf": self.last("robot_description").data[:40], "jpeg": bytes(self.last("camera/image_raw/compressed").data[:2]).hex(),
                "image": [self.last("camera/image_raw").encoding, len(self.last("camera/image_raw").data)],
                "depth": self.last("camera/depth/image_raw").encoding, "step": self.last("lidar/points").point_step,
                "joints": list(self.last("joint_states").name)}

    # What can be asked of it.

    def drive(self):
        """Drives for a second, and measures how long it goes on after the last command."""
        self.hear(Odometry, "odom", STEADY)
        self.hear(Log, "/rosout", QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        command = self.node.create_publisher(Twist, "cmd_vel", STEADY)
        self.until(lambda: command.get_subscription_count() > 0 and "odom" in self.heard, "the robot")
        twist = Twist()
        twist.linear.x = 0.3

        def fast():
            command.publish(twist)
            return self.last("odom").twist.twist.linear.x > 0.25
        self.until(fast, "motion")
        last = time.monotonic()
        self.until(lambda: self.last("odom").twist.twist.linear.x == 0, "standstill")
        stopped = time.monotonic() - last
        self.until(lambda: "/rosout" in self.heard, "a line in the log")
        return {"stopped": stopped, "log": self.last("/rosout").msg, "logger": self.last("/rosout").name}

    def services(self):
        motors = self.call(SetBool, "motors", SetBool.Request(data=True))
        stop = self.call(Trigger, "stop", Trigger.Request())
        chart = self.call(GetMap, "static_map", GetMap.Request())
        return {"motors": [motors.success, motors.message], "stop": [stop.success, stop.message], "map": len(chart.map.data)}

    def parameters(self):
        self.hear(ParameterEvent, "/parameter_events", QoSProfile(depth=100))
        names = list(self.call(ListParameters, "robot/list_parameters", ListParameters.Request()).result.names)
        described = self.call(DescribeParameters, "robot/describe_parameters", DescribeParameters.Request(names=["max_linear_speed"]))
        limits = described.descriptors[0].floating_point_range[0]

        def set_to(name, value):
            wish = Parameter(name=name, value=value)
            result = self.call(SetParameters, "robot/set_parameters", SetParameters.Request(parameters=[wish])).results[0]
            return [result.successful, result.reason]
        real = ParameterType.PARAMETER_DOUBLE
        taken = set_to("max_linear_speed", ParameterValue(type=real, double_value=0.2))
        refused = set_to("max_linear_speed", ParameterValue(type=real, double_value=9.0))
        style = set_to("driving_style", ParameterValue(type=ParameterType.PARAMETER_INTEGER, integer_value=1))
        ours = lambda: "/parameter_events" in self.heard and self.last("/parameter_events").node == "/robot"
        self.until(ours, "an event")
        return {"names": names, "range": [limits.from_value, limits.to_value], "taken": taken, "refused": refused, "style": style,
                "after": self.fastest()}

    def fastest(self):
        """The speed that it comes to when asked for more than it may."""
        self.hear(Odometry, "odom", STEADY)
        command = self.node.create_publisher(Twist, "cmd_vel", STEADY)
        twist = Twist()
        twist.linear.x = 1.0
        speeds = []

        def told():
            command.publish(twist)
            speeds.append(self.last("odom").twist.twist.linear.x if "odom" in self.heard else 0)
            return len(speeds) > 50 and speeds[-1] > 0.1 and speeds[-1] == speeds[-20]
        self.until(told, "a steady speed")
        return speeds[-1]

    def describe(self):
        """Asks for a type that PyPI does not have, by the sum that the robot announces."""
        from type_description_interfaces.srv import GetTypeDescription
        self.until(lambda: self.node.get_publishers_info_by_topic("/objects"), "the topic")
        announced = str(self.node.get_publishers_info_by_topic("/objects")[0].topic_type_hash)
        ask = GetTypeDescription.Request(type_name="visualization_msgs/msg/MarkerArray", type_hash=announced)
        answer = self.call(GetTypeDescription, "robot/get_type_description", ask)
        wrong = GetTypeDescription.Request(type_name="visualization_msgs/msg/MarkerArray", type_hash=announced[:-1] + "x")
        return {"found": answer.successful, "type": answer.type_description.type_description.type_name,
                "fields": [field.name for field in answer.type_description.type_description.fields],
                "referenced": sorted(part.type_name for part in answer.type_description.referenced_type_descriptions),
                "other": self.call(GetTypeDescription, "robot/get_type_description", wrong).successful}

    def clock(self):
        self.hear(Clock, "/clock", QoSProfile(depth=1, reliability=qos_profile_sensor_data.reliability))
        self.until(lambda: self.heard.get("/clock", {"count": 0})["count"] > 10, "the time")
        return {"seconds": self.last("/clock").clock.sec}

    # With packages that have to be generated.

    def markers(self):
        from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerUpdate, MarkerArray
        from visualization_msgs.srv import GetInteractiveMarkers
        self.hear(MarkerArray, "objects", STEADY)
        self.hear(InteractiveMarkerUpdate, "waypoint/update", STEADY)
        before = self.call(GetInteractiveMarkers, "waypoint/get_interactive_markers", GetInteractiveMarkers.Request())
        feedback = self.node.create_publisher(InteractiveMarkerFeedback, "waypoint/feedback", STEADY)
        self.until(lambda: feedback.get_subscription_count() > 0, "the server")
        move = InteractiveMarkerFeedback(marker_name="waypoint", event_type=InteractiveMarkerFeedback.POSE_UPDATE)
        move.header.frame_id = "map"
        move.pose.position.x, move.pose.position.y, move.pose.orientation.w = 2.6, 3.2, 1.0
        feedback.publish(move)
        self.until(lambda: "waypoint/update" in self.heard and self.last("waypoint/update").type == InteractiveMarkerUpdate.UPDATE, "an update")
        after = self.call(GetInteractiveMarkers, "waypoint/get_interactive_markers", GetInteractiveMarkers.Request())
        self.until(lambda: "objects" in self.heard, "objects")
        place = after.markers[0].pose.position
        return {"markers": [each.name for each in before.markers], "numbers": [before.sequence_number, after.sequence_number],
                "place": [place.x, place.y], "objects": len(self.last("objects").markers)}

    def navigate(self, x, y, frame, cancel_after):
        """Sends a goal, and cancels it after some feedback if that is not 0."""
        from nav2_msgs.action import NavigateToPose
        from rclpy.action import ActionClient
        feedback = []
        client = ActionClient(self.node, NavigateToPose, "navigate_to_pose")
        self.until(client.server_is_ready, "the action's server")
        goal = NavigateToPose.Goal()
        goal.pose = PoseStamped()
        goal.pose.header.frame_id = frame
        goal.pose.pose.position.x, goal.pose.pose.position.y, goal.pose.pose.orientation.w = float(x), float(y), 1.0
        sent = client.send_goal_async(goal, feedback_callback=lambda told: feedback.append(told.feedback))
        self.until(sent.done, "an answer to the goal")
        if not sent.result().accepted:
            return {"state": "REJECTED"}
        result = sent.result().get_result_async()
        if int(cancel_after):
            self.until(lambda: len(feedback) >= int(cancel_after), "feedback")
            cancel = sent.result().cancel_goal_async()
            self.until(cancel.done, "an answer to the cancelling")
        self.until(result.done, "the end of the goal", 90)
        states = {GoalStatus.STATUS_SUCCEEDED: "SUCCEEDED", GoalStatus.STATUS_CANCELED: "CANCELED", GoalStatus.STATUS_ABORTED: "ABORTED"}
        return {"state": states[result.result().status], "text": result.result().result.error_msg, "feedback": len(feedback),
                "left": [told.distance_remaining for told in feedback], "frame": feedback[0].current_pose.header.frame_id if feedback else ""}


def main():
    rclpy.init()
    visitor = Visitor()
    print(json.dumps(getattr(visitor, sys.argv[1])(*sys.argv[2:])))
    sys.stdout.flush()
    rclpy.shutdown()


main()
