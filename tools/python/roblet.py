"""A roblet in Python: an organ of a robot whose brain speaks as docs/roblets.md says. Needs Python 3.8 and nothing else.

    import roblet

    class Depth(roblet.Roblet):
        name, frequency = "depth", 5
        outputs = {"depth": {"as": "", "fields": {"metres": "number"}}}
        inputs = {"gain": {"fields": {"value": "number"}}}

        def run(self):
            self.say("depth", metres=12.5)

        def receive(self, sender, message):        # an xml.etree.ElementTree.Element
            print(sender, message.tag, message.attrib)

    Depth().live()                                 # at ROBLETS_BRAIN, else 127.0.0.1:7852

What run, start or receive raise ends that life of it: it is told to the brain, and another one begins. Ctrl+C, or SIGTERM, ends it.
"""
import os
import select
import signal
import socket
import time
import xml.etree.ElementTree as tree

MOST = 60_000
BEACON, PAUSE, LONGEST_PAUSE = 0.5, 0.5, 5.0


class Refused(ValueError):
    """What came is no datagram of roblets."""


def parse(data):
    """The root of a datagram. A document type is refused, so that there are no entities."""
    if len(data) > MOST or b"<!" in data.replace(b"<![CDATA[", b""):
        raise Refused("a datagram that is too large, or has a document type")
    try:
        root = tree.fromstring(data.decode("utf-8"))
    except (UnicodeDecodeError, tree.ParseError, RecursionError) as error:
        raise Refused(str(error)) from error
    if root.tag != "r4n" or len(root) > 1 or not all(root.get(name, "").isdigit() for name in ("run", "seq")):
        raise Refused("no datagram of roblets")
    return root


class Roblet:
    """To be inherited from. All methods are called by one thread."""
    name, frequency = "roblet", 1.0
    outputs, inputs, friends = {}, {}, ()

    def start(self):
        """Begins."""

    def run(self):
        """Does what it does once."""

    def receive(self, sender, message):
        """Takes a message of the brain, or of a roblet of which this one is a friend."""

    def stop(self):
        """Ends, also where it failed."""

    def say(self, message, **values):
        """Says something to the brain; a keyword for each attribute, or an element in place of the name."""
        if self._brain:
            self._send("message", "brain", self._element(message, values), self._brain)

    def tell(self, friend, message, **values):
        """Says something to a friend; False where the brain has not told yet where that is."""
        there = self._places.get(("friend", friend)) if friend in self.friends else None
        if there:
            self._send("message", friend, self._element(message, values), there)
        return bool(there)

    @staticmethod
    def _element(message, values):
        words = {True: "true", False: "false"}
        return message if isinstance(message, tree.Element) else tree.Element(
            message, {key: words[value] if isinstance(value, bool) else str(value) for key, value in values.items()})

    def _send(self, kind, to, body, there):
        self._sequences[to] = self._sequences.get(to, 0) + 1    # each receiver sees by it what it has missed
        root = tree.Element("r4n", {"kind": kind, "from": self.name, "run": str(self._run), "seq": str(self._sequences[to]),
                                    "at": "%.9f" % time.time(), "to": to})
        if body is not None:
            root.append(body)
        data = tree.tostring(root)
        if len(data) > MOST:
            raise ValueError("a message of %d bytes; not more than %d go in one datagram" % (len(data), MOST))
        try:
            self._socket.sendto(data, there)
        except OSError:
            pass    # nobody is told that a datagram was lost either

    def _beacon(self):
        root = tree.Element("roblet", {"name": self.name, "frequency": str(self.frequency), "state": self._state,
                                       "reason": self._reason, "restarts": str(self._restarts)})
        for direction, forms in (("output", self.outputs), ("input", self.inputs)):
            for name, form in forms.items():
                element = tree.SubElement(root, direction, {"name": name, "as": form.get("as", "")})
                for field, kind in form.get("fields", {}).items():
                    tree.SubElement(element, "field", {"name": field, "kind": kind, "unit": ""})
        for friend in self.friends:
            tree.SubElement(root, "friend", {"name": friend})
        self._send("beacon", "brain", root, self._address)
        self._beacon_at = time.monotonic() + self._pause
        self._pause = min(BEACON, 2 * self._pause)    # not more often where no answer comes: a brain without time has enough to read

    def _take(self, data, sender):
        root = parse(data)
        if root.get("to") != self.name or len(root) == 0:
            return
        if root.get("kind") == "welcome" and sender == self._address:
            self._brain = sender
            self._places = {(each.tag, each.get("name")): (each.get("host"), int(each.get("port", "0"))) for each in root[0]}
        elif root.get("kind") == "message" and sender == (
                self._brain if root.get("from") == "brain" else self._places.get(("speaker", root.get("from")))):
            key, now = (root.get("from"), root[0].tag), (int(root.get("run")), int(root.get("seq")))
            if now > self._last.get(key, (0, 0)) and (key in self._last or len(self._last) < 128):
                self._last[key] = now
                self.receive(root.get("from"), root[0])

    def _until(self, when):
        """Takes what comes, and sends beacons, up to a time."""
        while True:
            now = time.monotonic()
            if now >= self._beacon_at:
                self._beacon()
            if select.select([self._socket], [], [], max(0.0, min(when, self._beacon_at) - now))[0]:
                data, sender = self._socket.recvfrom(MOST + 1)
                try:
                    self._take(data, sender)
                except Refused:
                    pass    # whoever sent it is no brain
            if time.monotonic() >= when:
                return

    def _one_life(self):
        try:
            self.start()
            self._state, self._reason = "running", ""
            self._beacon()
            due = time.monotonic()
            while True:
                self._until(due)
                self.run()
                due = max(due + 1 / self.frequency, time.monotonic() - 1 / self.frequency)
        finally:
            self.stop()

    def live(self, brain=None):
        """Lives, and lives again, until the process is told to end."""
        host, _, port = (brain or os.environ.get("ROBLETS_BRAIN") or "127.0.0.1").partition(":")
        self._address = (socket.gethostbyname(host or "127.0.0.1"), int(port or 7852))
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1" if self._address[0].startswith("127.") else "0.0.0.0", 0))
        self._run, self._sequences, self._brain, self._places, self._last = int(time.time() * 1000), {}, None, {}, {}
        self._state, self._reason, self._restarts, self._beacon_at, self._pause = "starting", "", 0, 0.0, BEACON / 5
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        pause = PAUSE
        try:
            while True:
                begun = time.monotonic()
                try:
                    self._one_life()
                except Exception as error:    # whatever it is: the next life begins
                    self._state, self._reason = "failed", "%s: %s" % (type(error).__name__, error)
                    self._beacon()
                    pause = PAUSE if time.monotonic() - begun > 10 else min(2 * pause, LONGEST_PAUSE)
                    rest = time.monotonic() + pause
                    while time.monotonic() < rest:
                        time.sleep(0.1)
                        if time.monotonic() >= self._beacon_at:
                            self._beacon()
                    self._restarts, self._state = self._restarts + 1, "starting"
                    self._run, self._sequences = max(self._run + 1, int(time.time() * 1000)), {}
        except KeyboardInterrupt:
            self._send("leave", "brain", None, self._address)
