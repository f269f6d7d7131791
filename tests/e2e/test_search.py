"""The search for commands, opened by its keys and typed into at once."""
import pytest

from conftest import wait_for
from desktop import Keys, Window, missing, output


@pytest.fixture(autouse=True)
def display():
    if missing():
        pytest.skip(f"tests in a window need {missing()}")


def focus_the_map(window):
    window.click((600, 300))


def close_a_menu(window):
    window.click((160, 20))
    output("xdotool", "sleep", "0.5", "key", "Escape")


def close_the_search(_window):
    output("xdotool", "key", "--delay", "0", "ctrl+3", "m", "Escape")


def leave_the_focus_in_a_list(window):
    window.click((80, 60))


def press_the_title(window):
    window.click((40, 20))


STATES = (focus_the_map, close_a_menu, close_the_search, leave_the_focus_in_a_list, press_the_title)


def run(words):
    """All keys at once, as fast as they can be sent: the first ones come before anything is painted."""
    output("xdotool", "key", "--delay", "0", "ctrl+3", *("space" if c == " " else c for c in words), "Return")


def test_what_is_typed_at_once_after_the_keys_of_the_search_is_its(simulator):
    window = Window.open(simulator, "ros")
    output("xdotool", "windowactivate", "--sync", window.id)
    run("stop all robots")
    wait_for(window.stop_button, what="the bar")
    wait_for(window.release_button, what="the stop that was typed while the window was being built")
    run("release all robots")
    wait_for(lambda: window.release_button() is None, what="the release")
    wait_for(window.is_live, what="a live robot")

    for state in STATES:
        state(window)
        run("stop all robots")
        wait_for(window.release_button, what=f"the stop by the search, after: {state.__name__}")
        state(window)
        run("release all robots")
        wait_for(lambda: window.release_button() is None, what=f"the release by the search, after: {state.__name__}")

    focus_the_map(window)
    Keys.press("F12")
    wait_for(window.release_button, what="the stop by F12")
