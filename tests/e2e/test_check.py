"""Mistakes in a configuration that a robot would pay for: each is an error with its place and a remedy, and all are found at once."""
import os
import subprocess

from conftest import NO_DISPLAY, ROOT

# A line of the configuration; and for a mistake in it, the text that the error points to, and what is said of it.
LINES = [
    ("ruics:",),
    ("  Natalie:",),
    ("    type: mobilebase",),
    ("    rfics:",),
    ("      base: {type: ros, master: robot}", "robot}", "'master' must be the address of a master, such as http://robot:11311, not 'robot'"),
    ("      second: {type: ros, host: a b}", "a b", "'host' must be the name or address of a host, such as robot.local or 10.0.0.1, not 'a b'"),
    ("      third: {type: ros, topics: [scan, 'sc an']}", "'sc an'", "'topics' must be the name of a topic, in which * stands for any part"),
    ("      keira: {type: player, robot: Keira, port: 70000}", "70000", "'port' must be a whole number from 1 to 65535, not '70000'"),
    ("      carl: {type: player, robot: Carl, base: odometry}", "odometry", "'base' must be a device, such as position2d:0, not 'odometry'"),
    ("      lcm: {type: lcm, robot: Lars, types: /}", "/}", "'types'"),
    ("    uics:",),
    ("      map: {robot_radius: 1e308}", "1e308", "'robot_radius' must be a number from 0.01 to 20 in m, not '1e308'"),
    ("      tftree: {stale_after: .nan}", ".nan", "'stale_after' must be a number from 0.1 to 3600 in s, not '.nan'"),
    ("      plot:",),
    ("        window: -5", "-5", "'window' must be a number from 0 to 1000000 in s, not '-5'"),
    ("        axes:",),
    ("          - traces:",),
    ("              - {source: base.odom, path: linear..x}", "linear..x", "'path' must be the path of a field, such as linear.x or ranges[3]"),
    ("              - {source: odom, path: x}", "odom", "'source' must be a port of a component, such as base.odom, not 'odom'"),
    ("              - {source: base.odom, path: x, derive: average}", "average", "'derive' must be a function, such as derivative or average(0.5)"),
    ("              - 'base.odom'", "'base.odom'", "'traces' must be a signal, such as base.odom:linear.x, or a function of signals"),
    ("      sound:",),
    ("        alerts:",),
    ("          - {when: battery charge <}", "battery charge <", "'when' must be a condition"),
    ("          - {when: link lost, sound: ../../../etc/passwd}", "../../../etc/passwd", "'sound' must be beep, chime, alarm, or the path of a .wav file"),
    ("      scene3d:",),
    ("        displays:",),
    ("          - {type: robotmodel, settings: {file: /etc/passwd}}", "/etc/passwd", "display 'robotmodel': there is no setting 'file'"),
    ("          - {type: grid, settings: {cell: 1e308}}", "1e308", "display 'grid': cell is 1.0E308, must be a number from 0.001 to 100000 in m"),
    ("          - {type: grid, settings: {color: red}}", "red", "display 'grid': color is red, must be a colour, such as \"#f76b15\""),
    ("    layout:",),
    ("      row:",),
    ("        - {view: map, weight: -1}", "-1", "'weight' must be a number from 0.01 to 1000, not '-1'"),
    ("        - {tabs: [plot], weight: NaN}", "NaN", "'weight' must be a number from 0.01 to 1000, not 'NaN'"),
    ("    safety:",),
    ("      Natalie:",),
    ("        max_linear: 1e999", "1e999", "'max_linear' must be a number from 0 to 100 in m/s, not '1e999'"),
    ("        stop_call: {interface: bse, service: /stop}", "bse", "there is no robot interface 'bse', so the stop of 'Natalie' would not call it"),
    (r'  "Nata\e[31mlie\nb": {type: mobilebase, rfics: {base: ros}}', '"Nata', r"'Nata\u001b[31mlie\u000ab' has line breaks or other control characters"),
]


def robotui(*arguments, **variables):
    environment = {name: value for name, value in os.environ.items() if name not in NO_DISPLAY} | variables
    return subprocess.run([ROOT / "robotui", *map(str, arguments)], env=environment, stdin=subprocess.DEVNULL, text=True, capture_output=True,
                          timeout=120, check=False)


def test_every_mistake_is_an_error_with_its_place(tmp_path):
    file = tmp_path / "mistakes.yaml"
    file.write_text("".join(line[0] + "\n" for line in LINES), encoding="ascii")

    checked = robotui("check", file)

    assert checked.returncode == 1, checked.stdout + checked.stderr
    said = checked.stdout.splitlines()
    for number, (line, *mistake) in enumerate(LINES, start=1):
        if mistake:
            place = f"mistakes.yaml:{number}:{line.index(mistake[0]) + 1}: error: {mistake[1]}"
            assert any(place in text for text in said), f"{place}\nis not in\n{checked.stdout}"
    errors = [text for text in said if ": error: " in text]
    assert len(errors) == sum(len(line) > 1 for line in LINES), checked.stdout
    assert "\x1b[31m" not in checked.stdout + checked.stderr
    assert "Exception" not in checked.stdout + checked.stderr
