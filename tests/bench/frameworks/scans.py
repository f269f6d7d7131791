"""A scan of 361 ranges as each framework says it."""
import struct

BEAMS = 361
RANGES = [1 + number % 80 / 10 for number in range(BEAMS)]
START, FIELD, STEP, FAR = -1.5707963, 3.1415927, 0.0087266, 8.0


def text(value):
    return struct.pack("<i", len(value)) + value.encode()


def ros(stamp=1.0):
    """sensor_msgs/LaserScan."""
    return (struct.pack("<3I", 1, int(stamp), 0) + text("base_laser") + struct.pack("<7f", START, START + FIELD, STEP, 0, 0.05, 0.05, FAR)
            + struct.pack(f"<I{BEAMS}f", BEAMS, *RANGES) + struct.pack("<I", 0))


def carmen(ranges=RANGES, stamp=1.0, pose=(0.0, 0.0, 0.0)):
    """carmen_robot_frontlaser, the laser being in the middle of the robot."""
    count = len(ranges)
    return (struct.pack("<i", 1) + struct.pack("<i5di", 3, START, FIELD, FIELD / count, FAR, 0.01, 0) + struct.pack(f"<2i{count}f", count, count, *ranges)
            + struct.pack("<i", count) + bytes(count) + struct.pack("<2i", 0, 0) + struct.pack("<11d", *pose, *pose, 0, 0, 0.3, 0.3, 1e6)
            + struct.pack("<d", stamp) + text("robot"))


def yarp():
    """What rangefinder2D_nws_yarp says: a list of four numbers, the ranges and a status."""
    numbers = b"".join(struct.pack("<id", 10, value) for value in (-90, 90, 0.05, FAR))
    return struct.pack("<2i", 256, 6) + numbers + struct.pack(f"<2i{BEAMS}d", 266, BEAMS, *RANGES) + struct.pack("<2i", 1, 1)


def smartsoft():
    """CommBasicObjects::CommLaserScan."""
    cdr = Cdr()
    cdr.put("?", True).put("I", 1, 2).put("Q", 3).put("d", START * 18000 / 3.1415927 % 36000, 50.0).put("H", 50, 8000, 1).put("I", BEAMS)
    for number, value in enumerate(RANGES):
        cdr.put("H", number, round(value * 1000)).put("B", 0)
    return bytes(cdr.put("H", BEAMS).data)


class Cdr:
    """Little endian, each number at a multiple of its size."""

    def __init__(self):
        self.data = bytearray()

    def put(self, kind, *values):
        for value in values:
            self.data += bytes(-len(self.data) % struct.calcsize(kind)) + struct.pack(f"<{kind}", value)
        return self
