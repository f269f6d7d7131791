"""Prints a digest of every message of recordings, in order, as the stock readers of MCAP and of bags have them: recording_reader.py FILE..."""
import hashlib
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


for file in sys.argv[1:]:
    messages = of_mcap(file) if file.endswith(".mcap") else of_bag(file)
    print(file)
    for line in sorted(f"{time} {topic} {kind} {hashlib.md5(data).hexdigest()}" for time, topic, kind, data in messages):
        print(line)
