#!/usr/bin/env python3
"""An independent module at a central of CARMEN, written by recorded sessions: hears odometry and front laser, commands, or says what is handled."""
import os
import socket
import struct
import sys
import time

from frames import take, work

HEADER = struct.Struct(">3ii3i")
LITTLE, QUERY, INFORM, COMPLETION, BROADCAST = 0x22000000, 3, 6, 0x0c, 0x0f
NONE, INFO = -1, 182
WAITING = 100      # messages that the central keeps
HEARD = {199: ("odom", "carmen_base_odometry"), 198: ("scan", "carmen_robot_frontlaser")}


def text(value):
    data = value.encode()
    return struct.pack("<i", len(data)) + (data or b"Z")


class Carmen:
    def __init__(self, host, port):
        self.socket = socket.create_connection((host, port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        assert struct.unpack(">i", take(self.socket, 4))[0] == INFO
        self.name, self.reference = f"peer-{os.getpid()}", 0
        self.ask("x_ipc_newModuleConnectMsg", text(self.name) + text("robot"))
        self.inform("x_ipc_registerResourceMsg", struct.pack("<i", 4) + text(self.name))

    def send(self, intent, kind, body=b"", parent=NONE, dispatch=NONE, reference=None):
        if reference is None:
            self.reference += 1
            reference = self.reference
        self.socket.sendall(HEADER.pack(0, len(body), parent, intent, LITTLE | kind, dispatch, reference) + body)
        return reference

    def receive(self):
        length, more, _, intent, kind, _, reference = HEADER.unpack(take(self.socket, HEADER.size))
        return intent, kind & 0xff, reference, take(self.socket, length + more)[length:]

    def answer(self, asked):
        while True:
            _, _, reference, body = self.receive()
            if reference == asked:
                return body

    def number(self, message):
        body = self.answer(self.send(INFO, QUERY, text(message) + text("")))
        assert body[:1] == b"Z", f"the central knows no {message}"
        return struct.unpack_from("<i", body, 1)[0]

    def ask(self, message, body=b""):
        return self.answer(self.send(self.number(message), QUERY, body))

    def inform(self, message, body):
        self.send(self.number(message), INFORM, body)

    def known(self):
        """The names of all messages that some module handles."""
        body = self.ask("V_get_X_IPC_BROADCAST_MSG_VAR")
        count, at, names = struct.unpack_from("<i", body)[0], 12, []
        for _ in range(count):
            length, = struct.unpack_from("<i", body, at)
            names.append(body[at + 4:at + 4 + length].decode())
            at += 4 + length
        return names

    def driver(self):
        number = self.number("carmen_robot_vel")

        def command(speed, turn):
            content = struct.pack("<3d", speed, turn, time.time()) + text("robot")
            self.send(number, BROADCAST, struct.pack("<2i", len(content), len(content)) + content)
        return command

    def hear(self, teller):
        for handler, (_, message) in HEARD.items():
            self.inform("x_ipc_registerHandlerMsg", struct.pack("<i", handler) + text(message) + text(f"HND-{message}"))
            self.inform("x_ipc_limitPendingMsg", text(message) + text(self.name) + struct.pack("<i", WAITING))
        while True:
            intent, _, reference, body = self.receive()
            if intent not in HEARD:
                continue
            self.send(NONE, COMPLETION, parent=reference, dispatch=reference, reference=NONE)
            topic = HEARD[intent][0]
            if topic == "odom":
                x, y, _, speed, _, _, stamp = struct.unpack_from("<7d", body, 8)
                teller.tell(topic, stamp, x=x, y=y, linear=speed)
            else:
                teller.tell(topic, scan_stamp(body))


def scan_stamp(body):
    at = 8 + 4 + 48                                 # behind the number of the laser and how it is configured
    for prefix, size in ((4, 4), (0, 1), (4, 4)):   # ranges, which of them are too close, remissions: how many, and how many again
        count, = struct.unpack_from("<i", body, at + prefix)
        at += prefix + 4 + size * count
    return struct.unpack_from("<d", body, at + 11 * 8)[0]


if __name__ == "__main__":
    work(Carmen, sys.argv[1:])
