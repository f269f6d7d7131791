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
    roscore.start_tool("rosbag", "play", "-q", str(file), name="rosbag").wait(60)

    assert robotui.wait(60) == 0
    assert "Exception" not in robotui.err.read_text()


SECONDS = 5


def loop(file):
    """Writes a recording of a robot that drives in a circle: a map that is latched, transforms and scans."""
    rosbag = pytest.importorskip("rosbag")
    import rospy
    from geometry_msgs.msg import TransformStamped
    from nav_msgs.msg import OccupancyGrid
    from sensor_msgs.msg import LaserScan
    from tf2_msgs.msg import TFMessage

    def stamped(kind, moment, frame):
        message = kind()
        message.header.stamp, message.header.frame_id = moment, frame
        return message

    def transform(moment, parent, child, x):
        message = stamped(TransformStamped, moment, parent)
        message.child_frame_id, message.transform.translation.x, message.transform.rotation.w = child, x, 1
        return message

    with rosbag.Bag(str(file), "w") as bag:
        start = rospy.Time(1500000000)
        grid = stamped(OccupancyGrid, start, "map")
        grid.info.resolution, grid.info.width, grid.info.height, grid.info.origin.orientation.w, grid.data = 0.1, 2, 1, 1, [0, 100]
        bag.write("/map", grid, start, connection_header={
            "topic": "/map", "type": grid._type, "md5sum": grid._md5sum, "message_definition": grid._full_text, "latching": "1"})
        for step in range(SECONDS * 20):
            moment = start + rospy.Duration.from_sec(0.05 * step)
            bag.write("/tf", TFMessage([transform(moment, "map", "odom", 0), transform(moment, "odom", "base_link", step * 0.01)]), moment)
            scan = stamped(LaserScan, moment, "base_link")
            scan.angle_min, scan.angle_max, scan.angle_increment, scan.range_max, scan.ranges = -1, 1, 1, 10, [1, 2, 3]
            bag.write("/scan", scan, moment)
    return file


@pytest.mark.parametrize("clock", [False, True])
def test_a_recording_in_a_loop_is_noticed_by_its_stamps_where_no_clock_says_so(clock, roscore, tmp_path):
    file = loop(tmp_path / "loop.bag")
    if clock:
        roscore.tool("rosparam", "set", "use_sim_time", "true")
    robotui = start_robotui(roscore, "run", "--json", "ros")
    wait_for(lambda: json_lines(robotui), seconds=120, what="the first line")
    roscore.start_tool("rosbag", "play", "-q", "-l", "--wait-for-subscribers", *(["--clock"] if clock else []), str(file), name="rosbag")

    wait_for(lambda: times_sent(robotui, "map") > 3, seconds=120, what="three rounds more")
    said = robotui.err.read_text()
    assert said.count("jumped back by") == (0 if clock else 1), said
    assert "Exception" not in said


def times_sent(robotui, port):
    """How often a value came that comes seldom, seen by its age."""
    ages = [line["age_s"] for line in json_lines(robotui) if line["port"].endswith(f".{port}") and line["age_s"] is not None]
    return sum(1 for before, after in zip([float("inf"), *ages], ages) if after < before)
