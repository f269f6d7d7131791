"""A robot gets its UI: by the form in the window, and by ./robotui new."""
import contextlib
import re
import subprocess

import pytest

from conftest import ROOT, Robot, free_port, java, wait_for
from desktop import DARK, Keys, Picture, Window, missing, output, pause

RUN_SECONDS = 120

# All that are installed, in the order of their identifiers; the examples of the SDK are in no product.
RFIC = re.compile(r'<plugin id="org\.robotui\.rfic\.([a-z0-9]+)"')
FRAMEWORKS = sorted(name for feature in (ROOT / "features").glob("*/feature.xml")
                    if "sdk" not in feature.parent.name for name in RFIC.findall(feature.read_text()))
HEADING = 44                                # pixels of the line of steps


@pytest.fixture
def keira(processes, environment):
    """A simulated robot that speaks Player and ROS at once; where they are."""
    plugins = ROOT / "product/target/products/org.robotui.headless.product/linux/gtk/x86_64/plugins"
    bundles = ("org.robotui.sim", "org.robotui.ros", "org.robotui.message", "org.robotui.player", "org.robotui.net", "org.robotui.geometry", "slf4j.api")
    jars = [str(next(plugins.glob(f"{bundle}_*.jar"))) for bundle in bundles]
    process = processes.start([java(), "-cp", ":".join(jars), "org.robotui.sim.Main", "--robot", "keira", "--speak", "ros,player", "--seed", "1"],
                              "keira", environment)
    wait_for(lambda: "PLAYER_PORT=" in process.out.read_text() and "ROS_MASTER_URI=" in process.out.read_text(), seconds=60, what="the robot")
    return dict(line.split("=", 1) for line in process.out.read_text().splitlines() if "=" in line)


def robotui(environment, *arguments):
    return subprocess.run([ROOT / "robotui", *arguments], env=environment | {"ROS_IP": "127.0.0.1"}, stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=RUN_SECONDS, check=False)


def player(keira):
    return ["--rfic", "player", "--set", "host=127.0.0.1", "--set", f"port={keira['PLAYER_PORT']}"]


def test_a_script_writes_what_the_form_would_and_adds_a_second_robot(environment, keira, tmp_path):
    file = tmp_path / "team.yaml"
    first = robotui(environment, "new", *player(keira), "--name", "Keira", file)
    assert first.returncode == 0, first.stderr
    assert "type mobilebase: brings" in first.stdout and "+ teleop: cmd_vel to position2d:0/velocity" in first.stdout
    assert "camera.image <-> base.camera:0; also fits: base.camera:1" in first.stdout
    file.write_text("# ours\n" + file.read_text() + "  # of Keira\n\nwindows: [Keira]   # one\n")
    before = file.read_text()

    second = robotui(environment, "new", "--rfic", "ros", "--set", f"master={keira['ROS_MASTER_URI']}", "--name", "Natalie", file)
    assert second.returncode == 0, second.stderr
    after = file.read_text()
    at = after.index("  Natalie:\n")
    end = after.index("\nwindows:")
    assert after[:at] + after[end:] == before, "all that stood there stays, in its order"
    assert "  Natalie:\n    type: mobilebase\n" in after and "camera.image: base.camera/image_raw\n" in after

    checked = robotui(environment, "check", file)
    assert checked.returncode == 0 and "no errors, no warnings" in checked.stdout, checked.stdout


def test_what_is_wrong_is_said_and_nothing_is_written(environment, keira, tmp_path):
    file = tmp_path / "wrong.yaml"
    cases = [
        (["--rfic", "player", "--set", f"port={free_port()}", "--set", "host=127.0.0.1", "--wait", "3", "--name", "Keira"], "Connection refused"),
        (["--rfic", "plaier", "--name", "Keira"], "there is no robot interface 'plaier'; there are " + ", ".join(FRAMEWORKS)),
        ([*player(keira), "--name", "a/b"], "none of / $ { }"),
        ([*player(keira), "--set", "prt=1", "--name", "Keira"], "prt"),
        ([*player(keira), "--name", "Keira", "--views", "map,camra"], "there is no view 'camra'"),
        ([*player(keira), "--name", "Keira", "--connect", "camera.image=camera:7"], "what fits camera.image is base.camera:0, base.camera:1"),
    ]
    for arguments, words in cases:
        result = robotui(environment, "new", *arguments, file)
        assert result.returncode == 1 and words in result.stderr, f"{arguments}: {result.returncode} {result.stderr}"
        assert not file.exists()
    file.write_text("ruics: [\n")
    result = robotui(environment, "new", *player(keira), "--name", "Keira", file)
    assert result.returncode == 1 and "has an error, which comes first" in result.stderr
    assert file.read_text() == "ruics: [\n"


# ---- in the window --------------------------------------------------------------------------------------------------


class Form:
    """The three steps, by key and mouse. Its buttons lie at its lower right edge."""

    def __init__(self, window):
        self.window = wait_for(lambda: self._asked(window), seconds=60, what="the form")
        words = dict(line.split("=") for line in output("xdotool", "getwindowgeometry", "--shell", self.window).decode().split() if "=" in line)
        self.width, self.height = int(words["WIDTH"]), int(words["HEIGHT"])

    @staticmethod
    def _asked(window):
        """A window that has just come does not hear its keys yet: so does a user press them again."""
        output("xdotool", "windowactivate", "--sync", window.id, *pause(1.5), "key", "ctrl+shift+n", *pause(2))
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^New robot UI *$"], capture_output=True, text=True, timeout=60, check=False)
        return next(iter(found.stdout.split()), None)

    def framework(self, name):
        """Chooses in the menu of frameworks, which stand in the order of their identifiers."""
        output("xdotool", "windowactivate", "--sync", self.window, "key", "Down", *pause(0.7))
        for _ in range(FRAMEWORKS.index(name) + 1):
            Keys.press("Down")
        output("xdotool", "key", "Return", *pause(1))

    def reaches(self, name):
        """Chooses a framework and connects. The keys do not wait for the menu: a user who sees another framework chosen does it again."""
        self.framework(name)
        self.connect()
        with contextlib.suppress(AssertionError):
            return wait_for(self.may_go_on, seconds=25, what="the robot")

    def click(self, x, y):
        output("xdotool", "mousemove", "--window", self.window, str(x), str(y), "click", "1", *pause(0.8))

    def connect(self):
        self.click(330, self.height - 84)

    def next(self):
        """Goes on to the next step, and waits until that is shown: a busy window shows the former one, whose button can still be pressed."""
        before = self._heading()
        self.create()
        wait_for(lambda: self._heading() != before, what="the next step")

    def create(self):
        self.click(self.width - 50, self.height - 22)

    def _heading(self):
        """The line of the steps, as it is painted."""
        return output("import", "-silent", "-window", self.window, "-crop", f"{self.width}x{HEADING}+0+0", "-depth", "8", "ppm:-")

    def may_go_on(self):
        """Whether the last button is in the accent's colours."""
        picture = output("import", "-silent", "-window", self.window, "-depth", "8", "ppm:-")
        return Picture(picture).count(DARK["accent"], self.width - 90, self.height - 40) > 8


@pytest.mark.parametrize("speaks", ["player", "ros"])
def test_a_user_makes_a_robot_ui_in_three_steps_and_it_is_shown(processes, environment, keira, tmp_path, speaks):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    (tmp_path / "empty.yaml").write_text("ruics: {}\n")
    robot = Robot(processes, keira["ROS_MASTER_URI"], environment | {"PLAYER_HOST": "127.0.0.1", "PLAYER_PORT": keira["PLAYER_PORT"]})
    window = Window.open(robot, tmp_path / "empty.yaml", name=speaks)
    form = Form(window)
    assert not form.may_go_on(), "nothing is known yet"
    wait_for(lambda: form.reaches(speaks), seconds=120, what="the robot")
    form.next()
    wait_for(form.may_go_on, what="views")
    form.next()
    assert not form.may_go_on(), "it has no name yet"
    output("xdotool", "type", "--delay", "40", "Keira")
    wait_for(form.may_go_on, what="the text")
    assert not (tmp_path / "keira.yaml").exists(), "nothing is written before the last button"
    form.create()

    written = wait_for(lambda: (tmp_path / "keira.yaml").exists() and (tmp_path / "keira.yaml").read_text(), what="the file")
    assert f"type: {speaks}" in written and "type: mobilebase" in written
    wait_for(window.is_live, what="the robot in the window")
    wait_for(lambda: window.picture().count(DARK["laser"], 200, 44) > 100, what="its scan on the map")
    assert robotui(environment, "check", tmp_path / "keira.yaml").returncode == 0


def test_a_robot_that_is_not_reached_cannot_be_gone_on_with(processes, environment, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    (tmp_path / "empty.yaml").write_text("ruics: {}\n")
    robot = Robot(processes, f"http://127.0.0.1:{free_port()}", environment)
    form = Form(Window.open(robot, tmp_path / "empty.yaml"))
    form.framework("player")
    form.connect()
    output("xdotool", *pause(4))
    assert not form.may_go_on()
