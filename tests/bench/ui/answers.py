"""How soon the window answers its user: views that a script opens, and the search, into which words are typed."""
import contextlib
import re
import subprocess

import robotui

from building import CannotMeasure
from display import wait_for

VIEWS = ("plot", "log", "camera", "teleop", "tftree", "parameters", "graph")
OPEN = "(function () { let asked = Date.now(); return [asked, openView('VIEW')]; })()"
ROBOT, WORDS, TIMES = "Robot", "camera", 3
PATIENCE = 120
FEW_SECONDS = 20


def of(workbench, display):
    """Milliseconds from asking for each view until it was first painted; and what the window says of its search."""
    with robotui.connect(place(workbench)) as scripts:
        views = [opened(workbench, scripts, view) for view in VIEWS]
    for _ in range(TIMES):
        search(display)
    with contextlib.suppress(CannotMeasure):                                      # where no key came, the figure is left out
        wait_for(lambda: workbench.said()["search_ms"]["answering"]["count"] >= TIMES, "an answer of the search", FEW_SECONDS)
    return {"views": views, "search": workbench.said()["search_ms"]}


def place(workbench):
    wait_for(lambda: "scripts may come by" in workbench.log.read_text(), "the socket for scripts", PATIENCE)
    return re.search(r"scripts may come by (\S+)", workbench.log.read_text()).group(1)


def opened(workbench, scripts, view):
    asked, name = scripts.run(OPEN.replace("VIEW", view))
    wait_for(lambda: after(workbench, name, asked) >= 0, f"the view {view}", PATIENCE)
    scripts.call("closeView", name)
    return after(workbench, name, asked)


def after(workbench, view, asked):
    return workbench.said()["seen_epoch_ms"].get(f"{ROBOT}/{view}", 0) - asked


def search(display):
    """Slowly enough for an answer to each letter."""
    def hands(*words):
        return subprocess.run(["xdotool", *words], env=display.environment, timeout=PATIENCE, capture_output=True, text=True).stdout
    windows = hands("search", "--onlyvisible", "--name", "(^| - )RobotUI *$").split()
    hands("windowactivate", "--sync", windows[0], "key", "ctrl+3", "sleep", "1", "type", "--delay", "300", WORDS)
    hands("sleep", "0.5", "key", "Escape", "sleep", "0.5")
