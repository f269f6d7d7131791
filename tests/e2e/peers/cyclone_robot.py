#!/usr/bin/env python3
"""A program that knows DDS and nothing of ROS: it says a text and a number on topics of ROS 2, ten times a second, until it is killed."""
import sys
import time
from dataclasses import dataclass

from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float64
from cyclonedds.pub import DataWriter
from cyclonedds.topic import Topic


@dataclass
class Text(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str


@dataclass
class Number(IdlStruct, typename="std_msgs::msg::dds_::Float64_"):
    data: float64


@dataclass
class Vector(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: float64
    y: float64
    z: float64


def main():
    participant = DomainParticipant(int(sys.argv[1]))
    writers = [DataWriter(participant, Topic(participant, f"rt/{name}", kind)) for name, kind in
               (("chatter", Text), ("level", Number), ("wind", Vector))]
    for number in range(1_000_000):
        for writer, message in zip(writers, (Text(f"hello {number}"), Number(number / 10), Vector(1.0, 2.0, float(number)))):
            writer.write(message)
        time.sleep(0.1)


if __name__ == "__main__":
    main()
