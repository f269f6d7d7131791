#!/usr/bin/env python3
"""A robot on LCM, its driver (--drive) and a witness (--hear), by a library of their own: lcm_bus.py.

The robot moves by a fixed step each 50 ms, as it is commanded; its messages have the fingerprint of no type.
"""
import argparse
import json
import math
import struct
import time

from lcm_bus import open_bus, waiting

PERIOD, SPEED, TURN = 0.05, 0.2, 0.1
POSE, DRIVE = struct.Struct(">QQdddd"), struct.Struct(">Qdd")
POSE_TYPE, DRIVE_TYPE = 0x1122334455667788, 0x8877665544332211


def robot(url, scan_bytes):
    bus, listening = open_bus(url, ""), open_bus(url, "DRIVE")
    step, x, y, heading, forward, turn = 0, 0.0, 0.0, 0.0, 0.0, 0.0
    due = time.monotonic()
    while True:
        due = max(due + PERIOD, time.monotonic() - 1)     # what was late is made up for, within a second
        while waiting(listening, due - time.monotonic()):
            channel, data = listening.receive()
            if channel == "DRIVE":
                _, forward, turn = DRIVE.unpack(data)
                print(json.dumps({"at": time.time(), "forward": forward}), flush=True)
        step += 1
        heading += turn * PERIOD
        x += forward * math.cos(heading) * PERIOD
        y += forward * math.sin(heading) * PERIOD
        bus.send("POSE", POSE.pack(POSE_TYPE, step, x, y, heading, forward))
        bus.send("SCAN", struct.pack(">QQ", POSE_TYPE + 1, step) + bytes(scan_bytes))


def drive(url):
    bus = open_bus(url, "")
    while True:
        bus.send("DRIVE", DRIVE.pack(DRIVE_TYPE, SPEED, TURN))
        time.sleep(0.1)


def hear(url):
    bus = open_bus(url, ".*")
    while True:
        channel, data = bus.receive()
        line = {"at": time.time(), "channel": channel}
        if channel == "POSE":
            _, line["seq"], line["x"], line["y"], _, line["linear"] = POSE.unpack(data)
            line["topic"] = "odom"
        elif channel == "SCAN":
            line.update(topic="scan", seq=struct.unpack_from(">QQ", data)[1])
        else:
            line["topic"] = channel
        print(json.dumps(line), flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("url")
    parser.add_argument("--scan-bytes", type=int, default=3000)
    parser.add_argument("--drive", action="store_true")
    parser.add_argument("--hear", action="store_true")
    arguments = parser.parse_args()
    if arguments.drive:
        drive(arguments.url)
    elif arguments.hear:
        hear(arguments.url)
    else:
        robot(arguments.url, arguments.scan_bytes)


if __name__ == "__main__":
    main()
