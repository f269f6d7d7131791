"""Readers in Python: readers.py rosbag|rosbags|mcap. Answers each line with one line of JSON, as the other programs do."""
import contextlib
import json
import pathlib
import sys
import time

GOLDEN = 0.6180339887498949


@contextlib.contextmanager
def by_rosbag(file):
    import genpy
    import rosbag
    with rosbag.Bag(file) as bag:
        yield (bag.get_start_time(), bag.get_end_time()), lambda start: (
            raw[1] for _, raw, _ in bag.read_messages(raw=True, start_time=None if start is None else genpy.Time.from_sec(start)))


@contextlib.contextmanager
def by_rosbags(file):
    from rosbags.rosbag1 import Reader
    with Reader(pathlib.Path(file)) as reader:
        yield (reader.start_time / 1e9, reader.end_time / 1e9), lambda start: (
            data for _, _, data in reader.messages(start=None if start is None else int(start * 1e9)))


@contextlib.contextmanager
def by_mcap(file):
    from mcap.reader import make_reader
    with open(file, "rb") as stream:
        reader = make_reader(stream)
        found = reader.get_summary().statistics
        yield (found.message_start_time / 1e9, found.message_end_time / 1e9), lambda start: (
            message.data for _, _, message in reader.iter_messages(start_time=None if start is None else int(start * 1e9)))


def answer(opening, verb, file, times=0):
    begin = time.perf_counter()
    with opening(file) as ((first, last), messages):
        if verb == "read":
            count = size = 0
            for data in messages(None):
                count, size = count + 1, size + len(data)
            return {"seconds": time.perf_counter() - begin, "messages": count, "bytes": size}
        opened, seeks = time.perf_counter() - begin, []
        for number in range(1, int(times) + 1):
            begin = time.perf_counter()
            next(messages(first + (last - first) * (number * GOLDEN % 1)))
            seeks.append(time.perf_counter() - begin)
        return {"open": opened, "seeks": seeks}


for line in sys.stdin:
    print(json.dumps(answer({"rosbag": by_rosbag, "rosbags": by_rosbags, "mcap": by_mcap}[sys.argv[1]], *line.split())), flush=True)
