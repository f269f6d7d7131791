"""Our scene, alone in its window."""
import json
import pathlib

from building import variable

TITLE = "RobotUI"
NAME = "Bench"                                                      # of the robot, and so of its frames


def write(scene, thinning, file):
    camera = scene.camera
    # One tree of frames for all robots, from one of the interfaces: they share a master, and so /tf.
    names = [robot.name or "base" for robot in scene.robots] or ["base"]
    rfics = {name: {"type": "ros", "namespace": "/" if name == "base" else f"/{name}", "tf": name == names[0]} for name in names}
    file.write_text(json.dumps({"ruics": {NAME: {
        "type": "single",
        "view": "scene3d",
        "rfics": rfics,
        "uics": {"scene3d": {
            "displays": list(scene.ours), "fixed_frame": f"{NAME}/map", "tree": False, "thinning": thinning,
            "views": {"start": {"kind": "orbit", "x": 0, "y": 0, "z": camera.height, "distance": camera.distance, "yaw": camera.yaw,
                                "pitch": camera.pitch}},
        }},
    }}}, indent=1))
    return file


def command(scene, thinning, folder):
    file = write(scene, thinning, folder / f"{scene.name.replace(' ', '-')}{'-thinned' if thinning else ''}.yaml")
    return [pathlib.Path(variable("ROBOTUI_WINDOW_PRODUCT", "scene"), "robotui"), "-config", file]
