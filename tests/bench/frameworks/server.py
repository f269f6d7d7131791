#!/usr/bin/python3
"""A server of one framework that says the same scan as fast as it is taken: FRAMEWORK [RECORDINGS], then says its address. The first line of input is
where the client listens, for frameworks that connect to it; for each further line N it says N scans."""
import pathlib
import socket
import struct
import sys
import threading
import time
import xmlrpc.server
from concurrent.futures import ThreadPoolExecutor

import scans
from carmen_central import Central, answers, message, take

TOPIC, MD5 = "/scan", "90c7ef2dc6895d81024acba2ac42f369"
UUID = "e6eb50ee-e565-11f1-8000-67c6697351ff"
SMART = struct.Struct("<B3x3i")
UPDATE, ACK_CONNECT, ACK_SUBSCRIBE, SUBSCRIBE = 9, 1, 11, 10
BULK = 100


def accepted(listening):
    peer, _ = listening.accept()
    peer.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return peer


def drained(peer):
    """Takes what the peer says, and forgets it."""
    def drain():
        while peer.recv(1 << 16):
            pass
    threading.Thread(target=drain, daemon=True).start()
    return peer


class Ros:
    """A master and a node in one."""

    def __init__(self):
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.calls = xmlrpc.server.SimpleXMLRPCServer(("127.0.0.1", 0), logRequests=False, allow_none=True)
        self.calls._dispatch = self.call
        self.address = f"http://127.0.0.1:{self.calls.server_address[1]}/"
        threading.Thread(target=self.calls.serve_forever, daemon=True).start()

    def call(self, method, parameters):
        if method == "registerSubscriber":
            return [1, "", [self.address] if parameters[1] == TOPIC else []]
        if method == "requestTopic":
            return [1, "", ["TCPROS", "127.0.0.1", self.listening.getsockname()[1]]]
        if method in ("getParam", "subscribeParam"):
            return [1, "", False]
        return [1, "", [] if method in ("registerPublisher", "getPublishedTopics", "getTopicTypes") else 0]

    def connect(self, _):
        peer = accepted(self.listening)
        take(peer, *struct.unpack("<I", take(peer, 4)))
        fields = ("callerid=/server", "type=sensor_msgs/LaserScan", f"md5sum={MD5}", "latching=0", "message_definition=")
        header = b"".join(struct.pack("<I", len(field)) + field.encode() for field in fields)
        peer.sendall(struct.pack("<I", len(header)) + header)
        scan = scans.ros()
        return drained(peer), struct.pack("<I", len(scan)) + scan


class Carmen:
    NAME = "carmen_robot_frontlaser"

    def __init__(self, recordings):
        self.central = Central(answers(pathlib.Path(recordings)))
        self.address = str(self.central.port)

    def connect(self, _):
        while not self.central.handlers.get(self.NAME):
            time.sleep(0.01)
        return self.central.peer, message(self.central.handlers[self.NAME], self.NAME, scans.carmen())


class Yarp:
    address = "0"

    def connect(self, client):
        peer = socket.create_connection(("127.0.0.1", int(client())))
        name = b"/server/scan:o\0"
        peer.sendall(b"YA" + struct.pack("<i", 0x1e64) + b"RP" + struct.pack("<i", len(name)) + name)
        take(peer, 8)
        envelope = b"D 1 1.000000\0"
        head = struct.pack("<i", len(envelope)) + b"\x7e\0\0\x01" + envelope
        scan = scans.yarp()
        index = struct.pack("<2B8s3i", 2, 1, b"\xff" * 8, len(head), len(scan), 0)
        return drained(peer), b"YA\x0a\0\0\0RP" + index + head + scan


class SmartSoft:
    def __init__(self):
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.address = f"127.0.0.1:{self.listening.getsockname()[1]}#{UUID}"

    def connect(self, _):
        peer = accepted(self.listening)
        while True:
            _, command, first, second = SMART.unpack(take(peer, SMART.size))
            said = take(peer, first + second)
            if command == SUBSCRIBE:
                break
            peer.sendall(SMART.pack(1, ACK_CONNECT, 8, 0) + struct.pack("<2i", 1, 0))
        peer.sendall(SMART.pack(1, ACK_SUBSCRIBE, 4, 0) + struct.pack("<i", 1))
        scan = scans.smartsoft()
        return drained(peer), SMART.pack(1, UPDATE, 4, len(scan)) + said[4:8] + scan


def main():
    made = {"ros": Ros, "carmen": Carmen, "yarp": Yarp, "smartsoft": SmartSoft}[sys.argv[1]](*sys.argv[2:])
    print(made.address, flush=True)
    with ThreadPoolExecutor() as threads:
        client = threads.submit(lambda: sys.stdin.readline().strip())      # says it once it is connected, where it connects to us
        peer, scan = made.connect(client.result)
        client.result()
    print(len(scan), flush=True)
    bulk = scan * BULK
    for line in sys.stdin:
        for _ in range(int(line) // BULK):
            peer.sendall(bulk)
        print('"sent"', flush=True)


if __name__ == "__main__":
    main()
