#!/usr/bin/env python3
"""An independent client of SmartSoft's components, written by recorded sessions: hears base states and scans, commands, or says what is named."""
import selectors
import socket
import struct
import sys

from frames import take, work

HEADER = struct.Struct("<B3x3i")
LIST, END_OF_LIST = 22, 11
CONNECT, COMMAND, UPDATE, SUBSCRIBE = 0, 6, 9, 10
HEARD = {"odom": ("base", "Push", "baseState"), "scan": ("laser", "Push", "laserScan")}
DRIVEN = ("base", "Send", "navigationVelocity")


def text(value):
    data = value.encode() + b"\0"
    return struct.pack("<i", len(data)) + data


def receive(connection):
    """The command of the next frame and its two parts."""
    order, command, first, second = HEADER.unpack(take(connection, HEADER.size))
    assert order == 1
    return command, take(connection, first), take(connection, second)


def send(connection, command, first=b"", second=b""):
    connection.sendall(HEADER.pack(1, command, len(first), len(second)) + first + second)


class Fields:
    """CDR, read from the beginning."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, kind, count=1):
        size = struct.calcsize(kind)
        self.at += -self.at % size
        values = struct.unpack_from(f"<{count}{kind}", self.data, self.at)
        self.at += size * count
        return values if count > 1 else values[0]

    def pose(self):
        """x and y of a CommBasePose, mm."""
        self.take("?")
        self.take("d", self.take("I") or 1)          # the covariance is never empty here
        self.take("I")
        x, y, *_ = self.take("d", 6)
        self.take("I", 2)
        return x, y


class SmartSoft:
    def __init__(self, host, port):
        self.naming = (host, port)

    def services(self):
        """The addresses of all services by component, pattern and service."""
        found = {}
        with socket.create_connection(self.naming) as connection:
            send(connection, LIST, text("smart"))
            while (entry := receive(connection))[0] != END_OF_LIST:
                fields = Fields(entry[1])
                name, address = (fields.data[fields.at:][:length].rstrip(b"\0").decode() for length in self.lengths(fields))
                found[tuple(name.strip("<>").split("><")[:3])] = address
        return found

    @staticmethod
    def lengths(fields):
        for _ in range(2):
            length = fields.take("i")
            yield length
            fields.at += length

    def known(self):
        return ["/".join(name) for name in self.services()]

    def connected(self, name):
        """A link to a service that has acknowledged it."""
        address, _, number = self.services()[name].partition("#")
        host, _, port = address.partition(":")
        connection = socket.create_connection((host, int(port)))
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        send(connection, CONNECT, struct.pack("<i", 1) + text(number))
        receive(connection)
        return connection

    def driver(self):
        connection = self.connected(DRIVEN)
        return lambda speed, turn: send(connection, COMMAND, second=struct.pack("<3d", speed * 1000, 0, turn))

    def hear(self, teller):
        waiting = selectors.DefaultSelector()
        for topic, name in HEARD.items():
            connection = self.connected(name)
            send(connection, SUBSCRIBE, struct.pack("<2i", 1, 1))
            waiting.register(connection, selectors.EVENT_READ, topic)
        while True:
            for key, _ in waiting.select():
                command, _, data = receive(key.fileobj)
                if command == UPDATE:
                    self.updated(teller, key.data, Fields(data))

    @staticmethod
    def updated(teller, topic, fields):
        seconds, micros = fields.take("I", 2)        # a base state begins with its time, and a scan with a base state
        more = {}
        if topic == "odom":
            fields.pose()
            x, y = fields.pose()
            more = {"x": x / 1000, "y": y / 1000, "linear": fields.take("d") / 1000}
        teller.tell(topic, seconds + micros / 1e6, **more)


if __name__ == "__main__":
    work(SmartSoft, sys.argv[1:])
