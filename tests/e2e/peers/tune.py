"""Changes a parameter with dynamic_reconfigure's own client: tune.py NODE NAME VALUE. Prints all values as JSON."""
import ast
import json
import sys

import dynamic_reconfigure.client
import rospy

rospy.init_node("tuner", anonymous=True)
client = dynamic_reconfigure.client.Client(sys.argv[1], timeout=15)
descriptions = {each["name"]: each for each in client.get_parameter_descriptions(timeout=10)}
now = client.update_configuration({sys.argv[2]: float(sys.argv[3])})
now.pop("groups", None)
style = ast.literal_eval(descriptions["driving_style"]["edit_method"])
print(json.dumps({"values": now, "most": descriptions[sys.argv[2]]["max"], "styles": [each["name"] for each in style["enum"]]}))
