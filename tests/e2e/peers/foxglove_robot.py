#!/usr/bin/env python3
"""A robot behind Foxglove's own server (foxglove-sdk): what it senses in Protocol Buffers and JSON, ten times a second,
until it is ended. It drives as it is told by JSON on cmd_vel, and prints what clients do. The argument is the port."""
import json
import math
import struct
import sys
import threading
import time

import foxglove
from foxglove import Channel, channels, messages
from foxglove.websocket import Capability, ConnectionGraph, Parameter, ServerListener, Service, ServiceSchema, StatusLevel


class Robot(ServerListener):
    def __init__(self):
        self.topics = {}
        self.speed = 0.0
        self.x = 0.0
        self.limit = 0.5
        self.told = threading.Event()

    def on_subscribe(self, client, channel):
        say("subscribe", channel.topic)

    def on_unsubscribe(self, client, channel):
        say("unsubscribe", channel.topic)

    def on_client_advertise(self, client, channel):
        self.topics[client.id, channel.id] = channel.topic
        say("advertise", channel.topic, channel.encoding, channel.schema_name)

    def on_client_unadvertise(self, client, client_channel_id):
        say("unadvertise", self.topics.pop((client.id, client_channel_id), "?"))

    def on_message_data(self, client, client_channel_id, data):
        if self.topics.get((client.id, client_channel_id)) == "/cmd_vel":
            self.speed = json.loads(data)["linear"]["x"]
            say("drive", self.speed)

    def on_get_parameters(self, client, param_names, request_id=None):
        return [Parameter("limit", value=self.limit), Parameter("name", value="foxy")]

    def on_set_parameters(self, client, parameters, request_id=None):
        for each in parameters:
            if each.name == "limit":
                self.limit = each.get_value()
                say("limit", self.limit)
        return self.on_get_parameters(client, [])


def say(*words):
    print(*words, flush=True)


def echo(request):
    return request.payload


def graph():
    known = ConnectionGraph()
    known.set_published_topic("/odom", ["/base"])
    known.set_subscribed_topic("/cmd_vel", ["/base"])
    return known


def main():
    robot = Robot()
    services = [Service("/echo", schema=ServiceSchema(name="Echo"), handler=echo)]
    capabilities = [Capability.ClientPublish, Capability.Parameters, Capability.Services, Capability.ConnectionGraph]
    server = foxglove.start_server(name="foxy", port=int(sys.argv[1]), server_listener=robot, capabilities=capabilities,
                                   supported_encodings=["json"], services=services)
    scan = channels.LaserScanChannel("/scan")
    odom = channels.OdometryChannel("/odom")
    frames = channels.FrameTransformsChannel("/transforms")
    cloud = channels.PointCloudChannel("/points")
    log = channels.LogChannel("/log")
    pose = Channel("/pose", schema={"type": "object", "title": "foxglove.PoseInFrame"})
    battery = Channel("/battery", schema={"type": "object", "title": "Battery", "properties": {"percent": {"type": "number"}}})
    odd = Channel("/odd", message_encoding="msgpack", schema=foxglove.Schema(name="Odd", encoding="", data=b""))
    server.publish_connection_graph(graph())
    say("ready")
    for i in range(10 ** 9):
        now = messages.Timestamp.now()
        robot.x += robot.speed * 0.1
        where, straight = messages.Vector3(x=robot.x, y=0.0, z=0.0), messages.Quaternion(x=0.0, y=0.0, z=0.0, w=1.0)
        place = messages.Pose(position=where, orientation=straight)
        odom.log(messages.Odometry(timestamp=now, frame_id="odom", body_frame_id="base_link", pose=place,
                                   linear_velocity=messages.Vector3(x=robot.speed), angular_velocity=messages.Vector3()))
        scan.log(messages.LaserScan(timestamp=now, frame_id="base_link", start_angle=-1.5, end_angle=1.5, ranges=[2.0] * 31))
        frames.log(messages.FrameTransforms(transforms=[messages.FrameTransform(
            timestamp=now, parent_frame_id="odom", child_frame_id="base_link", translation=where, rotation=straight)]))
        if i % 10 == 0:
            points = b"".join(struct.pack("<3f", math.cos(a), math.sin(a), 0.5) for a in (0.0, 1.0, 2.0))
            three = [messages.PackedElementField(name=n, offset=4 * k, type=messages.PackedElementFieldNumericType.Float32) for k, n in enumerate("xyz")]
            cloud.log(messages.PointCloud(timestamp=now, frame_id="base_link", point_stride=12, fields=three, data=points))
            log.log(messages.Log(timestamp=now, level=messages.LogLevel.Warning, message=f"beat {i}", name="base"))
            server.publish_status(f"all is well {i}", StatusLevel.Info)
        battery.log({"percent": 80.5})
        pose.log({"timestamp": {"sec": int(time.time()), "nsec": 0}, "frame_id": "map",
                  "pose": {"position": {"x": 1, "y": 2, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}})
        odd.log(b"\x80")
        time.sleep(0.1)


if __name__ == "__main__":
    main()
