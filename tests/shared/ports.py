"""Ports for programs that tests and benchmarks start."""
import contextlib
import random
import socket


def free_port():
    """A port below those that the system hands out by itself: until a slow peer binds it, nobody gets it by chance."""
    for port in random.sample(range(15000, 32000), 100):
        with socket.socket() as probe, contextlib.suppress(OSError):
            probe.bind(("127.0.0.1", port))
            return port
    raise OSError("no free port between 15000 and 32000")
