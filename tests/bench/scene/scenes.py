"""The scenes that are measured: what is sent, and how either program shows it."""
import functools
import os
import pathlib
import xml.etree.ElementTree as xml
from dataclasses import dataclass

from building import CannotMeasure, variable

STATE_PUBLISHER = "/usr/lib/robot_state_publisher/robot_state_publisher"
POINT_PIXELS = 3                                                    # as rviz has it by itself
ROBOTS = 10


@dataclass(frozen=True)
class Camera:
    """Round a place above the middle: metres, radians."""
    distance: float
    height: float = 0.0
    pitch: float = 0.6
    yaw: float = 0.3                                                # where it looks


@dataclass(frozen=True)
class Robot:
    """A robot of its own name space; the name is empty for one without."""
    name: str
    description: str
    joints: tuple


@dataclass(frozen=True)
class Scene:
    name: str
    feeds: tuple                                                    # variants: what is measured, and the line for the publisher
    camera: Camera
    ours: tuple = ()                                                # displays
    theirs: tuple = ()
    robots: tuple = ()
    rim: bool = False                                               # whether what came last is a white rim
    thinned: bool = False                                           # whether to measure it thinned, too


def cloud(name, points):
    feeds = ((f"{name} points, static", f"cloud {points} 0"), (f"{name} points at 10 Hz", f"cloud {points} 10"))
    ours = {"type": "pointcloud", "source": "base/cloud", "settings": {"color_by": "rgb", "size": POINT_PIXELS, "unit": "pixels"}}
    theirs = {"Class": "rviz/PointCloud2", "Topic": "/cloud", "Style": "Points", "Size (Pixels)": POINT_PIXELS, "Color Transformer": "RGB8",
              "Position Transformer": "XYZ"}
    return Scene(f"{name} points", feeds, Camera(24), (ours,), (theirs,), rim=True, thinned=points >= 5_000_000)


def markers(count):
    ours = {"type": "markers", "source": "base/markers"}
    theirs = {"Class": "rviz/MarkerArray", "Marker Topic": "/markers"}
    return Scene("markers", ((f"{count // 1000} k markers", f"markers {count} 1"),), Camera(20), (ours,), (theirs,))


def humanoid():
    robot = described("coman_urdf/urdf/coman.urdf", "")
    theirs = {"Class": "rviz/RobotModel", "Robot Description": "robot_description"}
    return Scene("humanoid", (("humanoid at 100 Hz", joints(100, [robot])),), Camera(2.2, 0.0, 0.2), (model("base"),), (theirs,), (robot,))


def team():
    robots = tuple(described("husky_description/urdf/husky.urdf", f"r{i}", (i % 5 - 2) * 1.5, (i // 5 - 0.5) * 2) for i in range(ROBOTS))
    theirs = tuple({"Class": "rviz/RobotModel", "Robot Description": f"/{each.name}/robot_description"} for each in robots)
    return Scene("robots", ((f"{ROBOTS} robots", joints(50, robots)),), Camera(9), tuple(model(each.name) for each in robots), theirs, robots)


def model(interface):
    return {"type": "robotmodel", "source": f"{interface}/robot_description", "settings": {"packages": [str(models())]}}


def joints(rate, robots):
    topics = " ".join(f"{'/' + each.name if each.name else ''}/joint_states" for each in robots)
    return f"joints {rate} {topics} = {' '.join(robots[0].joints)}"


def models():
    """The folder of the recordings that has robots; they are used where they lie."""
    shared = os.environ.get("ROBOTUI_SHARED") or pathlib.Path(variable("ROBOTUI_ROOT", "scene"), "..", "shared")
    folder = pathlib.Path(shared, "data", "robots").resolve()
    if not folder.is_dir():
        raise CannotMeasure(f"there are no robots in {folder}; ROBOTUI_SHARED is the folder of recordings")
    return folder


def described(file, name, x=0.0, y=0.0):
    """A model whose links have names of their own, below the frame map, with meshes that both programs find without a package path."""
    robot = xml.parse(models() / file).getroot()
    prefix = f"{name}_" if name else ""
    links = {link.get("name") for link in robot.findall("link")}
    joints_ = robot.findall("joint")
    (root,) = links - {joint.find("child").get("link") for joint in joints_}
    for link in robot.findall("link"):
        link.set("name", prefix + link.get("name"))
    for joint in joints_:
        if joint.get("type") == "floating":                         # nobody says where such a robot floats
            joint.set("type", "fixed")
        for end in ("parent", "child"):
            joint.find(end).set("link", prefix + joint.find(end).get("link"))
    for mesh in robot.iter("mesh"):
        mesh.set("filename", mesh.get("filename").replace("package://", f"file://{models()}/"))
    stand = xml.SubElement(robot, "joint", name="stand", type="fixed")
    xml.SubElement(robot, "link", name="map")
    xml.SubElement(stand, "parent", link="map")
    xml.SubElement(stand, "child", link=prefix + root)
    xml.SubElement(stand, "origin", xyz=f"{x} {y} 0", rpy="0 0 0")
    moving = tuple(joint.get("name") for joint in joints_ if joint.get("type") in ("revolute", "continuous", "prismatic"))
    return Robot(name, xml.tostring(robot, encoding="unicode"), moving)


CLOUDS = {"100 k": 100_000, "1 M": 1_000_000, "5 M": 5_000_000}
KINDS = {
    "clouds": [functools.partial(cloud, name, points) for name, points in CLOUDS.items()],
    "humanoid": [humanoid],
    "markers": [functools.partial(markers, 10_000)],
    "robots": [team],
}
