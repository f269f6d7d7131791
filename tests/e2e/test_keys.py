"""A key that is changed in the preferences of a real window, and used at once."""
import pytest
import yaml

from conftest import Robot, free_port, wait_for
from desktop import DARK, Keys, Window, missing, output

CONFIG = """
ruics:
  Natalie:
    rfics: {base: {type: ros}}
    uics: {map: {}, plot: {}, status: {}}
    layout: {row: [{tabs: [map, plot]}, status]}
    perspectives:
      Apart: {column: [map, status]}
      Map: map
"""
KEPT = """# Of our lab.
version: 1
keys:
  'perspective(2)': ['F7']  # near F8
  'reload': ['F12']
"""


@pytest.fixture
def nowhere(processes, environment):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    return Robot(processes, f"http://127.0.0.1:{free_port()}", environment)


def find(name):
    ids = output("sh", "-c", f"xdotool search --onlyvisible --name '{name}' || true").split()
    return ids[0].decode() if ids else None


def test_a_key_is_changed_in_the_window_and_used_at_once(nowhere, tmp_path):
    state = tmp_path / "keys-state" / "robotui"
    state.mkdir(parents=True)
    file = state / "keys.yaml"
    file.write_text(KEPT)
    config = tmp_path / "keys.yaml"
    config.write_text(CONFIG)
    window = Window.open(nowhere, config, name="keys")
    output("xdotool", "windowactivate", "--sync", window.id)
    wait_for(lambda: window.picture().count(DARK["ground"]) > 50_000, seconds=60, what="views")

    def perspective():
        kept = [yaml.safe_load(each.read_text()) for each in (state / "overlays").glob("*.yaml")]
        return kept[0].get("Natalie", {}).get("views", {}).get("perspective") if kept else None

    assert list(state.glob("keys.yaml.damaged-*")), "a key that stops robots was given to a command"
    Keys.press("F7")
    wait_for(lambda: perspective() == "Map", what="a key from the file")

    output("xdotool", "key", "--delay", "0", "ctrl+3", *"keys", "Return")
    dialog = wait_for(lambda: find("^Preferences"), what="the preferences")
    output("xdotool", "windowactivate", "--sync", dialog)
    output("xdotool", "type", "--delay", "20", "perspective 1")
    output("xdotool", "key", "Down", "Return", "F6")
    wait_for(lambda: "F6" in file.read_text(), what="the key in the file")
    assert yaml.safe_load(file.read_text())["keys"]["perspective(1)"] == ["F6"]
    assert "# Of our lab." in file.read_text() and "# near F8" in file.read_text()
    output("xdotool", "windowactivate", "--sync", dialog, "key", "Escape")
    wait_for(lambda: find("^Preferences") is None, what="the end of the preferences")

    output("xdotool", "windowactivate", "--sync", window.id, "key", "F6")
    wait_for(lambda: perspective() == "Apart", what="the key that was recorded")
    Keys.press("F7")
    wait_for(lambda: perspective() == "Map", what="the other key")
    Keys.press("ctrl+alt+1")
    Keys.press("F12")
    wait_for(window.release_button, what="the stop by its key")
    assert perspective() == "Map", "the key that was there before does nothing any more"
