"""When something was so in a recording: on the command line, and in a window, where it is marked on the timeline."""
import contextlib
import json
import subprocess

import pytest

from conftest import ROOT, Robot, wait_for
from desktop import DARK, NAVIGATOR, Keys, Window, missing, output
from playback import CLOSE, RECORDING, Bar

MILLISECOND = 1_000_000


def log(*arguments):
    done = subprocess.run([ROOT / "robotui", "log", *arguments], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def scans(folder):
    """The topic of scans, and the times of its messages."""
    info = json.loads(log("info", "--json", RECORDING))
    topic = next(channel["topic"] for channel in info["channels"] if channel["type"] == "sensor_msgs/LaserScan")
    log("export", RECORDING, "--out", folder, "--format", "jsonl", "--topics", topic)
    lines = next(folder.iterdir()).read_text(encoding="utf-8").splitlines()
    return topic.lstrip("/"), [json.loads(line)["time"] for line in lines], int(info["end"])


@pytest.fixture(autouse=True)
def there():
    if not RECORDING.exists():
        pytest.skip("the shared recordings are not here")


def test_gaps_are_found_where_messages_are_missing(tmp_path):
    topic, times, end = scans(tmp_path / "out")
    gaps = sorted(later - earlier for earlier, later in zip(times, times[1:]))
    limit = gaps[-6] + 2 * MILLISECOND                  # the longest few of them
    expected = [(earlier + limit, later) for earlier, later in zip(times, [*times[1:], end]) if later - earlier > limit]

    found = [json.loads(line) for line in log("find", "--json", RECORDING, "--where", f"age({topic}) > {limit / 1e9:.9f}").splitlines()]

    assert [int(event["end"]) for event in found] == [later for _, later in expected]
    assert all(abs(int(event["start"]) - begin) <= 2 * MILLISECOND for event, (begin, _) in zip(found, expected))


def test_what_is_found_is_marked_on_the_timeline_and_leads_there(processes, environment, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    topic, times, _ = scans(tmp_path / "out")
    limit = sorted(later - earlier for earlier, later in zip(times, times[1:]))[-2] / 1e9 + 0.002
    window = Window.open(Robot(processes, "http://127.0.0.1:1", environment), RECORDING)
    bar = Bar(window)
    Keys.press("ctrl+alt+p")
    Keys.press("ctrl+alt+f")
    form = wait_for(find_window, what="the window that searches")
    output("xdotool", "windowactivate", "--sync", form, "type", f"age({topic}) > {limit:.6f}")
    output("xdotool", "key", "Return")
    left = wait_for(lambda: marks(window, bar), what="the marks on the timeline")

    def leads_there():
        """The list may come later than the marks: then a user presses again."""
        output("xdotool", "mousemove", "--window", form, "120", "101", "click", "1")
        with contextlib.suppress(AssertionError):
            return wait_for(lambda: abs((bar.position() or 0) - left) < 4 * CLOSE, seconds=10)
        return False
    wait_for(leads_there, what="the timeline to go to the first event")


def find_window():
    return next(iter(subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Find in Recordings"], capture_output=True, text=True, timeout=60,
                                    check=False).stdout.split()), None)


def marks(window, bar):
    """The leftmost column of what was found."""
    columns, _ = window.picture().places(DARK["warning"], NAVIGATOR, bar.top + 15, None, bar.top + 21)
    return int(columns.min()) if len(columns) else None
