"""rviz with a scene: no panels, as fast as it can."""
import json
import math

TITLE = "RViz"
BACKGROUND = "38; 41; 46"


def write(scene, file):
    camera = scene.camera
    file.write_text(json.dumps({
        "Panels": [],
        "Visualization Manager": {
            "Class": "",
            "Displays": [{"Name": f"Display {i}", "Enabled": True, "Value": True, **each} for i, each in enumerate(scene.theirs)],
            "Enabled": True,
            "Global Options": {"Background Color": BACKGROUND, "Fixed Frame": "map", "Frame Rate": 1000},
            "Name": "root",
            "Tools": [{"Class": "rviz/MoveCamera"}],
            "Views": {"Current": {
                "Class": "rviz/Orbit", "Distance": camera.distance, "Focal Point": {"X": 0, "Y": 0, "Z": camera.height}, "Focal Shape Size": 0.01,
                "Name": "Current View", "Pitch": camera.pitch, "Yaw": camera.yaw + math.pi, "Target Frame": "map",
                "Field of View": math.radians(45)}},
        },
        "Window Geometry": {"Height": 800, "Width": 1040, "X": 1100, "Y": 20, "Hide Left Dock": True, "Hide Right Dock": True},
    }, indent=1))
    return file


def command(scene, folder):
    file = write(scene, folder / f"{scene.name.replace(' ', '-')}.rviz")
    return ["rviz", "--disable-anti-aliasing", "--display-config", file]
