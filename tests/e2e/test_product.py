"""The products as somebody gets them who unpacks an archive: their own launcher, on machines that lack this and that."""
import os
import pathlib
import re
import shutil
import stat
import subprocess
import zipfile

import pytest

from conftest import NO_DISPLAY, ROOT, needs_long

PRODUCTS = {kind: ROOT / f"product/target/products/org.robotui.{kind}.product/linux/gtk/x86_64" for kind in ("workbench", "headless")}
UPDATE_SITE = ROOT / "product/target/repository"
DIRECTOR = ("-application", "org.eclipse.equinox.p2.director")
ROS = "org.robotui.feature.ros.feature.group"


def run(program, *arguments, seconds=120, without=(), **variables):
    environment = {name: value for name, value in os.environ.items() if name not in (*NO_DISPLAY, *without)} | variables
    return subprocess.run([program, *map(str, arguments)], env=environment, stdin=subprocess.DEVNULL, text=True, capture_output=True,
                          timeout=seconds, check=False)


def shell(*parts, then, **variables):
    """Runs shell code after parts of ./robotui."""
    code = "set -euo pipefail\n" + "".join(f"source {ROOT}/tools/{part}.sh\n" for part in parts) + then
    return run("/bin/bash", "-c", code, **variables)


@pytest.fixture(params=PRODUCTS)
def product(request):
    return PRODUCTS[request.param]


@pytest.fixture
def unpacked(tmp_path):
    """A product of its own, in a folder with a name that is not ASCII and has a space."""
    folder = tmp_path / "Büro 1" / "robotui"
    shutil.copytree(PRODUCTS["headless"], folder, symlinks=True)
    return folder


@pytest.fixture
def state(tmp_path):
    return tmp_path / "state"


# ---- what is in it ----------------------------------------------------------------------------------------------------


def test_it_has_what_belongs_to_a_product(product):
    for name in ("LICENSE", "THIRD-PARTY.md", "README.md", "robotui.desktop", "robotui.svg", "configs/demo.yaml", "configs/lcm/types"):
        assert (product / name).exists(), name


def test_its_documentation_has_a_page_for_each_view_and_no_link_that_leads_nowhere(product):
    pages = product / "documentation"
    views = {file.stem for file in (ROOT / "docs/views").glob("*.md")}

    assert (pages / "index.html").exists()
    assert {file.stem for file in (pages / "docs/views").glob("*.html")} == views
    for page in pages.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert "| --- |" not in text and "|---|" not in text, f"{page}: a table that is none"
        for link in re.findall(r'(?:href|src)="([^"#]+)', text):
            assert re.match("https?:", link) or (page.parent / link).exists(), f"{page}: {link}"


def test_each_says_which_version_it_is(product):
    for program in (product / "robotui", ROOT / "robotui"):
        said = run(program, "--version")
        assert said.returncode == 0, said.stderr
        assert re.match(r"RobotUI 0\.\d+\.\d+.*\nJava \d+.* in /", said.stdout), said.stdout


def test_its_own_launcher_runs_the_demo(product, state):
    demo = run(product / "robotui", "run", "--text", "--for", "4", XDG_STATE_HOME=str(state))

    assert demo.returncode == 0, demo.stderr
    assert "ROS_MASTER_URI=http://127.0.0.1:" in demo.stderr
    assert "Natalie" in demo.stdout


def test_its_own_launcher_checks_a_configuration(product, state):
    fine = run(product / "robotui", "check", "demo", XDG_STATE_HOME=str(state))

    assert fine.returncode == 0, fine.stderr
    assert "Natalie" in fine.stdout
    assert "no errors, no warnings" in fine.stdout


def test_it_goes_among_the_applications_of_a_desktop_and_out_again(unpacked, tmp_path):
    data = tmp_path / "data"
    assert run(unpacked / "robotui", "desktop", XDG_DATA_HOME=str(data)).returncode == 0

    entry = (data / "applications/robotui.desktop").read_text(encoding="utf-8")
    assert f'Exec="{unpacked}/robotui" run\n' in entry
    assert f"Icon={unpacked}/robotui.svg\n" in entry

    assert run(unpacked / "robotui", "desktop", "--remove", XDG_DATA_HOME=str(data)).returncode == 0
    assert list((data / "applications").iterdir()) == []


# ---- what is given away -----------------------------------------------------------------------------------------------


@pytest.fixture
def packed(tmp_path):
    """Single files and packages of products that say with what they were started; made as ./robotui package makes them of the real ones."""
    for kind in ("workbench", "headless"):
        folder = tmp_path / f"robotui-{kind}"
        bundles = folder / "configuration/org.eclipse.equinox.simpleconfigurator"
        bundles.mkdir(parents=True)
        (bundles / "bundles.info").write_text("#version=1\norg.robotui.core,0.1.0.202611271849,plugins/core.jar,4,true\n", encoding="ascii")
        for name in ("robotui.svg", "robotui.desktop"):
            shutil.copy(ROOT / "features/org.robotui.feature.platform.headless/rootfiles" / name, folder)
        for name in ("LICENSE", "THIRD-PARTY.md"):
            shutil.copy(ROOT / name, folder)
        (folder / "robotui").write_text("#!/bin/sh\necho \"./robotui was asked for: $*\"\necho \".in $(dirname \"$(readlink -f \"$0\")\")\"\n", encoding="ascii")
        (folder / "robotui").chmod(0o755)
        subprocess.run(["tar", "-czf", tmp_path / f"robotui-{kind}-linux.gtk.x86_64.tar.gz", "-C", tmp_path, folder.name], check=True)
        shutil.rmtree(folder)
    made = run("/bin/bash", "-c", f"""set -euo pipefail
        ROOT={ROOT}; checkout_version() {{ echo "a test"; }}
        source $ROOT/tools/say.sh; source $ROOT/tools/package.sh; package_all '{tmp_path}'""")
    assert made.returncode == 0, made.stderr
    return tmp_path


@pytest.mark.skipif(not shutil.which("dpkg-deb"), reason="dpkg-deb is not installed")
def test_a_package_of_debian_puts_everything_where_it_belongs(packed, tmp_path):
    (deb,) = packed.glob("robotui_*.deb")
    control = subprocess.run(["dpkg-deb", "--info", deb], capture_output=True, text=True, check=True).stdout
    root = tmp_path / "root"
    subprocess.run(["dpkg-deb", "--extract", deb, root], check=True)
    owners = subprocess.run(["dpkg-deb", "--contents", deb], capture_output=True, text=True, check=True).stdout

    assert deb.name == "robotui_0.1.0+202611271849_amd64.deb"
    for line in ("Package: robotui\n", "Version: 0.1.0+202611271849\n", "Architecture: amd64\n", "Conflicts: robotui-headless\n"):
        assert line in control, control
    assert re.search("Depends: .*openjdk-21-jre-headless | .*libgtk-3-0", control), control
    assert all(" root/root " in line for line in owners.splitlines()), owners
    said = run(root / "usr/bin/robotui", "check", "demo").stdout
    assert "asked for: check demo" in said and "/usr/lib/robotui" in said
    assert (root / "usr/share/icons/hicolor/scalable/apps/robotui.svg").exists()
    assert "Exec=robotui run\n" in (root / "usr/share/applications/robotui.desktop").read_text(encoding="utf-8")
    page = subprocess.run(["gzip", "-dc", root / "usr/share/man/man1/robotui.1.gz"], capture_output=True, text=True, check=True).stdout
    assert "\n\\&robotui was asked for: help\n\\&.in" in page, page
    sums = subprocess.run(["dpkg-deb", "--ctrl-tarfile", deb], capture_output=True, check=True).stdout
    subprocess.run(["tar", "-xf", "-", "-C", root], input=sums, check=True)
    subprocess.run(["md5sum", "--quiet", "--check", "md5sums"], cwd=root, check=True)


@pytest.mark.skipif(not shutil.which("dpkg-deb"), reason="dpkg-deb is not installed")
def test_the_product_without_a_window_has_a_package_for_the_computers_of_robots(packed):
    made = sorted(deb.name for deb in packed.glob("*.deb"))
    (for_arm,) = packed.glob("robotui-headless_*_arm64.deb")
    control = subprocess.run(["dpkg-deb", "--info", for_arm], capture_output=True, text=True, check=True).stdout

    assert [name.rpartition("_")[2] for name in made] == ["amd64.deb", "arm64.deb", "amd64.deb"], made
    assert "Architecture: arm64\n" in control and "libgtk" not in control, control


def test_a_machine_for_which_there_is_no_window_gets_the_text_view():
    said = shell("say", "run", then="uname() { echo aarch64; }\nmode_for_display window ''\nmode_for_display window picture.png", ROOT=str(ROOT), DISPLAY=":0")

    assert said.stdout == "text" and said.returncode == 1
    assert "this machine is aarch64, so this is the text view" in said.stderr and "no screenshot" in said.stderr


def test_a_single_file_unpacks_itself_once_and_hands_on_what_it_is_asked_for(packed, tmp_path):
    file, cache = packed / "robotui-workbench-linux.gtk.x86_64.run", tmp_path / "Zwischen Lager"

    def start(*arguments, program=file):
        return run(program, *arguments, XDG_CACHE_HOME=str(cache))

    first, second = start("check", "a b"), start("--version")
    assert "asked for: check a b\n" in first.stdout and "unpacks itself" in first.stderr
    assert "asked for: --version\n" in second.stdout and second.stderr == ""
    (unpacked,) = (cache / "robotui").iterdir()
    assert start("--where").stdout == f"{unpacked}\n" and f".in {unpacked}\n" in second.stdout
    assert start("--unpack", tmp_path / "folder").returncode == 0
    assert "asked for: x" in run(tmp_path / "folder/robotui", "x").stdout
    refused = start("--unpack", tmp_path / "folder")
    assert refused.returncode == 1 and "is there already" in refused.stderr
    assert start("--forget").returncode == 0 and not (cache / "robotui").exists()

    damaged = tmp_path / "damaged.run"
    damaged.write_bytes(file.read_bytes()[:-10] + b"0123456789")
    damaged.chmod(0o755)
    said = start("run", program=damaged)
    assert said.returncode == 1 and "is damaged" in said.stderr
    assert not (cache / "robotui").exists()


def test_all_that_is_given_away_has_a_checksum(packed):
    sums = (packed / "SHA256SUMS").read_text(encoding="ascii")
    assert {line.split()[1] for line in sums.splitlines()} == {file.name for file in packed.glob("robotui*")}
    subprocess.run(["sha256sum", "--quiet", "--check", "SHA256SUMS"], cwd=packed, check=True)


@needs_long
@pytest.mark.parametrize("kind", ["robotui_*.deb", "robotui-workbench-*.run"])
def test_what_was_packaged_starts(kind, tmp_path):
    found = list((ROOT / "product/target/products").glob(kind))
    if not found:
        pytest.skip("there is none: ./robotui package makes it")
    program = found[0]
    if kind.endswith("deb"):
        subprocess.run(["dpkg-deb", "--extract", found[0], tmp_path / "root"], check=True)
        program = tmp_path / "root/usr/bin/robotui"
    surroundings = {"XDG_CACHE_HOME": str(tmp_path / "cache"), "XDG_STATE_HOME": str(tmp_path / "state")}

    assert re.match(r"RobotUI 0\.", run(program, "--version", **surroundings).stdout)
    for _ in range(2):
        fine = run(program, "check", "demo", **surroundings)
        assert fine.returncode == 0, fine.stderr
        assert "no errors, no warnings" in fine.stdout


# ---- a support bundle -------------------------------------------------------------------------------------------------


def test_a_support_bundle_tells_everything_but_secrets(product, state, tmp_path):
    log = state / "robotui/workspace-1/robotui.log"
    log.parent.mkdir(parents=True)
    log.write_text("12:00 WARN no way to ws://anna:hunter2@keira:9090\n", encoding="ascii")
    config = tmp_path / "keira.yaml"
    config.write_text("ruics:\n  keira:\n    password: hunter2\n", encoding="ascii")

    told = run(product / "robotui", "support", tmp_path / "support.zip", "--config", config, XDG_STATE_HOME=str(state))

    assert told.returncode == 0, told.stderr
    assert "which only you can read" in told.stdout and "configurations/1-keira.yaml" in told.stdout
    assert stat.S_IMODE((tmp_path / "support.zip").stat().st_mode) == 0o600
    with zipfile.ZipFile(tmp_path / "support.zip") as zipped:
        texts = {name: zipped.read(name).decode() for name in zipped.namelist()}
    bundles = "/".join(("product", "bundles.info"))             # in the bundle, no path of this repository
    assert {"CONTENTS.txt", "machine.txt", bundles, "state/workspace-1/robotui.log"} <= set(texts)
    assert "org.robotui.core" in texts[bundles]
    assert "hunter2" not in "".join(texts.values())
    assert "ws://***@keira:9090" in texts["state/workspace-1/robotui.log"]


# ---- machines that lack something ---------------------------------------------------------------------------------------


def test_an_older_java_in_the_path_is_passed_over(product, state, tmp_path):
    old = tmp_path / "jdk-17"
    (old / "bin").mkdir(parents=True)
    (old / "release").write_text('JAVA_VERSION="17.0.15"\n', encoding="ascii")
    (old / "bin/java").write_text("#!/bin/sh\necho UnsupportedClassVersionError >&2\nexit 1\n", encoding="ascii")
    (old / "bin/java").chmod(0o755)

    fine = run(product / "robotui", "-application", "org.robotui.headless.application", "-check", product / "configs/demo.yaml",
               XDG_STATE_HOME=str(state), JAVA_HOME=str(old), PATH=f"{old}/bin:{os.environ['PATH']}")

    assert fine.returncode == 0, fine.stderr


def test_without_any_java_it_says_which_is_needed_and_where_to_get_it():
    said = shell("say", "packages", "java", then="java_candidates() { :; }; need_java")

    assert said.returncode == 1
    assert "needs Java >= 21" in said.stderr
    assert "apt-get install" in said.stderr or "adoptium.net" in said.stderr


def test_without_a_display_the_window_says_so(state):
    said = run(PRODUCTS["workbench"] / "robotui", "-config", ROOT / "configs/player.yaml", XDG_STATE_HOME=str(state))

    assert said.returncode == 5, said.stderr
    assert "there is no display" in said.stderr
    assert "DISPLAY is not set" in said.stderr
    assert "log file" not in said.stdout + said.stderr


def test_without_gtk_the_window_names_the_package_that_has_it(state):
    gtk = next((line.split()[-1] for line in run("/sbin/ldconfig", "-p").stdout.splitlines() if "libgtk-3.so.0" in line), None)
    if gtk is None or run("unshare", "--map-root-user", "--mount", "true").returncode != 0:
        pytest.skip("needs GTK 3, and a namespace of file systems in which it is hidden")

    said = run("unshare", "--map-root-user", "--mount", "sh", "-c", 'mount --bind /dev/null "$0" && exec "$@"', os.path.realpath(gtk),
               PRODUCTS["workbench"] / "robotui", "-config", ROOT / "configs/player.yaml", XDG_STATE_HOME=str(state))

    assert said.returncode == 5, said.stderr
    assert "GTK 3 is not installed" in said.stderr and "libgtk-3-0" in said.stderr
    assert "log file" not in said.stdout + said.stderr


def test_without_home_it_is_that_of_the_user(product):
    folder = shell("say", "surroundings", then="need_home; state_folder", without=("HOME", "XDG_STATE_HOME"))

    assert folder.stdout == str(pathlib.Path(os.path.expanduser("~")) / ".local/state/robotui")
    for program in (product / "robotui", ROOT / "robotui"):
        assert run(program, "--version", without=("HOME",)).returncode == 0


def test_where_nothing_can_be_kept_that_is_said_and_it_runs(product, tmp_path):
    (tmp_path / "file").write_text("", encoding="ascii")
    rooms = tmp_path / "tmp"
    rooms.mkdir()

    fine = run(product / "robotui", "check", "demo", XDG_STATE_HOME=str(tmp_path / "file"), TMPDIR=str(rooms))

    assert fine.returncode == 0, fine.stderr
    assert f"{tmp_path}/file/robotui cannot be written" in fine.stderr
    assert "XDG_STATE_HOME" in fine.stderr
    assert list(rooms.glob("robotui-state*")) == []


def test_names_in_any_language_can_be_read_in_the_plain_locale(unpacked, state, tmp_path):
    config = tmp_path / "Räume/für-überall.yaml"
    config.parent.mkdir()
    shutil.copy(ROOT / "configs/player.yaml", config)

    fine = run(unpacked / "robotui", "check", config, XDG_STATE_HOME=str(state), LC_ALL="C", LANG="C")

    assert fine.returncode == 0, fine.stdout + fine.stderr


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can make a disk that is full")
def test_a_full_disk_is_said_in_a_sentence(tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk], check=True)
    try:
        subprocess.run(["dd", "if=/dev/zero", f"of={disk}/all", "bs=4k"], capture_output=True, check=False)
        fine = run(PRODUCTS["headless"] / "robotui", "check", "demo", XDG_STATE_HOME=str(disk))
    finally:
        subprocess.run(["umount", "--lazy", disk], check=True)

    assert fine.returncode == 0, fine.stderr
    assert "cannot be written" in fine.stderr
    assert "\tat " not in fine.stderr + fine.stdout


# ---- memory -------------------------------------------------------------------------------------------------------------


def bound(machine, **variables):
    return shell("say", "launch", then=f"machine_memory() {{ echo {machine}; }}; memory_bound", **variables)


@pytest.mark.parametrize(("machine", "usual"), [(1000, 512), (4000, 1000), (64000, 2048)])
def test_the_bound_of_memory_is_a_quarter_of_the_machine_between_two_bounds(machine, usual):
    assert bound(machine, without=("ROBOTUI_MEMORY",)).stdout == str(usual)


@pytest.mark.parametrize(("said", "megabytes"), [("4g", 4096), ("1500m", 1500), ("3G", 3072)])
def test_the_user_sets_another_bound_of_memory(said, megabytes):
    assert bound(64000, ROBOTUI_MEMORY=said).stdout == str(megabytes)


@pytest.mark.parametrize("said", ["much", "4", "-1g", "0m", "64m", "99g"])
def test_a_bound_of_memory_that_cannot_be_is_refused_in_a_sentence(said):
    refused = bound(64000, ROBOTUI_MEMORY=said)

    assert refused.returncode != 0
    assert f"{said}" in refused.stderr and "ROBOTUI_MEMORY" in refused.stderr


def test_it_runs_with_that_bound_and_the_log_says_so(product, state):
    for options, variables in ((("--memory", "300m"), {}), ((), {"ROBOTUI_MEMORY": "300m"})):
        run(product / "robotui", "run", "player", "--text", "--for", "2", *options, XDG_STATE_HOME=str(state), PLAYER_HOST="127.0.0.1",
            PLAYER_PORT="1", **variables)

    (log,) = state.glob("robotui/workspace-*/robotui.log")
    assert len(re.findall(r", 300 MB for Java", log.read_text(encoding="utf-8"))) == 2


# ---- what it keeps ------------------------------------------------------------------------------------------------------


def test_nobody_else_can_read_what_it_keeps_and_the_log_says_what_ran(product, state):
    run(product / "robotui", "run", "player", "--text", "--for", "2", XDG_STATE_HOME=str(state), PLAYER_HOST="127.0.0.1", PLAYER_PORT="1")

    (log,) = state.glob("robotui/workspace-*/robotui.log")
    assert stat.S_IMODE((state / "robotui").stat().st_mode) == 0o700
    assert stat.S_IMODE(log.stat().st_mode) == 0o600
    text = log.read_text(encoding="utf-8")
    assert re.search(r"RobotUI 0\.\d+\.\d+\S*, Java \d+", text), text
    assert "Linux" in text
    assert str(product / "configs/player.yaml") in text


# ---- features -----------------------------------------------------------------------------------------------------------


@pytest.fixture
def removable(tmp_path):
    if not (UPDATE_SITE / "p2.index").exists():
        pytest.skip("there is no update site: ./robotui package makes it")
    folder = tmp_path / "robotui"
    shutil.copytree(PRODUCTS["workbench"], folder, symlinks=True, ignore=shutil.ignore_patterns("classes.jsa"))
    return folder


def installed(product):
    """The bundles that its framework starts with."""
    return {line.split(",")[0] for line in (product / "configuration/org.eclipse.equinox.simpleconfigurator/bundles.info").read_text().splitlines()}


@needs_long                                                     # test_install.py removes and installs one in less time
def test_a_framework_is_taken_out_and_installed_again(removable, state):
    def director(*arguments):
        done = run(removable / "robotui", *DIRECTOR, *arguments, seconds=300, XDG_STATE_HOME=str(state))
        assert done.returncode == 0, done.stdout + done.stderr

    ours = {"org.robotui.ros", "org.robotui.rfic.ros"}
    assert ours <= installed(removable)

    director("-uninstallIU", ROS)
    assert not ours & installed(removable)
    without = run(removable / "robotui", "check", "ros", XDG_STATE_HOME=str(state))
    assert "type 'ros' is not installed" in without.stdout + without.stderr
    demo = run(removable / "robotui", "run", "demo", "--text", "--for", "2", XDG_STATE_HOME=str(state))
    assert demo.returncode == 1
    assert "RobotUI for ROS 1" in demo.stderr
    assert "\tat " not in demo.stderr

    director("-repository", UPDATE_SITE.as_uri(), "-installIU", ROS)
    assert ours <= installed(removable)
    assert run(removable / "robotui", "check", "ros", XDG_STATE_HOME=str(state)).returncode == 0
