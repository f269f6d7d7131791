"""Recordings of real robots, played by the real rosbag through a real roscore, arrive without an error."""
import pytest

from conftest import SHARED, end, json_lines, last_of, start_robotui, wait_for

# Recording, how fast it is played, and what of it must arrive with its data type.
BAGS = {
    "sena_loop": (4, {"scan": "LaserScan", "odom": "Odometry", "map": "GridMap", "tf": "TransformSet"}),
    "husky_imu_gps_odom": (40, {"imu/data": "Imu", "husky_velocity_controller/odom": "Odometry", "fix": "GpsFix"}),
    "stereo_jpeg": (0.5, {"stereo/left/image_raw/compressed": "CompressedImage", "stereo/left/camera_info": "CameraInfo"}),
    "lidar_clouds": (0.25, {"velodyne_points": "PointCloud", "room_scan": "PointCloud"}),
    "tiago_joint_states": (8, {"joint_states": "JointState"}),
    "turtlesim": (2, {"turtle1/pose": "DynamicRecord", "turtle1/color_sensor": "DynamicRecord",
                      "turtle1/cmd_vel": "VelocityCommand", "tf": "TransformSet"}),
    "turtlesim_bz2": (2, {"turtle2/pose": "DynamicRecord"}),
    "turtlesim_lz4": (2, {"turtle2/pose": "DynamicRecord"}),
    "marker_cube": (0.01, {"marker_in_parent_frame": "MarkerSet", "tf": "TransformSet"}),
}


@pytest.mark.parametrize("bag", BAGS)
def test_every_recording_is_shown_without_an_error(bag, roscore):
    file = SHARED / "data/bags" / f"{bag}.bag"
    if not file.exists():
        pytest.skip("the shared recordings are not here")
    rate, expected = BAGS[bag]
    robotui = start_robotui(roscore, "run", "--json", "ros")
    wait_for(lambda: json_lines(robotui), what="the first line")

    player = roscore.start_tool("rosbag", "play", "-q", "--wait-for-subscribers", "-l", "-r", str(rate), str(file),
                                "--topics", *topics(expected), name="rosbag")
    for port, kind in expected.items():
        line = wait_for(lambda: with_value(robotui, port), what=f"a value of {port}")
        assert line["type"] == kind
        assert line["dropped"] == 0, line
        assert line["link"] == "connected", line

    end(player)
    end(robotui)
    assert "Exception" not in robotui.err.read_text()


def topics(expected):
    return [f"/{port}" for port in expected] + (["/tf_static"] if "tf" in expected else [])


def with_value(robotui, port):
    line = last_of(robotui, port)
    return line if line and line["value"] else None


def test_a_recording_without_messages_is_no_error(roscore):
    file = SHARED / "data/bags/no_messages.bag"
    if not file.exists():
        pytest.skip("the shared recordings are not here")
    robotui = start_robotui(roscore, "run", "--json", "--for", "8", "ros")
    roscore.start_tool("rosbag", "play", "-q", str(file), name="rosbag").wait(20)

    assert robotui.wait(60) == 0
    assert "Exception" not in robotui.err.read_text()
