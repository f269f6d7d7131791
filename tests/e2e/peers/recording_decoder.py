"""Decodes the messages of ROS in a recording as the stock readers of MCAP do: recording_decoder.py FILE. Prints one JSON object: by topic the count, the
type, the encoding, the metadata of its channel, and of messages with a header how many are missing between others, by their stamps."""
import json
import statistics
import sys

from mcap.reader import make_reader
from mcap_ros1.decoder import DecoderFactory as Ros1
from mcap_ros2.decoder import DecoderFactory as Ros2

FACTORIES = {"cdr": Ros2(), "ros1": Ros1()}


def stamp(message):
    header = message.header if hasattr(message, "header") else message.transforms[0].header
    time = header.stamp
    return time.sec + time.nanosec * 1e-9 if hasattr(time, "sec") else time.secs + time.nsecs * 1e-9


topics, decoders = {}, {}
with open(sys.argv[1], "rb") as stream:
    for schema, channel, message in make_reader(stream, validate_crcs=True).iter_messages():
        topic = topics.setdefault(channel.topic, {"count": 0, "type": schema.name if schema else "", "encoding": channel.message_encoding,
                                                  "metadata": channel.metadata, "stamps": []})
        topic["count"] += 1
        if channel.message_encoding in FACTORIES:
            decoder = decoders.setdefault(channel.id, FACTORIES[channel.message_encoding].decoder_for(channel.message_encoding, schema))
            decoded = decoder(message.data)
            if hasattr(decoded, "header") or getattr(decoded, "transforms", None):
                topic["stamps"].append(stamp(decoded))
        elif channel.message_encoding == "json":
            topic.setdefault("values", []).append(json.loads(message.data))
for topic in topics.values():
    stamps = sorted(topic.pop("stamps"))
    distances = [after - before for before, after in zip(stamps, stamps[1:])]
    if distances:
        usual = statistics.median(distances)
        # Where nothing comes for ten periods, the simulated robot itself had to wait for a processor.
        topic["missing"] = sum(round(each / usual) - 1 for each in distances if each < 10 * usual)
with open(sys.argv[1], "rb") as stream:
    summary = make_reader(stream).get_summary()
print(json.dumps({"topics": topics, "schemas": {each.name: each.encoding for each in summary.schemas.values()},
                  "attachments": [each.name for each in summary.attachment_indexes]}))
