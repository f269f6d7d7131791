"""Recordings that are played as robots by the headless product: moved, played, stepped and looped by a script, two on one timeline."""
import pytest

from conftest import SHARED, Robot, start_robotui

CONFIG = """ruics:
  Bag:
    type: mobilebase
    rfics:
      base: {{type: recording, file: "{data}/bags/sena_loop.bag", play: false}}
  Mcap:
    type: mobilebase
    rfics:
      base: {{type: recording, file: "{data}/mcap/sena_loop.mcap", play: false, offset: 10}}
"""

# The second recording has the messages of the first one, and is ten seconds later on the timeline.
SCRIPT = """
waitForLink(30, "Bag");
waitForLink(30, "Mcap");
waitUntil("base.odom", o => true, 20, "Bag");
const place = ui => { const t = value("base.odom", ui).pose.translation; return t.x.toFixed(4) + " " + t.y.toFixed(4); };
seek(20);
const there = place("Bag");
seek(30);
print("later", place("Mcap") === there, place("Bag") === there);
seek(58.8146);
print("last", place("Bag"));
seek(5);
print("before", age("base.odom", "Bag") < 30);
const map = value("base.map", "Bag");
print("map", map.width, map.height);
playbackSpeed(20);
play();
waitFor(() => position() > 25, 20);
pause();
const stood = position();
sleep(1.5);
const odom = ports("Bag").find(p => p.name === "base.odom");
print("stands", position() === stood, odom.stale, odom.rate > 2);
step(true, "/odom");
print("step", position() > stood, position() - stood < 1);
playbackRange(10, 12);
playbackLoop(true);
playbackSpeed(10);
play();
sleep(1);
print("loop", playback().playing, position() >= 10 && position() <= 12);
playbackLoop(false);
waitFor(() => !playback().playing, 20);
print("end", position());
bookmark("a corner", 11);
print("noted", playback().bookmarks[0].note);
try { seek("tomorrow"); } catch (e) { print(e.message); }
exit(3);
"""


def test_two_recordings_are_moved_and_played_by_a_script(processes, environment, tmp_path):
    if not (SHARED / "data/bags/sena_loop.bag").exists():
        pytest.skip("the shared recordings are not here")
    robot = Robot(processes, "http://127.0.0.1:1", environment)
    config, script = tmp_path / "two.yaml", tmp_path / "play.js"
    config.write_text(CONFIG.format(data=SHARED / "data"))
    script.write_text(SCRIPT)

    process = start_robotui(robot, "run", "--text", str(config), "--script", str(script), name="playback")
    process.wait(180)

    assert process.out.read_text().splitlines() == [
        "later true false", "last -4.8024 -21.1637", "before true", "map 651 717", "stands true false true", "step true true",
        "loop true true", "end 12", "noted a corner",
        "'tomorrow' is no time; write seconds from the start, or such as \"2026-11-27T10:00:00Z\""], process.err.read_text()
    assert process.returncode == 3
