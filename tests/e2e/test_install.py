"""Features of an update site and jars of a folder: installed, replaced and removed while RobotUI runs."""
import functools
import http.server
import json
import os
import re
import shutil
import subprocess
import sys
import threading

import pytest

from conftest import NO_DISPLAY, ROOT, Robot, free_port, wait_for
from desktop import DARK, Picture, Window, missing, output, pause
from test_product import PRODUCTS, UPDATE_SITE, installed, run

sys.path.insert(0, str(ROOT / "tests" / "sample-site"))

sys.path.insert(0, str(ROOT / "tools/python"))

import robotui  # noqa: E402
import sample_sites  # noqa: E402

FEATURE = "org.example.feature.line"
BUNDLES = "configuration/org.eclipse.equinox.simpleconfigurator/bundles.info"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """All the sample sites, in one folder."""
    if not (UPDATE_SITE / "p2.index").exists():
        pytest.skip("there is no update site: ./robotui package makes it")
    folder = tmp_path_factory.mktemp("sites")
    for name in sample_sites.SITES:
        sample_sites.make(folder, name)
    return folder


class Served:
    """Folders served by http on loopback; what stands at the address can be exchanged."""

    def __init__(self, made, folder):
        self.made, self.folder = made, folder
        handler = functools.partial(Quiet, directory=str(folder))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        self.address = f"http://127.0.0.1:{self.server.server_address[1]}/site"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def show(self, name):
        shutil.rmtree(self.folder / "site", ignore_errors=True)
        return shutil.copytree(self.made / name, self.folder / "site")


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture
def site(made, tmp_path):
    (tmp_path / "served").mkdir()
    served = Served(made, tmp_path / "served")
    yield served
    served.server.shutdown()
    served.server.server_close()


class Product:
    """An unpacked product of a user of its own, and a robot that no type of it speaks with yet."""

    def __init__(self, tmp_path, processes):
        self.home, self.processes = tmp_path / "robotui", processes
        self.variables = {"XDG_STATE_HOME": str(tmp_path / "state"), "XDG_DATA_HOME": str(tmp_path / "data")}
        self.folder = tmp_path / "data/robotui/bundles"
        shutil.copytree(PRODUCTS["headless"], self.home, symlinks=True, ignore=shutil.ignore_patterns("classes.jsa"))
        self.config = tmp_path / "robby.yaml"
        self.port = free_port()
        self.config.write_text(f"ruics:\n  Robby:\n    type: single\n    view: text\n    rfics:\n      base: {{type: line, port: {self.port}}}\n",
                               encoding="utf-8")

    def ask(self, *arguments):
        return run(self.home / "robotui", *arguments, **self.variables)

    def start(self, tmp_path):
        text = (ROOT / "docs/extending.md").read_text(encoding="utf-8")
        robot = tmp_path / "crawler.py"
        robot.write_text(re.search(r"```python\n(.*?)```", text, re.DOTALL).group(1).replace("4000", str(self.port)), encoding="utf-8")
        self.processes.start([sys.executable, robot], "crawler", dict(os.environ))
        surroundings = {name: value for name, value in os.environ.items() if name not in NO_DISPLAY} | self.variables
        self.running = self.processes.start([self.home / "robotui", "run", self.config, "--json"], "robotui", surroundings)
        self.log = tmp_path / "state/robotui/workspace-1/robotui.log"
        wait_for(lambda: self.log.exists() and "RobotUI 0." in self.log.read_text(), 60, "RobotUI")

    def lines(self):
        return [json.loads(line) for line in self.running.out.read_text().splitlines(keepends=True) if line.endswith("\n")]

    def says(self, sentence):
        wait_for(lambda: sentence in self.log.read_text(encoding="utf-8"), 60, f"'{sentence}' in {self.log.read_text(encoding='utf-8')[-2000:]}")

    def shows_the_robot(self):
        """From now on, not before."""
        before = len(self.lines())
        wait_for(lambda: any(line.get("port") == "base.pose" and line["rate_hz"] > 0 for line in self.lines()[before:]), 60,
                 f"a pose in {self.running.err.read_text()[-2000:]}")

    def state(self):
        return (self.home / BUNDLES).read_bytes(), sorted(file.name for file in (self.home / "plugins").iterdir())


@pytest.fixture
def product(tmp_path, processes):
    return Product(tmp_path, processes)


def test_a_feature_is_used_updated_and_removed_without_a_restart(product, site, tmp_path):
    product.start(tmp_path)
    site.show("one")

    come = product.ask("install", site.address, "--unsigned")

    assert come.returncode == 0, come.stdout + come.stderr
    assert come.stdout.strip() == "Installed Robots that speak lines 1.0.0."
    product.says("Installed org.robotui.rfic.line 1.0.0.sample")
    product.shows_the_robot()

    site.show("two")
    newer = product.ask("update", "--unsigned")
    assert newer.stdout.strip() == "Updated Robots that speak lines from 1.0.0 to 2.0.0.", newer.stderr
    product.says("Installed org.robotui.rfic.line 2.0.0.sample. Removed org.robotui.rfic.line 1.0.0.sample.")
    product.shows_the_robot()

    gone = product.ask("remove", FEATURE)
    assert gone.stdout.strip() == "Removed Robots that speak lines 2.0.0.", gone.stderr
    product.says("Removed org.robotui.rfic.line 2.0.0.sample.")
    assert "org.robotui.rfic.line" not in installed(product.home)
    assert product.running.poll() is None


def test_what_is_refused_leaves_the_product_as_it_was(product, site):
    before = product.state()

    def refused(name, *arguments):
        folder = site.show(name)
        if "damaged" in arguments:
            (jar,) = (folder / "plugins").iterdir()
            jar.write_bytes(jar.read_bytes()[:-1] + b"x")
            arguments = ("--unsigned",)
        done = product.ask("install", site.address, *arguments)
        assert done.returncode == 1, done.stdout + done.stderr
        assert product.state() == before
        return done.stderr

    assert "Lines by radio 1.0.0 needs org.example.radio 3.0.0 or newer, but older than 4.0.0, which is neither on the site nor installed." in refused("lacking", "--unsigned")
    assert "its checksum is another one" in refused("one", "damaged")
    unsigned = refused("one")
    assert "Nobody has signed" in unsigned and "org.robotui.rfic.line_1.0.0.sample.jar" in unsigned and "Nothing was installed" in unsigned
    site.server.shutdown()
    site.server.server_close()
    assert f"{site.address} cannot be read" in refused("one")


def test_a_jar_of_the_folder_is_live_until_it_is_removed(product, made, tmp_path):
    (old,), (new,) = (list((made / name / "plugins").iterdir()) for name in ("one", "two"))
    product.start(tmp_path)

    assert product.ask("install", shutil.copy(old, tmp_path / "line.jar")).returncode == 0
    product.says("Installed org.robotui.rfic.line 1.0.0.sample from")
    product.shows_the_robot()

    (product.folder / "broken.jar").write_text("half a jar", encoding="utf-8")
    product.says("broken.jar is no whole jar")
    shutil.copy(new, product.folder / "line.jar")
    product.says("Installed org.robotui.rfic.line 2.0.0.sample from")
    product.shows_the_robot()

    assert product.ask("remove", "line.jar").returncode == 0
    product.says("Removed org.robotui.rfic.line 2.0.0.sample: line.jar has gone.")
    assert product.running.poll() is None


def test_what_a_build_makes_in_a_folder_is_linked(product, made, tmp_path):
    (jar,) = (made / "one/plugins").iterdir()
    target = tmp_path / "project/bundles/line/target"
    target.mkdir(parents=True)
    shutil.copy(jar, target / "line-1.0.0-SNAPSHOT.jar")

    assert product.ask("install", tmp_path / "project").returncode == 0

    assert os.readlink(product.folder / "line-1.0.0-SNAPSHOT.jar") == str(target / "line-1.0.0-SNAPSHOT.jar")
    checked = product.ask("check", product.config)
    assert checked.returncode == 0, checked.stdout + checked.stderr


class Software:
    """The form in which a user installs and removes. Its first feature by name is that of the site; buttons that can do nothing are passed over by Tab."""

    def __init__(self, window):
        output("xdotool", "windowactivate", "--sync", window.id)
        output("xdotool", "key", "--delay", "0", "ctrl+3", *"install", "Return")
        self.id = wait_for(lambda: titled("^Install software"), what="the form")
        self.row = wait_for(self._offered, what="what the site offers")

    def _offered(self):
        """The version that is new, in the colour of accents."""
        picture = Picture(output("import", "-silent", "-window", self.id, "-depth", "8", "ppm:-"))
        return picture.middle(DARK["accent"], picture.width // 3, 60, picture.width, picture.height // 2)

    def press(self):
        """What can be done with the feature: to install or to remove it."""
        output("xdotool", "mousemove", "--window", self.id, *map(str, self.row), "click", "1", *pause(0.5), "key", "Tab", "Tab", "space")

    def install_unsigned(self):
        self.press()
        asked = wait_for(lambda: titled("^Not signed"), what="the question")
        output("xdotool", "windowactivate", "--sync", asked, "key", "Return")


def setting_of(ui):
    """None until the view runs again."""
    try:
        return ui.call("settings", "trip")["limit"]
    except robotui.Error:
        return None


def titled(title):
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True, text=True, timeout=60, check=False).stdout.split()
    return found[-1] if found else None


@pytest.mark.skipif(bool(missing()), reason=f"tests in a window need {missing()}")
def test_a_view_is_installed_in_the_window_opened_and_removed_and_its_settings_stay(made, site, processes, environment, tmp_path):
    home = shutil.copytree(PRODUCTS["workbench"], tmp_path / "robotui", symlinks=True, ignore=shutil.ignore_patterns("classes.jsa"))
    state = tmp_path / "state/robotui"
    state.mkdir(parents=True)
    site.show("view")
    (state / "update-sites.txt").write_text(f"{site.address}\n", encoding="utf-8")
    config = tmp_path / "one.yaml"
    config.write_text("ruics:\n  Robby:\n    type: single\n    view: status\n    rfics:\n      base: {type: player, port: 1}\n", encoding="utf-8")
    surroundings = environment | {"XDG_STATE_HOME": str(tmp_path / "state"), "XDG_DATA_HOME": str(tmp_path / "data")}
    process = processes.start([home / "robotui", "run", config, "--theme", "dark", "--script-socket"], "robotui", surroundings)
    window = Window(process)
    (socket,) = wait_for(lambda: list(state.glob("run/script-*.sock")), what="the socket for scripts")

    def types():
        return [each["type"] for each in ui.call("viewTypes")]

    with robotui.connect(socket, timeout=60) as ui:
        assert "trip" not in types()
        form = Software(window)
        form.install_unsigned()
        wait_for(lambda: "trip" in types(), 60, "the type of the view")
        ui.call("openView", "trip")
        wait_for(lambda: setting_of(ui) == 1000, what="the view")
        ui.call("setSetting", "trip", "limit", 25)
        wait_for(lambda: setting_of(ui) == 25, what="the setting")

        form.press()
        wait_for(lambda: "trip" not in types(), 60, "that it is gone")

        form.install_unsigned()
        wait_for(lambda: "trip" in types(), 60, "its return")
        wait_for(lambda: setting_of(ui) == 25, what="the setting that stayed")
    assert process.poll() is None
