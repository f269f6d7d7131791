"""Prints a digest of every message of recordings, in order, as the stock readers of MCAP and of bags have them: recording_reader.py FILE...
recording_reader.py --values TOPIC COUNT BAG prints time, names, positions and efforts of the first joint states of a bag, as JSON."""
import hashlib
import json
import os
import sys


def of_mcap(file):
    from mcap.reader import make_reader
    with open(file, "rb") as stream:
        for schema, channel, message in make_reader(stream, validate_crcs=True).iter_messages():
            yield message.log_time, channel.topic, schema.name if schema else "", message.data


def of_bag(file):
    from rosbags.rosbag1 import Reader
    with Reader(file) as reader:
        for connection, time, data in reader.messages():
            yield time, connection.topic, connection.msgtype.replace("/msg/", "/"), data


def of_folder(folder):
    from rosbags.rosbag2 import Reader
    with Reader(folder) as reader:
        for connection, time, data in reader.messages():
            yield time, connection.topic, connection.msgtype, bytes(data)


def joint_states(topic, count, file):
    from rosbags.rosbag1 import Reader
    from rosbags.typesys import Stores, get_typestore
    store = get_typestore(Stores.ROS1_NOETIC)
    with Reader(file) as reader:
        messages = reader.messages([each for each in reader.connections if each.topic == topic])
        for (connection, time, data), _ in zip(messages, range(count)):
            state = store.deserialize_ros1(data, connection.msgtype)
            print(json.dumps([time, state.name, state.position.tolist(), state.effort.tolist()]))


if sys.argv[1] == "--values":
    joint_states(sys.argv[2], int(sys.argv[3]), sys.argv[4])
    sys.exit()
for file in sys.argv[1:]:
    messages = of_folder(file) if os.path.isdir(file) else of_mcap(file) if file.endswith(".mcap") else of_bag(file)
    print(file)
    for line in sorted(f"{time} {topic} {kind} {hashlib.md5(data).hexdigest()}" for time, topic, kind, data in messages):
        print(line)
