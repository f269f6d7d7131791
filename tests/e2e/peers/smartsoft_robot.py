#!/usr/bin/env python3
"""A robot of SmartSoft that waits for its clients as servers of push do by the published source of ACE/SmartSoft 3: they are written to one after the other, a
message that is not taken within a second is given up, however much of it was sent, and the client is kept. Says the port of its naming service."""
import socket
import struct
import threading
import time

from frames import SPEED
from smartsoft_client import CONNECT, END_OF_LIST, HEADER, LIST, SUBSCRIBE, UPDATE, receive, send, text

ACK_CONNECT, DISCONNECT, ACK_DISCONNECT, ACK_SUBSCRIBE, UNSUBSCRIBE = 1, 3, 4, 11, 12
PERIOD, PATIENCE = 0.05, 1.0
POINTS = 15_000         # 90 kB a scan: the buffers of the kernels are full soon, and what a guard holds is not
UUID = "e6eb50ee-e565-11f1-8000-67c6697351ff"
BASIC = "CommBasicObjects::"


class Cdr(bytearray):
    """Numbers, each at a multiple of its size."""

    def put(self, kind, *values):
        self += bytes(-len(self) % struct.calcsize(kind)) + struct.pack(f"<{len(values)}{kind}", *values)
        return self


def stamp(cdr, now):
    return cdr.put("I", int(now), int(now % 1 * 1e6))


def base_pose(cdr, now, x):
    cdr.put("?", False).put("I", 9).put("d", *[0.0] * 9).put("I", 0).put("d", x * 1000, *[0.0] * 5)
    stamp(cdr, now)


def base_state(now, begin):
    cdr = stamp(Cdr(), now)
    for _ in range(2):
        base_pose(cdr, now, SPEED * (now - begin))
    for _ in range(2):
        stamp(cdr.put("d", SPEED * 1000, *[0.0] * 5), now)
    cdr.put("d", 24.0).put("i", 80)
    stamp(stamp(cdr, 0), now).put("d", 0.0).put("?", False)
    return cdr.put("i", 0)


def scan(now, begin):
    """CommMobileLaserScan. All of its points are one, which is told again and again."""
    cdr = base_state(now, begin).put("?", True)
    stamp(cdr, now).put("Q", 0).put("d", 27000.0, 18000 / POINTS).put("H", 50, 8000, 1).put("I", POINTS)
    cdr.put("H", 0, 1500).put("B", 0)
    cdr += struct.pack("<xHHB", 1, 1500, 0) * (POINTS - 1)
    return cdr.put("H", POINTS).put("d", *[0.0] * 12)


class Push:
    """A service of push."""

    def __init__(self, made):
        self.made, self.clients = made, {}
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.address = f"127.0.0.1:{self.listening.getsockname()[1]}#{UUID}"
        threading.Thread(target=self.accept, daemon=True).start()
        threading.Thread(target=self.put, daemon=True).start()

    def accept(self):
        while True:
            threading.Thread(target=self.served, args=self.listening.accept()[:1], daemon=True).start()

    def served(self, peer):
        try:
            while True:
                command, first, _ = receive(peer)
                if command == CONNECT:
                    send(peer, ACK_CONNECT, struct.pack("<2i", 1, 0))
                elif command == SUBSCRIBE:
                    send(peer, ACK_SUBSCRIBE, struct.pack("<i", 1))
                    self.clients[peer] = first[4:8]
                elif command == UNSUBSCRIBE:
                    self.clients.pop(peer, None)
                elif command == DISCONNECT:
                    send(peer, ACK_DISCONNECT)
        except (SystemExit, OSError):
            self.clients.pop(peer, None)

    def put(self):
        begin = due = time.time()
        while True:
            data = bytes(self.made(time.time(), begin))
            for peer, subscription in list(self.clients.items()):
                written(peer, HEADER.pack(1, UPDATE, 4, len(data)) + subscription + data)
            due = max(due + PERIOD, time.time())
            time.sleep(max(0.0, due - time.time()))


def written(peer, message):
    """Whatever of it is taken within the patience."""
    end = time.monotonic() + PATIENCE
    view = memoryview(message)
    while view and (left := end - time.monotonic()) > 0:
        try:
            view = view[peer.send(view, socket.MSG_DONTWAIT):]
        except BlockingIOError:
            time.sleep(min(left, 0.002))
        except OSError:
            return


def main():
    services = {f"<base><Push><baseState><{BASIC}CommBaseState>": Push(base_state), f"<laser><Push><laserScan><{BASIC}CommMobileLaserScan>": Push(scan)}
    with socket.create_server(("127.0.0.1", 0)) as naming:
        print(naming.getsockname()[1], flush=True)
        while True:
            threading.Thread(target=named, args=(naming.accept()[0], services), daemon=True).start()


def texts(*words):
    body = bytearray()
    for word in words:
        body += bytes(-len(body) % 4) + text(word)
    return bytes(body)


def named(peer, services):
    try:
        while True:
            command, _, _ = receive(peer)
            assert command == LIST, command
            for name, service in services.items():
                send(peer, LIST, texts(name, service.address, "smartip"))
            send(peer, END_OF_LIST, texts("", "", ""))
    except (SystemExit, OSError):
        peer.close()


if __name__ == "__main__":
    main()
