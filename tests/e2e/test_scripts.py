"""Scripts of users in the headless product: by ./robotui run --script, and by the socket from Python."""
import pathlib
import re
import sys

import pytest

from conftest import start_robotui, wait_for

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/python"))
import robotui  # noqa: E402  (from the checkout)

DRIVE = """
waitForLink();
const before = value("base.odom").pose.translation;
try {
  drive(0.3, 0, 1);
} catch (e) {
  print("without control: " + e.message);
}
takeControl();
drive(0.3, 0, 1);
const now = waitUntil("base.odom", o => Math.hypot(o.pose.translation.x - before.x, o.pose.translation.y - before.y) > 0.1);
print("moved " + (now.pose.translation.x - before.x).toFixed(2));
print("views " + views().length + ", perspectives " + perspectives().length);
exit(7);
"""


def test_a_script_drives_waits_and_ends_the_product(simulator, tmp_path):
    script = tmp_path / "drive.js"
    script.write_text(DRIVE, encoding="utf-8")

    code, said, wrong = run_script(simulator, script)

    lines = said.splitlines()
    assert "without control: nobody has control of Robot; take control first" in lines, said + wrong
    assert [line for line in lines if re.fullmatch(r"moved -?\d\.\d\d", line)], said + wrong
    assert code == 7


def test_an_error_ends_it_with_file_and_line(simulator, tmp_path):
    script = tmp_path / "wrong.js"
    script.write_text("print('begun');\n\nvalue('base.nothing');\n", encoding="utf-8")

    code, said, wrong = run_script(simulator, script)

    assert code == 5
    assert said == "begun\n"
    assert "wrong.js:3: no stream base.nothing is offered now" in wrong


def run_script(robot, script):
    process = start_robotui(robot, "run", "--text", "ros", "--script", str(script), name=script.stem)
    process.wait(120)
    return process.returncode, process.out.read_text(), process.err.read_text()


def socket_of(process):
    """The socket that a RobotUI names where it was started."""
    return wait_for(lambda: next(iter(re.findall(r"scripts may come by (\S+)", process.err.read_text())), None),
                    what="the socket for scripts")


def test_python_does_the_same_by_the_socket(simulator):
    process = start_robotui(simulator, "run", "--json", "ros", "--script-socket", name="socket")
    path = socket_of(process)
    printed = []

    with robotui.connect(path, output=printed.append) as ui:
        ui.run("waitForLink()")
        start = ui.value("base.odom")["pose"]["translation"]
        ui.run("takeControl(); print(robots()[0].control)")
        assert printed == ["a program at the script socket"]
        ui.call("drive", 0.3, 0, 1)
        assert ui.wait("(o => Math.hypot(o.x - {x}, o.y - {y}) > 0.1)(value('base.odom').pose.translation)".format(**start))
        with pytest.raises(robotui.Error, match="python:1: it was stopped|has not ended within") as stopped:
            ui.run("while (true) sleep(0.1)", seconds=1)
        assert stopped.value.line == 1
        assert ui.run("1 + 2") == 3
    with robotui.connect(path) as ui:
        ui.run("waitFor(() => robots()[0].control === null)")
