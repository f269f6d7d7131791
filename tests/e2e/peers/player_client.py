#!/usr/bin/env python3
"""An independent client of a Player server: tells each odometry and scan that it hears as a JSON line, or (--drive) commands velocities."""
import argparse
import json
import socket
import struct
import time

HEADER = struct.Struct(">IIIIIIdII")
DATA, COMMAND, REQUEST = 1, 2, 3
TOPICS = {4: "odom", 6: "scan"}
SPEED, TURN = 0.2, 0.1


def take(connection, count):
    data = b""
    while len(data) < count:
        more = connection.recv(count - len(data))
        if not more:
            raise SystemExit("the server is gone")
        data += more
    return data


def ask_open(connection, address, interface):
    payload = struct.pack(">4II2I", *address, interface, 0, 1, 0, 0)
    connection.sendall(HEADER.pack(*address, 1, 0, REQUEST, 3, 0.0, 1, len(payload)) + payload)


def hear(connection):
    while True:
        header = HEADER.unpack(take(connection, HEADER.size))
        payload = take(connection, header[8])
        if header[4] != DATA or header[2] not in TOPICS:
            continue
        line = {"topic": TOPICS[header[2]], "at": time.time(), "seq": header[7], "stamp": header[6]}
        if header[2] == 4:
            line["x"], line["y"], _, line["linear"] = struct.unpack_from(">4d", payload)
        print(json.dumps(line), flush=True)


def drive(connection, address):
    payload = struct.pack(">3dI", SPEED, 0.0, TURN, 1)
    while True:
        connection.sendall(HEADER.pack(*address, 4, 0, COMMAND, 1, 0.0, 1, len(payload)) + payload)
        time.sleep(0.1)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("host")
    parser.add_argument("port", type=int)
    parser.add_argument("--drive", action="store_true")
    arguments = parser.parse_args()
    connection = socket.create_connection((arguments.host, arguments.port))
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    address = (struct.unpack("<I", socket.inet_aton(socket.gethostbyname(arguments.host)))[0], arguments.port)
    take(connection, 32)
    ask_open(connection, address, 4)
    if arguments.drive:
        drive(connection, address)
    ask_open(connection, address, 6)
    hear(connection)


if __name__ == "__main__":
    main()
