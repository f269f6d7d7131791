"""Decodes the cycles of a control in a recording as the stock readers of MCAP do: cycle_decoder.py FILE. Prints a JSON line for each: its number, how many
are said to be missed so far, its stamp in seconds, and the position of its first joint by name."""
import json
import sys

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

decode = None
with open(sys.argv[1], "rb") as stream:
    for schema, channel, message in make_reader(stream, validate_crcs=True).iter_messages(topics=["cycles"]):
        decode = decode or DecoderFactory().decoder_for(channel.message_encoding, schema)
        cycle = decode(message.data)
        print(json.dumps([cycle.cycle, cycle.lost, cycle.stamp.sec + cycle.stamp.nanosec * 1e-9, dict(zip(cycle.name, cycle.position))]))
