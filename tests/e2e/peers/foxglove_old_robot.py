#!/usr/bin/env python3
"""A robot behind the server of foxglove-websocket, which speaks the protocol as it was before foxglove-sdk: odometry in the
encoding of ROS 1 with its definition, ten times a second, until it is ended. The argument is the port."""
import asyncio
import struct
import sys
import time

from foxglove_websocket.server import FoxgloveServer, FoxgloveServerListener

DEFINITION = """std_msgs/Header header
string child_frame_id
geometry_msgs/PoseWithCovariance pose
geometry_msgs/TwistWithCovariance twist
""" + "".join("=" * 80 + f"\nMSG: {name}\n{text}" for name, text in {
    "std_msgs/Header": "uint32 seq\ntime stamp\nstring frame_id\n",
    "geometry_msgs/PoseWithCovariance": "Pose pose\nfloat64[36] covariance\n",
    "geometry_msgs/Pose": "Point position\nQuaternion orientation\n",
    "geometry_msgs/Point": "float64 x\nfloat64 y\nfloat64 z\n",
    "geometry_msgs/Quaternion": "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n",
    "geometry_msgs/TwistWithCovariance": "Twist twist\nfloat64[36] covariance\n",
    "geometry_msgs/Twist": "Vector3 linear\nVector3 angular\n",
    "geometry_msgs/Vector3": "float64 x\nfloat64 y\nfloat64 z\n"}.items())


class Listener(FoxgloveServerListener):
    async def on_subscribe(self, server, channel_id):
        print("subscribe", channel_id, flush=True)

    async def on_unsubscribe(self, server, channel_id):
        print("unsubscribe", channel_id, flush=True)


def text(words):
    return struct.pack("<I", len(words)) + words.encode()


def odometry(number):
    now = time.time()
    header = struct.pack("<III", number, int(now), int(now % 1 * 1e9)) + text("odom")
    return header + text("base_link") + struct.pack("<7d", 1, 2, 0, 0, 0, 0, 1) + bytes(8 * 36) + bytes(8 * 6) + bytes(8 * 36)


async def main():
    async with FoxgloveServer("127.0.0.1", int(sys.argv[1]), "old", capabilities=[], supported_encodings=[]) as server:
        server.set_listener(Listener())
        channel = await server.add_channel({"topic": "/odom", "encoding": "ros1", "schemaName": "nav_msgs/Odometry",
                                            "schema": DEFINITION, "schemaEncoding": "ros1msg"})
        print("ready", flush=True)
        for number in range(10 ** 9):
            await server.send_message(channel, time.time_ns(), odometry(number))
            await asyncio.sleep(0.1)


if __name__ == "__main__":
    asyncio.run(main())
