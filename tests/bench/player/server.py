#!/usr/bin/python3
"""A Player server that sends what a real one was recorded to send, as fast as it is taken: RECORDING, then says PORT, and for each line of input N
sends all its data N times. It says yes to whatever it is asked."""
import socket
import struct
import sys
import threading

HEADER = struct.Struct(">6IdII")
BANNER = 32
DATA, ACK = 1, 4
PLAYER, LIST = 1, 1


def recorded(file):
    """The banner, and the data messages as they came."""
    with open(file, "rb") as stream:
        banner = stream.read(BANNER)
        data = []
        while header := stream.read(HEADER.size):
            fields = HEADER.unpack(header)
            payload = stream.read(fields[8])
            if fields[4] == DATA and (fields[2] != 62 or fields[5] == 1):
                data.append((fields, header + payload))
    return banner, data


def take(peer, size):
    parts = b""
    while len(parts) < size:
        more = peer.recv(size - len(parts))
        if not more:
            raise EOFError
        parts += more
    return parts


def answer_requests(peer, devices):
    while True:
        fields = HEADER.unpack(take(peer, HEADER.size))
        payload = take(peer, fields[8])
        if (fields[2], fields[5]) == (PLAYER, LIST):
            payload = struct.pack(">II", len(devices), len(devices)) + b"".join(struct.pack(">4I", *device) for device in devices)
        peer.sendall(HEADER.pack(*fields[:4], ACK, fields[5], 0.0, fields[7], len(payload)) + payload)


def main():
    banner, data = recorded(sys.argv[1])
    devices = sorted({fields[:4] for fields, _ in data})
    bulk = b"".join(message for _, message in data)
    with socket.create_server(("127.0.0.1", 0)) as server:
        print(server.getsockname()[1], flush=True)
        peer, _ = server.accept()
    peer.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    peer.sendall(banner)

    def answering():
        try:
            answer_requests(peer, devices)
        except (EOFError, OSError):
            pass

    threading.Thread(target=answering, daemon=True).start()
    for line in sys.stdin:
        for _ in range(int(line)):
            peer.sendall(bulk)
        print('"sent"', flush=True)


if __name__ == "__main__":
    main()
