"""Reads the demo's markers and moves its waypoint: waypoint.py X Y. The types are made from the definitions that come with the connections,
as their Python package is seldom installed. Prints what was seen as JSON."""
import json
import sys
import threading

import genpy.dynamic
import rospy

POSE = "geometry_msgs/Pose"
FEEDBACK = """Header header
string client_id
string marker_name
string control_name
uint8 KEEP_ALIVE = 0
uint8 POSE_UPDATE = 1
uint8 MENU_SELECT = 2
uint8 BUTTON_CLICK = 3
uint8 MOUSE_DOWN = 4
uint8 MOUSE_UP = 5
uint8 event_type
geometry_msgs/Pose pose
uint32 menu_entry_id
geometry_msgs/Point mouse_point
bool mouse_point_valid
"""


MAKING = threading.Lock()  # genpy keeps what it has begun in its module, and rospy calls back in a thread per link


def types_of(name, definition):
    with MAKING:
        return genpy.dynamic.generate_dynamic(name, definition)


class Listener:
    """Keeps the messages of a topic of any type."""

    def __init__(self, topic):
        self.messages = []
        self.classes = {}
        self.came = threading.Condition()
        rospy.Subscriber(topic, rospy.AnyMsg, self.take)

    def take(self, raw):
        header = raw._connection_header
        if not self.classes:
            self.classes = types_of(header["type"], header["message_definition"])
            self.definition = header["message_definition"]
        message = self.classes[header["type"]]()
        message.deserialize(raw._buff)
        with self.came:
            self.messages.append(message)
            self.came.notify_all()

    def wait(self, wanted):
        with self.came:
            if not self.came.wait_for(lambda: any(wanted(m) for m in self.messages), timeout=20):
                raise SystemExit("waited in vain")
            return next(m for m in self.messages if wanted(m))


rospy.init_node("hand", anonymous=True)
full = Listener("/waypoint/update_full")
updates = Listener("/waypoint/update")
objects = Listener("/objects")
first = full.wait(lambda m: True)
alive = updates.wait(lambda m: m.type == 0)
seen = objects.wait(lambda m: True)

parts = full.definition.split("=" * 80)
needed = [part for part in parts[1:] if part.split("\n", 2)[1].split()[1] in
          ("std_msgs/Header", POSE, "geometry_msgs/Point", "geometry_msgs/Quaternion")]
types = types_of("visualization_msgs/InteractiveMarkerFeedback", ("=" * 80).join([FEEDBACK] + needed))
Feedback = types["visualization_msgs/InteractiveMarkerFeedback"]
publisher = rospy.Publisher("/waypoint/feedback", Feedback, queue_size=10)
rate = rospy.Rate(20)
while publisher.get_num_connections() == 0:
    rate.sleep()
feedback = Feedback()
feedback.header.frame_id = "map"
feedback.client_id = "hand"
feedback.marker_name = first.markers[0].name
feedback.event_type = 1
feedback.pose.position.x, feedback.pose.position.y = float(sys.argv[1]), float(sys.argv[2])
feedback.pose.orientation.w = 1
publisher.publish(feedback)
moved = updates.wait(lambda m: m.type == 1)
print(json.dumps({
    "menu": [entry.title for entry in first.markers[0].menu_entries],
    "numbers": [first.seq_num, alive.seq_num, moved.seq_num],
    "place": [moved.poses[0].pose.position.x, moved.poses[0].pose.position.y],
    "names": sorted({m.text for m in seen.markers if m.type == 9})}))
