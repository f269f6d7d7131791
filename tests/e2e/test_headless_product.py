"""The headless product as a user gets it: started through ./robotui, without a display."""
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRODUCT = ROOT / "product/target/products/org.robotui.headless.product/linux/gtk/x86_64"


def robotui(*arguments, timeout=60):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([ROOT / "robotui", *arguments], env=environment, stdin=subprocess.DEVNULL, text=True,
                          capture_output=True, timeout=timeout, check=False)


def test_product_holds_no_swt_and_no_workbench():
    names = [jar.name.split("_")[0] for jar in (PRODUCT / "plugins").iterdir()]

    windows = [name for name in names if name.startswith(("org.eclipse.swt", "org.eclipse.jface", "org.eclipse.ui", "org.eclipse.e4"))]
    assert windows == []
    assert "org.robotui.headless" in names


def test_every_bundle_resolves_in_a_framework_that_holds_only_those():
    plugins = PRODUCT / "plugins"
    (framework,) = plugins.glob("org.eclipse.osgi_*.jar")

    unresolved = subprocess.run([pathlib.Path(os.environ["JAVA_HOME"]) / "bin/java", "-cp", framework,
                                 pathlib.Path(__file__).with_name("ResolveAll.java"), plugins],
                                text=True, capture_output=True, timeout=60, check=True).stdout
    assert unresolved == ""


def test_unknown_configuration_is_named_with_those_that_exist():
    result = robotui("check", "no-such-robot")

    assert result.returncode == 2
    assert "no configuration 'no-such-robot'" in result.stderr
    assert "configs/demo.yaml" in result.stderr


def test_without_a_display_run_says_so_and_goes_on_as_text():
    result = robotui("run", "--for", "3")

    assert "There is no display" in result.stderr
    assert "xvfb-run" in result.stderr
    assert "ROS_MASTER_URI=http://127.0.0.1:" in result.stderr
    assert result.returncode == 0, result.stderr


def test_a_screenshot_without_a_display_is_refused():
    result = robotui("run", "--screenshot", "/tmp/robotui.png")

    assert result.returncode == 2
    assert "a screenshot needs a display" in result.stderr
