#!/usr/bin/env python3
"""A program of LCM by its own library, liblcm, and types that lcm-gen made: lcm_stock.py URL FOLDER. It says demo.drive_t on DRIVE ten times a second, and
prints what demo.pose_t on POSE says, as lines of JSON."""
import ctypes
import json
import sys
import time

sys.path.insert(0, sys.argv[2])

from demo import drive_t, pose_t  # noqa: E402


class Received(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("size", ctypes.c_uint32), ("utime", ctypes.c_int64), ("lcm", ctypes.c_void_p)]


HANDLER = ctypes.CFUNCTYPE(None, ctypes.POINTER(Received), ctypes.c_char_p, ctypes.c_void_p)


@HANDLER
def take(received, _channel, _user):
    pose = pose_t.decode(ctypes.string_at(received.contents.data, received.contents.size))
    print(json.dumps({"utime": pose.utime, "x_mm": pose.x_mm, "frame": pose.frame}), flush=True)


def main():
    library = ctypes.CDLL("liblcm.so.1")
    library.lcm_create.restype = ctypes.c_void_p
    library.lcm_create.argtypes = [ctypes.c_char_p]
    library.lcm_subscribe.argtypes = [ctypes.c_void_p, ctypes.c_char_p, HANDLER, ctypes.c_void_p]
    library.lcm_subscribe.restype = ctypes.c_void_p
    library.lcm_publish.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_uint]
    library.lcm_handle_timeout.argtypes = [ctypes.c_void_p, ctypes.c_int]
    bus = library.lcm_create(sys.argv[1].encode())
    library.lcm_subscribe(bus, b"POSE", take, None)
    command, said = drive_t(), 0.0
    command.forward_mm_s, command.turn_deg_s = 200.0, 0.0
    while True:
        library.lcm_handle_timeout(bus, 50)
        if time.monotonic() - said > 0.1:
            said = time.monotonic()
            command.utime = int(time.time() * 1e6)
            data = command.encode()
            library.lcm_publish(bus, b"DRIVE", data, len(data))


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
