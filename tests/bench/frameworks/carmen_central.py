"""A central of CARMEN that knows what a recorded one knew: it answers with the recorded bytes, and remembers who handles what."""
import socket
import struct
import threading

HEADER = struct.Struct(">3ii3i")
LITTLE, QUERY, BROADCAST = 0x22000000, 3, 0x0f
INFO, REPLY, NONE = 182, -4, -1
HANDLED = struct.pack("<3i", 0, 0, 0)       # nobody handles anything
VERSION = struct.pack("<3i", 3, 8, 0)       # messages go through the central


def answers(folder):
    """What the recorded central knew of messages, by their names."""
    known = {}
    for file in sorted(folder.glob("*.s2c.bin")):
        if not file.name.startswith(("base_", "localize_")):
            continue
        data, at = file.read_bytes(), 4
        while at < len(data):
            length, more, _, intent, *_ = HEADER.unpack_from(data, at)
            body = data[at + HEADER.size + length:at + HEADER.size + length + more]
            at += HEADER.size + length + more
            if intent == REPLY and body[:1] == b"Z" and len(body) > 9 and (name := text_at(body, 5)):
                known.setdefault(name, body)
    return known


def text_at(body, at):
    """A text behind its length, or nothing where there is none."""
    length, = struct.unpack_from("<i", body, at)
    text = body[at + 4:at + 4 + length]
    return text.decode() if 3 < length <= len(body) and text.replace(b"_", b"").isalnum() else ""


def take(peer, size):
    parts = bytearray(size)
    view = memoryview(parts)
    while view:
        count = peer.recv_into(view)
        if not count:
            raise EOFError
        view = view[count:]
    return bytes(parts)


def message(handler, name, content):
    """A message on its way to a handler. It is named each time, which a real central does the first time alone."""
    label = struct.pack("<i", len(name)) + name.encode()
    body = struct.pack("<2i", len(content), len(content)) + content
    return HEADER.pack(len(label), len(body), NONE, handler, LITTLE | BROADCAST, NONE, 1) + label + body


def text(value):
    return struct.pack("<i", len(value)) + value.encode()


class Central:
    """Open from its making on. `handlers` has the number that the last module gave to each message that it handles, and `peer` is its link."""

    def __init__(self, known):
        self.known = known
        self.numbers = {struct.unpack_from("<i", body, 1)[0]: name for name, body in known.items()}
        self.handlers = {}
        self.peer = None
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.port = self.listening.getsockname()[1]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            peer, _ = self.listening.accept()
            peer.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            peer.sendall(struct.pack(">i", INFO))
            self.handlers = {}
            self.peer = peer
            try:
                self.serve(peer)
            except (EOFError, OSError):
                self.handlers = {}

    def serve(self, peer):
        while True:
            length, more, _, intent, kind, _, reference = HEADER.unpack(take(peer, HEADER.size))
            body = take(peer, length + more)[length:]
            if kind & 0xff == QUERY:
                answer = self.answer(intent, body)
                peer.sendall(HEADER.pack(0, len(answer), 0, REPLY, LITTLE, 0, reference) + answer)
            elif self.numbers.get(intent) == "x_ipc_registerHandlerMsg":
                number, name = struct.unpack_from("<i", body)[0], text_at(body, 4)
                self.handlers[name] = number

    def answer(self, intent, body):
        if intent == INFO:
            return self.known.get(text_at(body, 0), b"\0")
        return VERSION if self.numbers.get(intent) == "x_ipc_newModuleConnectMsg" else HANDLED
