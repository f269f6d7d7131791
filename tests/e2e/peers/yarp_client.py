#!/usr/bin/env python3
"""An independent port of YARP, written by recorded sessions: hears odometry and laser by fast_tcp, commands, or says what the name server knows."""
import os
import selectors
import socket
import struct
import sys

from frames import take, work

FAST_TCP, DATA = 0x1e64, 0x0a
REAL_LIST = 256 + 10
ROBOT = "/natalie"
HEARD = {"odom": f"{ROBOT}/odo/odometry:o", "scan": f"{ROBOT}/laser"}


def mark(number):
    return b"YA" + struct.pack("<i", number) + b"RP"


def taken(connection):
    """The number between YA and RP."""
    head = take(connection, 8)
    assert head[:2] == b"YA" and head[6:] == b"RP", head
    return struct.unpack_from("<i", head, 2)[0]


def receive(connection):
    """The envelope and the data of the next message."""
    assert taken(connection) == DATA
    blocks = take(connection, 10)[0]
    lengths = struct.unpack(f"<{blocks}i", take(connection, 4 * blocks))
    take(connection, 4)
    payload = take(connection, sum(lengths))
    envelope = 8 + struct.unpack_from("<i", payload)[0]
    return payload[8:envelope].rstrip(b"\0").decode(), payload[envelope:]


class Yarp:
    def __init__(self, host, port):
        self.server = (host, port)

    def names(self, command):
        """What the name server answers to a line of text."""
        with socket.create_connection(self.server) as connection:
            connection.sendall(f"NAME_SERVER {command}\n".encode())
            return b"".join(iter(lambda: connection.recv(65536), b"")).decode().splitlines()

    def known(self):
        """The names of all ports, and to whom the robot's odometry is said."""
        ports = [line.split()[2] for line in self.names("list") if line.startswith("registration")]
        return ports + [line for line in self.told(HEARD["odom"], "*") if "output connection" in line and "/peer-" not in line]

    def address(self, name):
        words = self.names(f"query {name}")[0].split()
        return words[4], int(words[6])

    def told(self, name, line):
        """What a port answers to a line of text."""
        with socket.create_connection(self.address(name)) as connection:
            connection.sendall(f"CONNECT peer\n{line}\nq\n".encode())
            return b"".join(iter(lambda: connection.recv(65536), b"")).decode().splitlines()

    def driver(self):
        connection = socket.create_connection(self.address(f"{ROBOT}/base/data:i"))
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        name = b"/driver\0"
        connection.sendall(mark(FAST_TCP) + struct.pack("<i", len(name)) + name)
        taken(connection)

        def command(speed, turn):
            payload = b"\0\0\0\0\x7e\x64\0\x01" + struct.pack("<2i3d", REAL_LIST, 3, speed, 0, turn * 57.29577951308232)
            connection.sendall(mark(DATA) + b"\x01\x01" + b"\xff" * 8 + struct.pack("<2i", len(payload), 0) + payload)
        return command

    def hear(self, teller):
        waiting = selectors.DefaultSelector()
        for topic, port in HEARD.items():
            waiting.register(self.opened(f"/peer-{os.getpid()}/{topic}", port), selectors.EVENT_READ, topic)
        while True:
            for key, _ in waiting.select():
                envelope, data = receive(key.fileobj)
                stamp = float(envelope.split()[2])
                if key.data == "odom":
                    code, count, x, y, _, speed = struct.unpack_from("<2i4d", data)
                    assert (code, count) == (REAL_LIST, 9)
                    teller.tell("odom", stamp, x=x, y=y, linear=speed)
                else:
                    teller.tell(key.data, stamp)

    def opened(self, name, port):
        """The connection from a port of the robot, which is told to connect to us."""
        with socket.create_server(("127.0.0.1", 0)) as listening:
            self.names(f"register {name} tcp 127.0.0.1 {listening.getsockname()[1]}")
            self.told(port, f"/fast_tcp:/{name}")
            connection, _ = listening.accept()
        assert taken(connection) == FAST_TCP
        take(connection, struct.unpack("<i", take(connection, 4))[0])
        connection.sendall(mark(0))
        return connection


if __name__ == "__main__":
    work(Yarp, sys.argv[1:])
