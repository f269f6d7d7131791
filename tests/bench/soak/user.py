"""What is done with the workbench, again and again."""
import json
import subprocess
import time

from display import wait_for

# Each view that fits is opened once more, seen for a moment and closed; then the front of each stack changes.
OPEN_AND_CLOSE = """
(function () {
  let before = views(UI).filter(v => v.open).map(v => v.id);
  for (let type of TYPES) {
    let opened = openView(type, UI);
    sleep(0.4);
    if (before.indexOf(opened) < 0) closeView(opened, UI);
  }
  keepPerspective("as it was", UI);
  for (let each of before.slice(0, 4)) closeView(each, UI);
  keepPerspective("with less", UI);
  for (let name of ["as it was", "with less", "as it was"]) { perspective(name, UI); sleep(0.5); }
  forgetPerspective("with less", UI);
  forgetPerspective("as it was", UI);
  resetLayout(UI);
  sleep(0.5);
})();
"""
END_AND_OPEN = """
(function () {
  remove(UI);
  sleep(0.5);
  const wrong = load(FILE);
  if (wrong.length) throw new Error(wrong.join("; "));
  waitForLink(300, UI);
})();
"""
REST = 3                            # seconds in which what was closed ends


class User:
    """By scripts and, where the window has to be asked, by keys."""

    def __init__(self, scripts, display, configurations):
        self.scripts = scripts
        self.display = display
        self.configurations = configurations
        self.rounds = 0
        self.known = {}

    def run(self, script, **values):
        for name, value in values.items():
            script = script.replace(name, json.dumps(value))
        return self.scripts.run(script, "soak")

    def round(self):
        """One robot is looked at with all its views; then another one is ended and opened again, and all begins to rest."""
        self.rounds += 1
        names = list(self.configurations)
        shown, ended = names[self.rounds % len(names)], names[(self.rounds + 2) % len(names)]
        self.choose(shown)
        self.run(OPEN_AND_CLOSE, UI=shown, TYPES=self.types(shown))
        self.run(END_AND_OPEN, UI=ended, FILE=str(self.configurations[ended]))
        self.choose(names[0])
        time.sleep(REST)

    def types(self, ui):
        """The same each time: what fits may depend on what a robot has said so far."""
        if ui not in self.known:
            self.known[ui] = self.run("viewTypes(UI).filter(t => t.fit === 'connected').map(t => t.type)", UI=ui)
        return self.known[ui]

    def choose(self, ui):
        """As a user does it by the search."""
        wait_for(self.windows, "the window")
        self.command("windowactivate", "--sync", self.windows()[0], "key", "ctrl+3", "sleep", "1", "type", "--delay", "30", ui)
        self.command("sleep", "1", "key", "Return", "sleep", "1")

    def windows(self):
        return self.command("search", "--onlyvisible", "--name", "(^| - )RobotUI *$").split()

    def command(self, *words):
        return subprocess.run(["xdotool", *words], env=self.display.environment, timeout=300, capture_output=True, text=True).stdout
