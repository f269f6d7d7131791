"""What ./robotui log play sends, as the stock recorders of ROS 1 and LCM have it: every message, byte for byte."""
import collections
import json
import pathlib
import shutil
import signal
import subprocess
import time

import pytest

from conftest import ROOT, SHARED, busy, end, free_port, tell, wait_for

PEERS = pathlib.Path(__file__).parent / "peers"
# Reads bags by the stock library, which this Python need not have.
MESSAGES = """
import collections, hashlib, rosbag, sys
found = collections.Counter((topic, raw[0], raw[2], hashlib.md5(bytes(raw[1])).hexdigest())
                            for topic, raw, _ in rosbag.Bag(sys.argv[1]).read_messages(raw=True) if not topic.startswith("/rosout"))
print("\\n".join(f"{count} {' '.join(key)}" for key, count in sorted(found.items())))
"""
# Three senders of one topic: each of the first two has said what holds, the third one has not.
SENDERS = """
import rosbag, rospy, std_msgs.msg, sys
with rosbag.Bag(sys.argv[1], "w") as bag:
    for at, (sender, latching, text) in enumerate([("/one", "1", "a"), ("/two", "1", "b"), ("/three", "0", "c"), ("/two", "1", "d")]):
        header = {"callerid": sender, "latching": latching, "topic": "/said", "type": "std_msgs/String",
                  "md5sum": std_msgs.msg.String._md5sum, "message_definition": std_msgs.msg.String._full_text}
        bag._topic_connections.pop("/said", None)     # which would be the only one of the topic, as this library writes it
        bag.write("/said", std_msgs.msg.String(text), rospy.Time(100 + at / 10), connection_header=header)
    bag.write("/end", std_msgs.msg.String("e"), rospy.Time(400))
"""
# Subscribes until the last one came, and then anew: what it is told then was kept for it.
LATE = """
import rospy, std_msgs.msg
rospy.init_node("late")
for wanted in "d", "d":
    texts = []
    subscriber = rospy.Subscriber("/said", std_msgs.msg.String, lambda message: texts.append(message.data))
    while wanted not in texts:
        rospy.sleep(0.05)
    rospy.sleep(0.5)                            # for what would come behind
    subscriber.unregister()
print(" ".join(texts), flush=True)
"""


def recording(name):
    file = SHARED / "data" / name
    if not file.exists():
        pytest.skip("the shared recordings are not here")
    return file


def play(environment, *arguments, code=0):
    done = subprocess.run([ROOT / "robotui", "log", "play", *map(str, arguments)], env=environment, capture_output=True, text=True, timeout=180)
    assert done.returncode == code, done.stdout + done.stderr
    return done.stdout + done.stderr


def messages(bag):
    lines = subprocess.run(["/usr/bin/python3", "-c", MESSAGES, bag], capture_output=True, text=True, check=True, timeout=60).stdout.splitlines()
    return collections.Counter({line.split(" ", 1)[1]: int(line.split(" ", 1)[0]) for line in lines})


def test_the_stock_recorder_of_ros_gets_what_was_recorded(roscore, tmp_path):
    original, bag = recording("bags/turtlesim.bag"), tmp_path / "again.bag"
    recorder = roscore.start_tool("rosbag", "record", "-a", "-O", str(bag), "__name:=recorder", name="record")
    wait_for(lambda: "/recorder" in roscore.nodes(), what="the recorder")
    # The recorder keeps a hundred messages of a topic where the machine gives it no time: those of most of a second.
    said = play(roscore.environment, original, "--clock", "--rate", "2", "--wait-for-subscribers")
    assert "8647 messages were sent" in said
    assert not [node for node in roscore.nodes() if node.startswith("/robotui_play")], "it has left"
    tell(recorder, signal.SIGINT)               # its program in Python ends before the one that writes, which must not be killed then
    wait_for(bag.exists, what="the bag")
    end(recorder)

    there, again = messages(original), messages(bag)
    clock = collections.Counter({key: count for key, count in again.items() if key.startswith("/clock ")})
    assert again - clock == there
    assert clock.total() > 100


@pytest.mark.parametrize("player", [[ROOT / "robotui", "log", "play"], ["rosbag", "play"]], ids=["robotui", "stock"])
def test_who_comes_late_gets_the_last_message_of_each_sender_that_latches(roscore, tmp_path, player):
    bag = tmp_path / "senders.bag"
    subprocess.run(["/usr/bin/python3", "-c", SENDERS, bag], check=True, timeout=60)
    late = roscore.start_tool("/usr/bin/python3", "-c", LATE, name="late")
    wait_for(lambda: "/late" in roscore.nodes(), what="the subscriber")
    playing = roscore.start_tool(*map(str, player), str(bag), name="player")
    wait_for(lambda: late.poll() is not None, 60, "what was kept")
    end(playing)
    assert sorted(late.out.read_text().split()) == ["a", "d"]


def test_a_bag_that_became_mcap_becomes_the_same_bag_for_the_stock_library(environment, tmp_path):
    original, mcap = recording("bags/turtlesim.bag"), tmp_path / "run.mcap"
    convert(environment, original, mcap)
    for compression in "none", "lz4":
        bag = tmp_path / f"{compression}.bag"
        convert(environment, mcap, bag, "--compression", compression)
        assert messages(bag) == messages(original)


def convert(environment, *arguments):
    done = subprocess.run([ROOT / "robotui", "log", "convert", *map(str, arguments)], env=environment, capture_output=True, text=True, timeout=180)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_master_that_is_not_there_is_named(environment):
    uri = f"http://127.0.0.1:{free_port()}"
    said = play(environment | {"ROS_MASTER_URI": uri}, recording("bags/marker_cube.bag"), code=2)
    assert said.startswith(f"robotui: no master of ROS answers at {uri}")


@pytest.mark.skipif(shutil.which("lcm-logger") is None, reason="lcm-logger is not installed (liblcm-bin)")
def test_the_stock_logger_of_lcm_gets_what_was_recorded(processes, environment, tmp_path):
    original, log = recording("lcm/tiago_joint_states.lcmlog"), tmp_path / "again.lcmlog"
    url = f"udpm://239.255.77.9:{free_port()}?ttl=0"
    logger = processes.start(["lcm-logger", f"--lcm-url={url}&recv_buf_size={4 << 20}", str(log)], "logger", environment)
    wait_for(log.exists, what="the logger")
    play(environment | {"LCM_DEFAULT_URL": url}, original, "--rate", "10", "--delay", f"{2 * busy():.0f}")
    time.sleep(busy())                          # for those that came last: it writes them when it ends
    end(logger)
    sent, logged = events(original.read_bytes()), events(log.read_bytes())
    # Nothing asks again for what is lost of multicast where the machine gives the logger no time.
    rest = iter(sent)
    assert all(event in rest for event in logged), "what came is what was recorded, in its order"
    assert len(logged) > len(sent) / 2


def test_an_independent_client_of_player_hears_what_a_log_has(processes, environment):
    log = SHARED / "captures" / "player" / "stage.log"
    if not log.exists():
        pytest.skip("the shared captures are not here")
    port = free_port()
    playing = processes.start([ROOT / "robotui", "log", "play", str(log), "--wait-for-subscribers", "--rate", "4"], "play",
                              environment | {"PLAYER_PORT": str(port)})
    wait_for(lambda: f"Player server at 127.0.0.1:{port} with laser:0, position2d:0" in playing.out.read_text(), 60, "the server")
    client = processes.start(["/usr/bin/python3", str(PEERS / "player_client.py"), "127.0.0.1", str(port)], "client", environment)
    wait_for(lambda: client.poll() is not None, 60, "the end of the server")
    heard = [json.loads(line) for line in client.out.read_text().splitlines()]
    lines = [line.split() for line in log.read_text().splitlines() if not line.startswith("#")]
    said = [line for line in lines if line[5] == "001"]         # data, not answers
    assert [(each["topic"], each["stamp"]) for each in heard] == [({"position2d": "odom", "laser": "scan"}[line[3]], float(line[0])) for line in said]
    assert [each["x"] for each in heard if each["topic"] == "odom"] == [float(line[7]) for line in said if line[3] == "position2d"]


def events(data):
    """Channels and bytes, without the times at which they were logged."""
    found, at = [], 0
    while at < len(data):
        channel = int.from_bytes(data[at + 20:at + 24], "big")
        length = int.from_bytes(data[at + 24:at + 28], "big")
        found.append((data[at + 28:at + 28 + channel], data[at + 28 + channel:at + 28 + channel + length]))
        at += 28 + channel + length
    return found
