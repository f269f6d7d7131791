"""Recordings that ./robotui log converts and repairs have, for the stock readers of MCAP and of bags, the messages of the original."""
import os
import pathlib
import subprocess

import pytest

from conftest import ROOT, SHARED

PYTHON = pathlib.Path(os.environ.get("ROBOTUI_ROS2_PEERS", "none")) / "recordings/bin/python"
READER = ROOT / "tests/e2e/peers/recording_reader.py"

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
