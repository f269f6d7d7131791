"""Writes recordings as rosbag2 does: rosbag2_maker.py FOLDER sqlite3|mcap none|file|message by the rosbags of PyPI, rosbag2_maker.py FILE killed as a recorder
leaves it that was killed: a database of the year 2022 without definitions, and its log with what was not moved into it yet."""
import os
import shutil
import sqlite3
import sys

MESSAGES, FIRST, STEP = 60, 1_700_000_000_000_000_000, 50_000_000
QOS_LATCHED = "- history: 3\n  depth: 0\n  reliability: 1\n  durability: 1\n  deadline:\n    sec: 9223372036\n    nsec: 854775807\n  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n  liveliness: 1\n"


def of_rosbags(folder, storage, compression):
    import numpy
    from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore
    store = get_typestore(Stores.ROS2_HUMBLE)
    made = store.types
    header, moment, joints, text, image = (made[f"{name}"] for name in (
        "std_msgs/msg/Header", "builtin_interfaces/msg/Time", "sensor_msgs/msg/JointState", "std_msgs/msg/String", "sensor_msgs/msg/CompressedImage"))
    writer = Writer(folder, version=9, storage_plugin=StoragePlugin[storage.upper()])
    if compression != "none":
        writer.set_compression(CompressionMode[compression.upper()], CompressionFormat.ZSTD)
    with writer:
        ways = {kind: writer.add_connection(topic, kind, typestore=store) for topic, kind in (
            ("/joint_states", "sensor_msgs/msg/JointState"), ("/robot/words", "std_msgs/msg/String"), ("/picture", "sensor_msgs/msg/CompressedImage"))}

        def write(time, message):
            writer.write(ways[message.__msgtype__], time, store.serialize_cdr(message, message.__msgtype__))

        for number in range(MESSAGES):
            time = FIRST + number * STEP
            head = header(moment(time // 10**9, time % 10**9), "base")
            numbers = numpy.array([number, number / 8], dtype=numpy.float64)
            write(time, joints(head, ["left", "right"], numbers, numbers * 2, numbers * 0))
            if number % 10 == 0:
                write(time + 1000, text(f"step {number}"))
                write(time + 2000, image(head, "png", numpy.arange(number * 100, dtype=numpy.uint64).astype(numpy.uint8)))


def killed(file):
    """The log of a database is there as long as it is open."""
    part = file + ".open"
    database = sqlite3.connect(part, isolation_level=None)
    for line in ("PRAGMA page_size = 512", "PRAGMA journal_mode = WAL", "PRAGMA wal_autocheckpoint = 0",
                 "CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL)",
                 "CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL, data BLOB NOT NULL)",
                 "CREATE INDEX timestamp_idx ON messages (timestamp ASC)"):
        database.execute(line)
    database.execute("INSERT INTO topics VALUES (1, '/words', 'std_msgs/msg/String', 'cdr', ?)", (QOS_LATCHED,))
    for number in range(MESSAGES):
        words = (f"step {number} " * (number % 7 * 20 + 1)).encode() + b"\0"
        database.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES (1, ?, ?)", (FIRST + number * STEP, b"\0\1\0\0" + len(words).to_bytes(4, "little") + words))
        if number == MESSAGES // 2:
            database.execute("PRAGMA wal_checkpoint(PASSIVE)")
    shutil.copy(part, file)
    shutil.copy(part + "-wal", file + "-wal")
    database.close()
    os.remove(part)


if sys.argv[2] == "killed":
    killed(sys.argv[1])
else:
    of_rosbags(*sys.argv[1:])
