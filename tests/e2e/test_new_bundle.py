"""./robotui new KIND NAME: bundles of every kind, made outside of the repository and inside, built, tested, installed and used."""
import json
import os
import re
import shutil
import subprocess
import sys

import pytest

from conftest import ROOT, free_port, needs_long
from test_product import DIRECTOR, PRODUCTS, UPDATE_SITE, installed, run

KINDS = ("rfic", "uic", "entity", "display", "ruic")
EXAMPLES = re.compile(r"org\.robotui\.(rfic\.line|uic\.trip|entity\.(reach|speed)|ruic\.cockpit)|\b(Line|Trip|Reach|Speed|Cockpit)[A-Z]|@[a-z]+@")
BUILD_SECONDS = 600


def new(root, *arguments):
    return subprocess.run([root / "robotui", "new", *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False)


def maven(folder, *arguments):
    """The Maven that ./robotui keeps; what it said, where it failed."""
    command = next((ROOT / ".tools").glob("apache-maven-*/bin/mvn"))
    done = subprocess.run([command, "-B", "-ntp", *arguments], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=BUILD_SECONDS, check=False)
    assert done.returncode == 0, done.stdout[-6000:]
    return done.stdout


def files(folder):
    return [file for file in folder.rglob("*") if file.is_file() and "target" not in file.parts]


# ---- outside ------------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """One project with a bundle of every kind, built and tested."""
    if not (UPDATE_SITE / "p2.index").exists():
        pytest.skip("there is no update site: ./robotui package makes it")
    folder = tmp_path_factory.mktemp("project") / "acme"
    for kind in KINDS:
        made = new(ROOT, kind, f"acme.my_{kind}", "--in", folder)
        assert made.returncode == 0, made.stderr
    print(maven(folder, "verify"), file=sys.stderr)
    return folder


def test_nothing_of_the_examples_names_is_left(project):
    for file in files(project):
        assert not EXAMPLES.search(file.name), file
        found = EXAMPLES.search(file.read_text(encoding="utf-8"))
        assert not found, f"{file}: {found.group()}"


def test_each_bundle_has_passed_its_tests(project):
    for kind in KINDS:
        reports = list((project / f"bundles/acme.my_{kind}").glob("target/surefire-reports/TEST-*.xml"))
        text = "".join(report.read_text(encoding="utf-8") for report in reports)
        assert sum(map(int, re.findall(r'<testsuite [^>]*tests="(\d+)"', text))) >= 2, kind
    contract = (project / "bundles/acme.my_rfic/target/surefire-reports").glob("TEST-*ContractTest.xml")
    assert 'tests="33"' in next(contract).read_text(encoding="utf-8"), "the checks that every robot interface passes"


def test_an_ide_finds_its_projects_its_target_and_its_launches(project):
    assert (project / "robotui.target").exists() and (project / "RobotUI.launch").exists()
    for kind in KINDS:
        bundle = project / f"bundles/acme.my_{kind}"
        assert f"<name>acme.my_{kind}</name>" in (bundle / ".project").read_text(encoding="utf-8")
        assert f'value="acme.my_{kind}"' in (bundle / f"Unit tests of acme.my_{kind}.launch").read_text(encoding="utf-8")


def test_a_product_takes_the_bundles_in_and_they_show_the_robot_of_the_guide(project, tmp_path, processes):
    product, state, port = tmp_path / "robotui", str(tmp_path / "state"), free_port()
    shutil.copytree(PRODUCTS["workbench"], product, symlinks=True, ignore=shutil.ignore_patterns("classes.jsa"))
    units = ",".join(f"acme.my_{kind}.feature.feature.group" for kind in KINDS)
    config = tmp_path / "acme.yaml"
    config.write_text("ruics:\n  Robby:\n    type: my_ruic\n    rfics:\n      base: {type: my_rfic, port: %d}\n    uics:\n      odo: {type: my_uic, limit: 5}\n" % port,
                      encoding="utf-8")
    before = run(product / "robotui", "check", config, XDG_STATE_HOME=state)
    assert "type 'my_ruic' is not installed" in before.stdout + before.stderr

    done = run(product / "robotui", *DIRECTOR, "-repository", (project / "site/target/repository").as_uri(), "-installIU", units, seconds=300,
               XDG_STATE_HOME=state)
    assert done.returncode == 0, done.stdout + done.stderr

    assert {f"acme.my_{kind}" for kind in KINDS} <= installed(product)
    checked = run(product / "robotui", "check", config, XDG_STATE_HOME=state)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    assert re.search(r"connected +odo\.odometry \(Odometry\) +<- base\.pose", checked.stdout), checked.stdout

    text = (ROOT / "docs/extending.md").read_text(encoding="utf-8")
    robot = tmp_path / "crawler.py"
    robot.write_text(re.search(r"```python\n(.*?)```", text, re.DOTALL).group(1).replace("4000", str(port)), encoding="utf-8")
    processes.start([sys.executable, robot], "crawler", dict(os.environ))
    lines = run(product / "robotui", "run", config, "--json", "--for", "15", XDG_STATE_HOME=state).stdout.splitlines()
    poses = [line for line in map(json.loads, lines) if line.get("port") == "base.pose" and line["rate_hz"] > 0]
    assert poses, lines[-3:]


# ---- inside -------------------------------------------------------------------------------------------------------------


@pytest.fixture
def checkout(tmp_path):
    """What is checked out here, changes included, as a repository of its own."""
    folder = tmp_path / "robotui"
    folder.mkdir()
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"], capture_output=True, check=True).stdout
    for name in filter(None, listed.decode().split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    git(folder, "init", "-q")
    git(folder, "add", "-A")
    git(folder, "-c", "user.name=test", "-c", "user.email=test@localhost", "commit", "-q", "-m", "all")
    (folder / ".tools").symlink_to(ROOT / ".tools")
    return folder


def git(folder, *arguments):
    return subprocess.run(["git", "-C", folder, *arguments], capture_output=True, text=True, check=True).stdout


def touched(folder):
    """Files in the root and in known folders, and folders that are new."""
    return {name.rstrip("/") for name in git(folder, "status", "--porcelain", "-z").split("\0") if name for name in [name[3:]]} - {".tools"}


def test_a_bundle_in_the_repository_touches_what_adr_112_lists(checkout):
    made = new(checkout, "rfic", "acme")
    assert made.returncode == 0, made.stderr
    derived = {"product/category.xml", "product/org.robotui.workbench.product", "product/org.robotui.headless.product", "releng/RobotUI.launch",
               "releng/RobotUI headless.launch"}
    new_folders = {f"{parent}/org.robotui.{name}.acme" for parent, name in (("bundles", "rfic"), ("features", "feature"))}
    assert touched(checkout) == {"ARCHITECTURE.md"} | new_folders | derived
    assert git(checkout, "diff", "--numstat", "ARCHITECTURE.md").split()[:2] == ["1", "0"], "one sentence"


@needs_long
def test_bundles_of_every_kind_in_the_repository_break_no_rule(checkout):
    """The rules read all bundles: two minutes. They hold for the examples of which the bundles are made in every run of the tests."""
    for kind in KINDS:
        made = new(checkout, kind, f"acme_{kind}")
        assert made.returncode == 0, made.stderr
    rules = maven(checkout, "verify", "-pl", ":org.robotui.architecture.tests")
    assert "Tests run" in rules


# ---- what cannot be done ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("arguments", "sentence"), [
    (("engine", "x"), "./robotui new rfic|uic|entity|display|ruic NAME"),
    (("rfic",), "as in ./robotui new rfic lidar"),
    (("rfic", "9x"), "begins with a small letter"),
    (("rfic", "class"), "no word of Java"),
    (("rfic", "ros"), "choose another name"),
    (("rfic", "acme.lidar"), "with --in FOLDER it is made outside"),
    (("rfic", "lidar", "--in", "/nowhere"), "such as acme.lidar"),
    (("rfic", "acme.lidar", "--in", ROOT / "x"), "choose a folder outside"),
    (("rfic", "acme.lidar", "--in", ROOT.parent), "choose a new or an empty folder"),
    (("rfic", "acme.lidar", "--in"), "--in needs a value"),
])
def test_what_cannot_be_done_is_said_with_its_remedy(arguments, sentence):
    before = sorted((ROOT / "bundles").iterdir())

    refused = new(ROOT, *arguments)

    assert refused.returncode == 2
    assert sentence in refused.stderr and "\tat " not in refused.stderr
    assert sorted((ROOT / "bundles").iterdir()) == before
