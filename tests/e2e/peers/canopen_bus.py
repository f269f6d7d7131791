"""The simulated CAN bus of robotui for python-can: a socket whose messages are frames of the kernel (struct can_frame)."""
import os
import selectors
import socket
import struct
import time

import can

FRAME = struct.Struct("<IB3x8s")


def packed(message):
    identifier = message.arbitration_id | (0x80000000 if message.is_extended_id else 0) | (0x40000000 if message.is_remote_frame else 0)
    return FRAME.pack(identifier, message.dlc, bytes(message.data).ljust(8, b"\0"))


def unpacked(frame):
    identifier, length, data = FRAME.unpack(frame)
    return can.Message(arbitration_id=identifier & 0x1FFFFFFF, is_extended_id=bool(identifier & 0x80000000), timestamp=time.time(),
                       is_remote_frame=bool(identifier & 0x40000000), dlc=length, data=data[:length])


class JoinedBus(can.BusABC):
    """One that somebody else simulates."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.socket.connect(path)
        super().__init__(channel=path)

    def send(self, msg, timeout=None):
        self.socket.send(packed(msg))

    def _recv_internal(self, timeout):
        self.socket.settimeout(timeout)
        try:
            frame = self.socket.recv(FRAME.size)
        except (TimeoutError, BlockingIOError):
            return None, False
        return (unpacked(frame) if len(frame) == FRAME.size else None), False

    def shutdown(self):
        super().shutdown()
        self.socket.close()


class OwnBus(can.BusABC):
    """One that is simulated here, and that others join: what one of them sends, the others hear."""

    def __init__(self, path):
        self.members = []
        self.selector = selectors.DefaultSelector()
        self.door = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.door.bind(path)
        self.door.listen()
        self.selector.register(self.door, selectors.EVENT_READ)
        self.path = path
        self.waiting = []
        super().__init__(channel=path)

    def send(self, msg, timeout=None):
        self.spread(packed(msg), None)

    def spread(self, frame, sender):
        for member in list(self.members):
            if member is not sender:
                try:
                    member.send(frame, socket.MSG_DONTWAIT)
                except OSError:
                    pass                # it does not read, or has left: it misses the frame

    def _recv_internal(self, timeout):
        if not self.waiting:
            for key, _ in self.selector.select(timeout):
                self.admit() if key.fileobj is self.door else self.hear(key.fileobj)
        return (unpacked(self.waiting.pop(0)) if self.waiting else None), False

    def admit(self):
        member, _ = self.door.accept()
        self.members.append(member)
        self.selector.register(member, selectors.EVENT_READ)

    def hear(self, member):
        frame = member.recv(FRAME.size)
        if not frame:
            self.selector.unregister(member)
            self.members.remove(member)
        elif len(frame) == FRAME.size:
            self.spread(frame, member)
            self.waiting.append(frame)

    def shutdown(self):
        super().shutdown()
        os.unlink(self.path)
