#!/usr/bin/python3
"""Robots that speak CARMEN, each with a central of its own: COUNT RECORDINGS, then says their ports. Each says as much as a robot of the simulated swarm of
ROS: odometry ten times a second, where it is on the map (in place of transforms) five times, and a scan of 36 ranges four times."""
import json
import math
import pathlib
import struct
import sys
import time

import scans
from carmen_central import Central, answers, message

TICK = 0.05
BEAMS = 36
ODOMETRY, PLACE, SCAN = 2, 4, 5      # ticks
SPEED, RADIUS = 0.3, 2.0


def said(step, now, number):
    """The messages that are due, each robot at ticks of its own, as it drives in a circle."""
    angle = SPEED / RADIUS * now + number
    pose = (RADIUS * math.cos(angle) + 5 * (number % 10), RADIUS * math.sin(angle) + 5 * (number // 10), math.remainder(angle + math.pi / 2, math.tau))
    if (step + number) % ODOMETRY == 0:
        yield "carmen_base_odometry", struct.pack("<7d", *pose, SPEED, SPEED / RADIUS, 0.5, now) + scans.text("robot")
    if (step + number) % PLACE == 0:
        yield "carmen_localize_globalpos", struct.pack("<9ddid", *pose, 0.05, 0.05, 0.05, *pose, 0.0, 1, now) + scans.text("robot")
    if (step + number) % SCAN == 0:
        yield "carmen_robot_frontlaser", scans.carmen([2.0] * BEAMS, now, pose)


def tell(central, number, step, now):
    handlers, peer = central.handlers, central.peer
    for name, content in said(step, now, number):
        if handlers.get(name):
            try:
                peer.sendall(message(handlers[name], name, content))
            except OSError:
                return                       # its central takes the next link


def main():
    known = answers(pathlib.Path(sys.argv[2]))
    centrals = [Central(known) for _ in range(int(sys.argv[1]))]
    print(json.dumps([central.port for central in centrals]), flush=True)
    due = time.monotonic()
    for step in range(sys.maxsize):
        for number, central in enumerate(centrals):
            tell(central, number, step, time.time())
        due = max(due + TICK, time.monotonic() - TICK)
        time.sleep(max(0.0, due - time.monotonic()))


if __name__ == "__main__":
    main()
