"""Runs scripts in a RobotUI of this user from Python: see docs/scripting.md. Needs nothing but the standard library.

    import robotui
    with robotui.connect() as ui:
        ui.run("takeControl()")
        print(ui.value("base.odom")["pose"])

RobotUI must have been started with --script-socket. One thread at a time may use a connection.
"""
import json
import math
import os
import pathlib
import socket

LONGEST_ANSWER = 200 << 20


class Error(Exception):
    """A script failed or was stopped, or there is no RobotUI that can be reached. line is 0 where it is not known."""

    def __init__(self, message, line=0):
        super().__init__(message)
        self.line = line


class Exit(Error):
    """A script has called exit(code)."""

    def __init__(self, code):
        super().__init__(f"exit({code})")
        self.code = code


def folder():
    """Where the sockets of this user lie."""
    state = os.environ.get("XDG_STATE_HOME", "")
    base = pathlib.Path(state) if state.startswith("/") else pathlib.Path.home() / ".local/state"
    return base / "robotui/run"


def connect(path=None, timeout=10, output=print):
    """Connects to the RobotUI at a socket (--script-socket names it), else to the newest one of this user.

    timeout: seconds that a connection may take. output is given what scripts print.
    """
    if path is not None:
        return Connection(path, timeout, output)
    for found in sorted(folder().glob("script-*.sock"), key=lambda p: p.stat().st_mtime, reverse=True):
        try:
            return Connection(found, timeout, output)
        except ConnectionRefusedError:
            continue  # its process was killed
    raise Error(f"no RobotUI listens in {folder()}; start it with: ./robotui run --script-socket")


class Connection:
    """Scripts that are run share their variables. What they took control of is given back at the end."""

    def __init__(self, path, timeout=10, output=print):
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._socket.settimeout(timeout)
        try:
            self._socket.connect(os.fspath(path))
        except OSError:
            self._socket.close()
            raise
        self._socket.settimeout(None)
        self._lines = self._socket.makefile("rb")
        self._output = output
        self._id = 0

    def __enter__(self):
        return self

    def __exit__(self, *failure):
        self.close()

    def close(self):
        """Ends it. What scripts of this connection move is stopped."""
        self._lines.close()
        self._socket.close()

    def run(self, script, name="python", seconds=None):
        """Runs a script to its end and gives the value of its last expression.

        seconds: after which it is stopped; without, it may run for any time.
        """
        self._id += 1
        self._send({"id": self._id, "run": script, "name": name})
        self._socket.settimeout(seconds)
        try:
            return self._outcome(self._await(self._id))
        except TimeoutError:
            return self._stop(seconds)
        except KeyboardInterrupt:
            self._stop(None)
            raise
        finally:
            self._socket.settimeout(None)

    def call(self, function, *arguments):
        """Calls one function, such as call("drive", 0.2, 0, 1). Arguments are plain values."""
        if not function.isidentifier():
            raise Error(f"{function!r} is no function")
        return self.run(f"{function}({', '.join(_literal(a) for a in arguments)})")

    def value(self, port, *ui):
        """The newest value of a stream, as a dict with the fields of its type, in SI units."""
        return self.call("value", port, *ui)

    def wait(self, condition, seconds=10):
        """Waits until an expression is true, and gives its value."""
        return self.run(f"waitFor(() => ({condition}), {_literal(seconds)})")

    def _send(self, request):
        self._socket.sendall(json.dumps(request).encode() + b"\n")

    def _await(self, number):
        while True:
            line = self._lines.readline(LONGEST_ANSWER)
            if not line.endswith(b"\n"):
                raise Error("RobotUI has closed the connection")
            answer = json.loads(line)
            if answer["id"] == number:
                return answer
            if "print" in answer:
                self._output(answer["print"])
            elif "error" in answer and answer["id"] == 0:
                raise Error(answer["error"])

    @staticmethod
    def _outcome(answer):
        if "exit" in answer:
            raise Exit(answer["exit"])
        if "error" in answer or "stopped" in answer:
            place = f"{answer['source']}:{answer['line']}: " if answer.get("line") else ""
            raise Error(place + answer.get("error", answer.get("stopped")), answer.get("line", 0))
        return answer["value"]

    def _stop(self, seconds):
        # A time-out leaves what was read of a line in no known state: the reader begins anew with the connection's rest.
        self._socket.settimeout(10)
        self._lines = self._socket.makefile("rb")
        number = self._id
        self._id += 1
        self._send({"id": self._id, "stop": True})
        try:
            self._outcome(self._await(number))
        except Error as stopped:
            reason = f"it has not ended within {seconds} s" if seconds else str(stopped)
            raise Error(reason, stopped.line) from None
        raise Error(f"it ended only after {seconds} s")


def _literal(value):
    """A value as a script writes it; JSON has no word for numbers that are none."""
    if isinstance(value, float) and not math.isfinite(value):
        return "NaN" if math.isnan(value) else f"{'-' if value < 0 else ''}Infinity"
    return json.dumps(value)
