"""What the independent clients of frameworks share: bytes of a connection, and lines about what they hear."""
import json
import time

RATE = 20          # of odometry and scans of the simulated robot
SPEED, TURN = 0.1, 0.5
PERIOD = 0.05      # between two commands of a driver


def take(connection, count):
    data = b""
    while len(data) < count:
        more = connection.recv(count - len(data))
        if not more:
            raise SystemExit("the server is gone")
        data += more
    return data


class Teller:
    """Prints a line for each message. These frameworks do not count messages: they are counted by the time that the robot says."""

    def __init__(self):
        self.last = {}

    def tell(self, topic, stamp, **more):
        before, count = self.last.get(topic, (stamp, 0))
        count += round((stamp - before) * RATE)
        self.last[topic] = (stamp, count)
        print(json.dumps({"topic": topic, "at": time.time(), "seq": count, "stamp": stamp} | more), flush=True)


def drive(command):
    """Commands the same speed again and again, and tells when."""
    while True:
        command(SPEED, TURN)
        print(json.dumps({"topic": "command", "at": time.time()}), flush=True)
        time.sleep(PERIOD)


def work(client, arguments):
    """`PEER HOST:PORT hear`, `drive` or `known`: what the server knows, as one line."""
    where, what = arguments
    host, _, port = where.partition(":")
    made = client(host, int(port))
    if what == "known":
        print(json.dumps(sorted(made.known())))
    elif what == "drive":
        drive(made.driver())
    else:
        made.hear(Teller())
