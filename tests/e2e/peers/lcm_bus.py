"""LCM without its library, for independent peers: a bus by multicast (udpm) or by a server (tcpq)."""
import select
import socket
import struct

SHORT = 0x4c433032


class Multicast:
    """udpm, for messages of one packet."""

    def __init__(self, group, port):
        self.to, self.number = (group, port), 0
        self.out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        self.socket.bind(self.to)
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, struct.pack("4sI", socket.inet_aton(group), socket.INADDR_ANY))

    def send(self, channel, data):
        self.out.sendto(struct.pack(">II", SHORT, self.number) + channel.encode() + b"\0" + data, self.to)
        self.number += 1

    def receive(self):
        packet = self.socket.recv(65536)
        if struct.unpack_from(">I", packet)[0] != SHORT:
            return "", b""
        channel, _, data = packet[8:].partition(b"\0")
        return channel.decode(), data


class Server:
    """tcpq, as a client of a server."""

    def __init__(self, host, port):
        self.socket = socket.create_connection((host, port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.sendall(struct.pack(">II", 0x287617fb, 0x0100))
        self._take(8)

    def _take(self, count):
        data = b""
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            if not more:
                raise SystemExit("the server is gone")
            data += more
        return data

    def _part(self):
        return self._take(struct.unpack(">I", self._take(4))[0])

    def listen(self, channels):
        self.socket.sendall(struct.pack(">II", 2, len(channels)) + channels.encode())

    def send(self, channel, data):
        name = channel.encode()
        self.socket.sendall(struct.pack(">II", 1, len(name)) + name + struct.pack(">I", len(data)) + data)

    def receive(self):
        self._take(4)
        return self._part().decode(), self._part()


def open_bus(url, channels):
    """From udpm://GROUP:PORT or tcpq://HOST:PORT; listens to channels, which udpm brings all."""
    kind, _, rest = url.partition("://")
    host, _, port = rest.partition("?")[0].partition(":")
    if kind == "udpm":
        return Multicast(host, int(port))
    bus = Server(host, int(port))
    if channels:
        bus.listen(channels)
    return bus


def waiting(bus, seconds):
    """Whether something is there to be received within a time."""
    return bool(select.select([bus.socket], [], [], max(0.0, seconds))[0])
