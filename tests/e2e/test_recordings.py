"""Recordings that ./robotui log converts and repairs have, for the stock readers of MCAP and of bags, the messages of the original."""
import csv
import json
import os
import pathlib
import subprocess

import pytest

from conftest import ROOT, SHARED

PYTHON = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "none")) / "recordings/bin/python"
READER = ROOT / "tests/e2e/peers/recording_reader.py"
MAKER = ROOT / "tests/e2e/peers/rosbag2_maker.py"

pytestmark = pytest.mark.skipif(not PYTHON.exists(), reason="there are no readers of recordings from PyPI (ROBOTUI_ROS2_PEERS)")

# A recording, and how it is compressed anew. The LZ4 of lidar_clouds.mcap has blocks that follow from each other.
FILES = {"bags/turtlesim_bz2.bag": "lz4", "bags/tiago_joint_states.bag": "zstd", "mcap/lidar_clouds.mcap": "none", "mcap/topics_and_services.mcap": "zstd"}


@pytest.mark.parametrize("name", FILES)
def test_a_copy_has_the_messages_of_the_original(name, tmp_path):
    original, copy = recording(name), tmp_path / "copy.mcap"
    log("convert", original, copy, "--compression", FILES[name])

    assert messages(copy) == messages(original)


def test_a_file_that_was_cut_off_becomes_whole(tmp_path):
    original, cut, repaired = recording("mcap/tiago_joint_states.mcap"), tmp_path / "cut.mcap", tmp_path / "repaired.mcap"
    whole = original.read_bytes()
    cut.write_bytes(whole[:len(whole) * 2 // 3])

    assert log("check", cut, code=1).splitlines()[1].startswith("byte ")
    log("repair", cut, repaired)
    log("check", repaired)
    kept, all_of_them = messages(repaired), messages(original)
    assert len(kept) > len(all_of_them) / 2
    assert set(kept) < set(all_of_them)


def test_the_parts_of_a_recording_are_the_recording_again(tmp_path):
    original, first, second, both = recording("bags/sena_loop.bag"), tmp_path / "first.mcap", tmp_path / "second.mcap", tmp_path / "both.mcap"
    log("cut", original, first, "--topics", "/*scan*")
    log("cut", original, second, "--topics", "/tf*,/map,/odom")
    log("merge", first, second, both)

    assert messages(first) and messages(second)
    assert sorted(messages(both)) == sorted(messages(original))


@pytest.mark.parametrize("storage, compression", [("sqlite3", "none"), ("sqlite3", "message"), ("sqlite3", "file"), ("mcap", "message"), ("mcap", "file")])
def test_recordings_of_rosbag2_have_the_messages_that_were_written(storage, compression, tmp_path):
    folder, copy = tmp_path / "run", tmp_path / "copy.mcap"
    make(folder, storage, compression)
    log("convert", folder, copy)

    written = messages(folder)
    assert len(written) == 72
    assert messages(copy) == written


def test_what_a_killed_recorder_left_is_read(tmp_path):
    make(tmp_path / "run.db3", "killed")
    assert len(messages(converted(tmp_path / "run.db3", tmp_path / "copy.mcap"))) == 60


def test_a_log_of_lcm_becomes_mcap_with_its_types(tmp_path):
    original = recording("lcm/sena_loop.lcmlog")
    copy = converted(original, tmp_path / "copy.mcap", "--types", original.parent / "types")
    assert {tuple(line.split()[1:3]) for line in messages(copy)} == {
        ("LASER_FRONT", "robotdata.laser_scan_t"), ("ODOMETRY", "robotdata.odometry_t"), ("MAP", "robotdata.occupancy_grid_t")}
    log("export", copy, "--out", tmp_path / "out", "--topics", "ODOMETRY")
    rows = table(tmp_path / "out/ODOMETRY.csv")
    assert len(rows) == 224
    assert [float(rows[-1][f"xy_theta[{axis}]"]) for axis in range(3)] == pytest.approx([-4.802438, -21.163699, -1.862337], abs=1e-5)


def test_what_is_exported_are_the_values_that_stock_readers_have(tmp_path):
    original = recording("bags/tiago_joint_states.bag")
    log("export", original, "--out", tmp_path / "csv", "--to", "1")
    log("export", original, "--out", tmp_path / "lines", "--to", "1", "--format", "jsonl")
    rows = table(tmp_path / "csv/joint_states.csv")
    lines = [json.loads(line) for line in (tmp_path / "lines/joint_states.jsonl").read_text().splitlines()]
    expected = values(original, "/joint_states", len(rows))
    assert len(rows) == len(lines) == len(expected) > 90
    for row, line, (time, names, positions, efforts) in zip(rows, lines, expected):
        assert row["time [s]"].replace(".", "") == str(time) == str(line["time"])
        assert [row[f"name[{joint}]"] for joint in range(8)] == names == line["message"]["name"]
        assert [float(row[f"position[{joint}]"]) for joint in range(8)] == positions == line["message"]["position"]
        assert [float(row[f"effort[{joint}]"]) for joint in range(8)] == efforts == line["message"]["effort"]


def make(*arguments):
    subprocess.run([PYTHON, MAKER, *map(str, arguments)], check=True, timeout=60)


def converted(original, copy, *options):
    log("convert", original, copy, *options)
    return copy


def table(file):
    with open(file, newline="") as stream:
        return list(csv.DictReader(stream))


def values(file, topic, count):
    answer = subprocess.run([PYTHON, READER, "--values", topic, str(count), file], capture_output=True, text=True, timeout=60)
    assert answer.returncode == 0, answer.stderr
    return [json.loads(line) for line in answer.stdout.splitlines()]


def recording(name):
    file = SHARED / "data" / name
    if not file.exists():
        pytest.skip("the shared recordings are not here")
    return file


def log(*arguments, code=0):
    answer = subprocess.run([ROOT / "robotui", "log", *map(str, arguments)], capture_output=True, text=True, timeout=60)
    assert answer.returncode == code, answer.stdout + answer.stderr
    return answer.stdout


def messages(file):
    answer = subprocess.run([PYTHON, READER, file], capture_output=True, text=True, timeout=60)
    assert answer.returncode == 0, answer.stderr
    return answer.stdout.splitlines()[1:]
