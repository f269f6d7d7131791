"""The subscriber of Cyclone DDS for Python, told as subscriber.c is."""
import sys
import time
from dataclasses import dataclass

import cyclonedds.idl.annotations as annotate
from cyclonedds.builtin import BuiltinDataReader, BuiltinTopicDcpsPublication
from cyclonedds.core import Listener, Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import int32, sequence, uint8, uint32
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration
from tally import Tally

RELIABLE = Qos(Policy.Reliability.Reliable(duration(seconds=10)), Policy.History.KeepAll)
AT_ONCE = 64


@dataclass
@annotate.final
class String(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str


@dataclass
@annotate.final
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32
    nanosec: uint32


@dataclass
@annotate.final
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time
    frame_id: str


@dataclass
@annotate.final
class Image(IdlStruct, typename="sensor_msgs::msg::dds_::Image_"):
    header: Header
    height: uint32
    width: uint32
    encoding: str
    is_bigendian: uint8
    step: uint32
    data: sequence[uint8]


class Hears(Listener):
    def __init__(self, tally, image):
        super().__init__()
        self.tally, self.image = tally, image

    def on_data_available(self, reader):
        while samples := reader.take(AT_ONCE):
            for sample in samples:
                if isinstance(sample, (String, Image)):
                    self.tally.add(sample.header.frame_id if self.image else sample.data)


def measure(participant, kind, topic):
    tally = Tally()
    image = kind == "image"
    reader = DataReader(participant, Topic(participant, topic, Image if image else String), qos=RELIABLE, listener=Hears(tally, image))
    tally.done.wait()
    del reader
    return tally.json()


def discover(domain, count):
    start = time.monotonic()
    participant = DomainParticipant(domain)
    reader = BuiltinDataReader(participant, BuiltinTopicDcpsPublication)
    known = 0
    while known < count:
        found = reader.take(AT_ONCE)
        known += sum(each.topic_name.startswith("rt/endpoint_") for each in found)
        if not found:
            time.sleep(0.0005)
    return f'{{"seconds": {time.monotonic() - start:.6f}}}'


def main(domain):
    participant = None
    for line in sys.stdin:
        words = line.split()
        if words[0] == "discover":
            participant = None
            print(discover(domain, int(words[1])), flush=True)
        else:
            participant = participant or DomainParticipant(domain)
            print(measure(participant, *words), flush=True)


main(int(sys.argv[1]))
