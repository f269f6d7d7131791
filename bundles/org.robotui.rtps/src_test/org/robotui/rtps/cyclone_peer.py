"""The same as rclpy_peer.py, by Cyclone DDS without ROS."""
import sys
import threading
import time
from dataclasses import dataclass

from cyclonedds.core import Listener, Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration


@dataclass
class Text(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str


SAYING = threading.Lock()


def say(*words):
    with SAYING:
        print(*words, flush=True)


class Watching(Listener):

    def on_requested_deadline_missed(self, reader, status):
        say("late")

    def on_liveliness_changed(self, reader, status):
        say("alive", status.alive_count)


def quality(reliability, durability, history):
    history, *times = history.split(":")
    watched = [Policy.Deadline(duration(milliseconds=int(times[0]))), Policy.Liveliness.ManualByTopic(duration(milliseconds=int(times[1])))] if times else []
    kept = Policy.History.KeepAll if history == "all" else Policy.History.KeepLast(int(history))
    return Qos(
        Policy.Reliability.Reliable(duration(milliseconds=100)) if reliability == "reliable" else Policy.Reliability.BestEffort,
        Policy.Durability.TransientLocal if durability == "transient_local" else Policy.Durability.Volatile,
        kept,
        # of what was written before, late readers get what this says
        Policy.DurabilityService(0, kept, -1, -1, -1),
        Policy.DataRepresentation(use_cdrv0_representation=True),
        *watched)


def write(writer, count, size, period):
    slowest = 0.0
    due = time.monotonic()
    for number in range(1, count + 1):
        time.sleep(max(0.0, due - time.monotonic()))
        due += period
        begin = time.monotonic()
        try:
            writer.write(Text(data=f"p{number} " + "x" * size))
        except Exception as fault:
            say("failed", number, str(fault).splitlines()[0])
        slowest = max(slowest, time.monotonic() - begin)
    say("sent", count, f"{slowest:.4f}")


def meet(writers, readers, reader, writer):
    while len(reader.get_matched_publications()) < writers or len(writer.get_matched_subscriptions()) < readers:
        time.sleep(0.005)
    say("met")


def listen(reader):
    while True:
        for sample in reader.take(N=100):
            if isinstance(sample, Text):
                say("heard", sample.data.split(" ")[0], len(sample.data))
        time.sleep(0.002)


def main():
    participant = DomainParticipant(int(sys.argv[4]))
    qos = quality(*sys.argv[1:4])
    reader = DataReader(participant, Topic(participant, "rt/" + sys.argv[5], Text), qos=qos, listener=Watching() if ":" in sys.argv[3] else None)
    writer = DataWriter(participant, Topic(participant, "rt/" + sys.argv[6], Text), qos=qos)
    threading.Thread(target=listen, args=(reader,), daemon=True).start()
    say("ready")
    for line in sys.stdin:
        order, *figures = line.split()
        if order == "end":
            break
        if order == "meet":
            meet(int(figures[0]), int(figures[1]), reader, writer)
            continue
        write(writer, int(figures[0]), int(figures[1]), float(figures[2]))


main()
