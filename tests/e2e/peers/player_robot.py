#!/usr/bin/env python3
"""A robot behind a Player server that does everything in one loop: reads requests, moves, and writes to all clients, one after the other.

So a client that does not read holds up the robot itself. Each cycle takes 50 ms and moves by a fixed step, so that the place depends on the
commands alone. One JSON line tells each change of who has what open, each command, and each cycle that was late.
"""
import argparse
import json
import math
import select
import socket
import struct
import time

PERIOD = 0.05
DATA, COMMAND, REQUEST, ACK, NACK = 1, 2, 3, 4, 6
PLAYER, POSITION2D, LASER, CAMERA = 1, 4, 6, 40
DEVICES = {POSITION2D: "position2d", LASER: "laser", CAMERA: "camera"}
HEADER = struct.Struct(">IIIIIIdII")
WIDTH, HEIGHT = 320, 240
IMAGE = struct.pack(">IIIIIIII", WIDTH, HEIGHT, 24, 5, 1, 0, WIDTH * HEIGHT * 3, WIDTH * HEIGHT * 3) + bytes(WIDTH * HEIGHT * 3)
SCAN = struct.pack(">ffff", -1.5, 1.5, 3.0 / 360, 8.0) + struct.pack(">II361f", 361, 361, *([2.0] * 361)) + struct.pack(">III", 0, 0, 0)


def say(**what):
    print(json.dumps({"at": time.time()} | what), flush=True)


class Client:
    """One connection; a write waits until the client takes it."""

    def __init__(self, connection, number):
        self.connection, self.number = connection, number
        self.buffer, self.open = b"", set()
        connection.sendall(b"Player v.3.1.1-dev".ljust(32, b"\0"))

    def messages(self):
        data = self.connection.recv(65536)
        if not data:
            raise OSError("closed")
        self.buffer += data
        while len(self.buffer) >= HEADER.size:
            header = HEADER.unpack_from(self.buffer)
            if len(self.buffer) < HEADER.size + header[8]:
                return
            payload, self.buffer = self.buffer[HEADER.size:HEADER.size + header[8]], self.buffer[HEADER.size + header[8]:]
            yield header, payload


class Robot:
    """The server and what it drives."""

    def __init__(self, host, port):
        self.server = socket.create_server((host, port))
        self.address = (struct.unpack("<I", socket.inet_aton(host))[0], self.server.getsockname()[1])
        self.clients, self.count, self.step = [], 0, 0
        self.sent = dict.fromkeys(DEVICES, 0)
        self.x = self.y = self.heading = self.forward = self.turn = 0.0
        say(event="port", port=self.address[1])

    def run(self):
        due = time.monotonic()
        while True:
            due += PERIOD
            self.listen(due)
            late = time.monotonic() - due
            begin = time.monotonic()
            self.cycle()
            took = time.monotonic() - begin
            if took > PERIOD or late > PERIOD:
                say(event="late", took=took, late=late)
            due = max(due, time.monotonic() - 1)      # what was late is made up for, within a second

    def listen(self, until):
        while (left := until - time.monotonic()) > 0:
            ready, _, _ = select.select([self.server, *(client.connection for client in self.clients)], [], [], left)
            for each in ready:
                if each is self.server:
                    self.accept()
                else:
                    self.attempt(next(client for client in self.clients if client.connection is each), self.serve)

    def accept(self):
        connection, _ = self.server.accept()
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.count += 1
        self.clients.append(Client(connection, self.count))
        say(event="came", client=self.count)

    def attempt(self, client, action):
        try:
            action(client)
        except OSError:
            client.connection.close()
            self.clients.remove(client)
            say(event="gone", client=client.number)

    def serve(self, client):
        for header, payload in client.messages():
            interface, kind, subtype = header[2], header[4], header[5]
            if kind == COMMAND and interface == POSITION2D and subtype == 1:
                self.forward, _, self.turn = struct.unpack_from(">3d", payload)
                say(event="command", client=client.number, forward=self.forward)
            elif kind == REQUEST:
                self.answer(client, header, payload, self.reply(client, interface, subtype, payload))

    def reply(self, client, interface, subtype, payload):
        if interface == PLAYER and subtype == 1:
            return struct.pack(">II", len(DEVICES), len(DEVICES)) + b"".join(struct.pack(">4I", *self.address, each, 0) for each in DEVICES)
        if interface == PLAYER and subtype == 2:
            return payload[:16] + struct.pack(">II8s", 6, 6, b"robot")
        if interface == PLAYER and subtype == 3:
            device, access = struct.unpack_from(">2I", payload, 8)[0], struct.unpack_from(">I", payload, 16)[0]
            (client.open.add if access == 1 else client.open.discard)(device)
            say(event="open" if access == 1 else "close", client=client.number, device=DEVICES[device])
            return payload[:20] + struct.pack(">II8s", 6, 6, b"robot")
        if interface == PLAYER and subtype in (5, 10):
            return b""
        if interface in (POSITION2D, LASER) and subtype == 1:
            return struct.pack(">9d", *([0.0] * 6), 0.4, 0.4, 0.2)
        return None

    def answer(self, client, header, payload, reply):
        kind, payload = (NACK, b"") if reply is None else (ACK, reply)
        client.connection.sendall(HEADER.pack(*header[:4], kind, header[5], time.time(), header[7], len(payload)) + payload)

    def cycle(self):
        self.step += 1
        self.heading += self.turn * PERIOD
        self.x += self.forward * math.cos(self.heading) * PERIOD
        self.y += self.forward * math.sin(self.heading) * PERIOD
        self.publish(POSITION2D, struct.pack(">6dI", self.x, self.y, self.heading, self.forward, 0.0, self.turn, 0))
        if self.step % 2 == 0:
            self.publish(LASER, SCAN)
            self.publish(CAMERA, IMAGE)

    def publish(self, interface, payload):
        # A number stands where real servers write none: it tells listeners what they missed.
        self.sent[interface] += 1
        data = HEADER.pack(*self.address, interface, 0, DATA, 1, time.time(), self.sent[interface], len(payload)) + payload
        for client in [each for each in self.clients if interface in each.open]:
            self.attempt(client, lambda each: each.connection.sendall(data))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=0)
    arguments = parser.parse_args()
    Robot(arguments.host, arguments.port).run()


if __name__ == "__main__":
    main()
