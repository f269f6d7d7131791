"""Asks a program for its settings with dynamic_reconfigure's own client: settings.py NODE. Prints them as JSON."""
import json
import sys

import dynamic_reconfigure.client
import rospy

rospy.init_node("asker", anonymous=True)
client = dynamic_reconfigure.client.Client(sys.argv[1], timeout=15)
now = client.get_configuration(timeout=10)
now.pop("groups", None)
print(json.dumps(now))
