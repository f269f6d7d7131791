"""Serves dynamic_reconfigure's own test configuration: reconfigure_server.py NODE. A line "NAME VALUE" on the standard
input changes an integer parameter, as somebody else would."""
import sys
import threading

import dynamic_reconfigure.cfg.TestConfig as TestConfig
import rospy
from dynamic_reconfigure.server import Server


def changed(config, level):
    print("changed", config["int_"], config["int_enum_"], repr(config["str_"]), config["bool_"], config["double_"], flush=True)
    return config


def listen(server):
    for line in sys.stdin:
        name, value = line.split()
        server.update_configuration({name: int(value)})


rospy.init_node(sys.argv[1])
server = Server(TestConfig, changed)
threading.Thread(target=listen, args=(server,), daemon=True).start()
print("ready", flush=True)
rospy.spin()
